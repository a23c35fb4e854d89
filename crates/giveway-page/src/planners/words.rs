//! What planners promise, and what is said of their plans.

use giveway_model::words::Later;
use giveway_model::words::{name, sentence as ended, values};
use giveway_model::{tr, tr_later};
use giveway_solve::Status;
use giveway_solve::plan::Planner;

use crate::Answer;

/// The search for the best plan, in the menu.
pub const BEST: Later = tr_later!("Best plan, proved");
/// What it promises.
pub const BEST_PROMISE: Later = tr_later!("Searches until no plan can be better.");

/// What a planner promises, in a line.
pub fn promise(planner: Planner) -> &'static str {
    match planner {
        Planner::Prioritised => tr!("One robot after the other. Fast; may find no plan."),
        Planner::Cbs => tr!("Proves the smallest makespan or sum of costs."),
        Planner::Pibt => tr!("All robots, step by step. Very fast; may get stuck."),
        Planner::Lacam => tr!("Hundreds of robots at once, then better plans."),
        Planner::Lns => tr!("Improves a plan, a few robots at a time."),
    }
}

/// A plan of a planner, in the status: `PIBT found a plan: makespan 4.` and what is
/// known of it, or of all plans of the scene: `least`, the proved bound of the first cost.
pub(crate) fn sentence(planner: Planner, answer: &Answer, least: Option<u32>) -> String {
    let objective = &answer.draft.scene().objective;
    let costs = answer.solved.costs.unwrap_or_default();
    let costs = values(objective.costs(), &costs);
    let title = planner.title();
    if answer.solved.status == Status::Optimal {
        return tr!("{title} found the best plan: {costs}.", title, costs);
    }
    let proved = objective.costs().first().zip(least);
    let known = match (smallest(answer), &answer.solved.reason, proved) {
        (Some(cost), ..) => tr!("No plan has a smaller {cost}.", cost),
        (None, Some(given), _) => ended(&giveway_solve::words::reason(given)),
        (None, None, Some((&first, least))) => tr!(
            "Proved: no plan has a {cost} under {least}.",
            cost = name(first),
            least
        ),
        (None, None, None) => MAY_BE_BETTER.text().to_owned(),
    };
    tr!(
        "{title} found a plan: {costs}. {known}",
        title,
        costs,
        known
    )
}

const MAY_BE_BETTER: Later = tr_later!("There may be better plans.");

/// What is claimed of such a plan where it is not best in every cost.
pub(crate) fn claim(answer: &Answer) -> String {
    match smallest(answer) {
        Some(cost) => tr!(
            "No plan has a smaller {cost}, no matter how many steps you allow.",
            cost
        ),
        None => MAY_BE_BETTER.text().to_owned(),
    }
}

/// The first cost, where it is proved that no plan has less.
fn smallest(answer: &Answer) -> Option<&'static str> {
    let &first = answer.draft.scene().objective.costs().first()?;
    let at_least = *answer.solved.bounds.get(&first)?;
    (answer.solved.costs?.get(first) <= at_least).then(|| name(first))
}
