//! The calm plan that is shown in the place of the one that a search found.

use giveway_model::{Costs, Plan, check::check};
use giveway_planners::budget::Unlimited;

use crate::{
    calm::calm,
    lns::descend,
    problem::Problem,
    solve::{SolveTask, names, start},
    trace::{FoundBy, SearchEvent},
    walk::{Walk, to_plan},
};

/// States of single agents to look at before a plan that is not proved is made calm.
const DESCENT: u64 = 300_000;

/// The calm plan of walks, where the judge passes it; else the plan that was found. A plan
/// that was handed in stays as it is, and so do all where the request says so.
///
/// Where the costs are proved to be the best, the calm plan has the same ones in the
/// objective; else they may also be lower.
pub(crate) fn calmed(
    task: &SolveTask,
    problem: &Problem,
    walks: &[Walk],
    (plan, costs): (Plan, Costs),
    is_proved: bool,
) -> (Plan, Costs) {
    if task.as_found || start(task).is_some_and(|(start, _)| start.paths == plan.paths) {
        return (plan, costs);
    }
    let mut walks = walks.to_vec();
    if !is_proved {
        // The last plan of a search that was stopped may leave to one agent what it could gain
        // by itself.
        let unlimited = Unlimited::default();
        descend(problem, &mut walks, &task.objective, DESCENT, &unlimited);
    }
    let walks = calm(problem, &walks, &task.objective, |_| true);
    let calm = to_plan(problem, &names(task), &walks);
    let report = check(&task.instance, &calm);
    let passes = report.violations.is_empty() && problem.keeps(&walks);
    let Some(calm_costs) = report.costs.filter(|_| passes) else {
        return (plan, costs);
    };
    let (before, after) = (
        costs.vector(&task.objective),
        calm_costs.vector(&task.objective),
    );
    if after > before || is_proved && after < before {
        return (plan, costs);
    }
    if after < before {
        task.budget.record(|_| SearchEvent::Plan {
            costs: calm_costs,
            by: FoundBy::Lns,
        });
    }
    (calm, calm_costs)
}
