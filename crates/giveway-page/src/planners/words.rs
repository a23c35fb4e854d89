//! What planners promise, and what is said of their plans.

use giveway_model::words::{name, sentence as ended, values};
use giveway_solve::Status;
use giveway_solve::plan::Planner;
use giveway_solve::words::FOR_EVER;

use crate::Answer;

/// The search for the best plan, in the menu.
pub const BEST: &str = "Best plan, proved";
/// What it promises.
pub const BEST_PROMISE: &str = "Searches until no plan can be better.";

/// What a planner promises, in a line.
pub const fn promise(planner: Planner) -> &'static str {
    match planner {
        Planner::Prioritised => "One robot after the other. Fast; may find no plan.",
        Planner::Cbs => "Proves the smallest makespan or sum of costs.",
        Planner::Pibt => "All robots, step by step. Very fast; may get stuck.",
        Planner::Lacam => "Hundreds of robots at once, then better plans.",
        Planner::Lns => "Improves a plan, a few robots at a time.",
    }
}

/// A plan of a planner, in the status: `PIBT found a plan: makespan 4.` and what is
/// known of it.
pub(crate) fn sentence(planner: Planner, answer: &Answer) -> String {
    let objective = &answer.draft.scene().objective;
    let costs = answer.solved.costs.unwrap_or_default();
    let costs = values(objective.costs(), &costs);
    let title = planner.title();
    if answer.solved.status == Status::Optimal {
        return format!("{title} found the best plan: {costs}.");
    }
    let known = match (smallest(answer), &answer.solved.reason) {
        (Some(cost), _) => format!("No plan has a smaller {cost}."),
        (None, Some(reason)) => ended(reason),
        (None, None) => MAY_BE_BETTER.to_owned(),
    };
    format!("{title} found a plan: {costs}. {known}")
}

const MAY_BE_BETTER: &str = "There may be better plans.";

/// What is claimed of such a plan where it is not best in every cost.
pub(crate) fn claim(answer: &Answer) -> String {
    match smallest(answer) {
        Some(cost) => format!("No plan has a smaller {cost}, {FOR_EVER}."),
        None => MAY_BE_BETTER.to_owned(),
    }
}

/// The first cost, where it is proved that no plan has less.
fn smallest(answer: &Answer) -> Option<&'static str> {
    let &first = answer.draft.scene().objective.costs().first()?;
    let at_least = *answer.solved.bounds.get(&first)?;
    (answer.solved.costs?.get(first) <= at_least).then(|| name(first))
}
