//! The calm plan by which delays are split: no agent has to let another one pass that drives
//! back and forth for nothing.

use giveway_model::{Cost, Objective, Plan};

use super::running::RunningPlan;
use crate::{
    calm::calm,
    problem::Problem,
    walk::{Walk, arrival, to_plan},
};

/// Agents whose walks could be calmer only if they arrived at another time keep their walks:
/// so many times this is tried again.
const ROUNDS: usize = 3;

/// A calm plan in which each agent arrives when it does in these walks, and its walks; `None`
/// where the plan is as calm as any that was found.
pub(super) fn calmed(
    running: &RunningPlan,
    problem: &Problem,
    walks: &[Walk],
) -> Option<(Plan, Vec<Walk>)> {
    let objective = with_sum(running.instance.objective());
    let mut may_change = vec![true; walks.len()];
    for _ in 0..ROUNDS {
        let calm = calm(problem, walks, &objective, |agent| may_change[agent]);
        if calm == walks {
            return None;
        }
        let moved = |agent: usize| arrival(&calm[agent]) != arrival(&walks[agent]);
        let moved: Vec<usize> = (0..walks.len()).filter(|&agent| moved(agent)).collect();
        if moved.is_empty() {
            let plan = to_plan(problem, &running.names(), &calm);
            let passes = running.check(&plan).is_empty() && problem.keeps(&calm);
            return passes.then_some((plan, calm));
        }
        for agent in moved {
            may_change[agent] = false;
        }
    }
    None
}

/// An objective that the sum of costs is one of, so that no agent arrives later.
pub(super) fn with_sum(objective: &Objective) -> Objective {
    objective.clone().with_last(Cost::SumOfCosts)
}
