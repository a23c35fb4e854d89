//! The horizon that a person set, which may lie before the time of a change: what
//! is past then cannot be any sooner.

use giveway_model::Cost;

use super::MethodAnswer;
use crate::{Reason, Status, search::Proved};

/// The answer with nothing claimed, and no plan, beyond a makespan.
pub(super) fn hold_to(within: Option<u32>, mut answer: MethodAnswer) -> MethodAnswer {
    let Some(within) = within else { return answer };
    let result = &mut answer.result;
    let ends = result.costs.map(|costs| costs.makespan);
    if ends.is_some_and(|ends| ends > within) {
        let bound = result.bounds.get(&Cost::Makespan);
        let proved = bound.is_some_and(|&bound| bound > within);
        result.status = if proved {
            Status::Impossible
        } else {
            Status::Unknown
        };
        result.reach = proved.then_some(Proved::Within(within)).into();
        result.reason = Some(Reason::PastTooLong);
        (result.plan, result.costs) = (None, None);
        for names in [
            &mut answer.kept,
            &mut answer.retimed,
            &mut answer.rerouted,
            &mut answer.added,
            &mut answer.freed,
        ] {
            names.clear();
        }
        (answer.cause, answer.fewest, answer.closest) = (None, false, false);
        answer.fewest_within = None;
        return answer;
    }
    // The search had no steps left at all: that shows nothing beyond what was asked.
    let capped = |shown: Option<u32>| shown.map(|shown| shown.min(within));
    result.reach = result.reach.up_to(within);
    answer.fewest_within = capped(answer.fewest_within);
    if let Some(cause) = &mut answer.cause {
        cause.within = capped(cause.within);
    }
    answer
}
