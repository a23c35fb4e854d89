//! The heading of an answer where no price and no way out is its verdict: what was found, as a
//! sentence.

use giveway_model::{Question, tr};
use giveway_solve::explain::{ExplainAnswer, Verdict};

use super::verdict::is_coming;

/// What an answer comes to, in a sentence.
pub(super) fn heading(told: &ExplainAnswer) -> String {
    if told.valid == Some(false) {
        let n = told.violations.as_ref().map_or(0, Vec::len);
        return tr!("The plan has {n} problem" | "The plan has {n} problems" % n);
    }
    match (&told.question, told.verdict) {
        (Question::Unsolvable, Verdict::Necessary) => match told.reach.within() {
            None if told.reach.is_complete() => {
                tr!("No plan exists, no matter how many steps you allow").to_owned()
            }
            None => tr!("No plan was found").to_owned(),
            Some(n) => tr!("No plan exists with a makespan of at most {n}", n),
        },
        (Question::Unsolvable, _) => tr!("It is not known whether there is a plan").to_owned(),
        (Question::Plan, Verdict::Needless) => tr!("No plan is better").to_owned(),
        (Question::Plan, Verdict::Unknown) => {
            tr!("It is not known whether there is a better plan").to_owned()
        }
        (_, Verdict::Improvable) => tr!("There is a better plan").to_owned(),
        (_, Verdict::Needless) => {
            tr!("Another plan that costs the same does without it").to_owned()
        }
        (_, Verdict::Costly) => tr!("It would cost more").to_owned(),
        (Question::Makespan, Verdict::Necessary) => {
            tr!("They cannot all be done sooner").to_owned()
        }
        (Question::SumOfCosts, Verdict::Necessary) => tr!("The sum cannot be less").to_owned(),
        (Question::Arrival { agent }, Verdict::Necessary) => {
            tr!("{agent} cannot arrive sooner", agent)
        }
        (_, Verdict::Necessary) => tr!("There is no other way").to_owned(),
        (_, Verdict::Unknown) if is_coming(told) => {
            tr!("Not decided yet: this is what the plan shows").to_owned()
        }
        (_, Verdict::Unknown) => tr!("It is not known whether it could be otherwise").to_owned(),
    }
}
