//! What is proved of each cost, in words, while the solver works.

use giveway_model::{Objective, tr};
use giveway_solve::words::known;

use crate::Solving;
use crate::words::costs::values;

/// `makespan is at least 17, the best plan so far has 20.`
pub(super) fn solving(run: &Solving) -> String {
    let known = known(objective(run), &run.bounds, run.best.as_ref());
    if known.is_empty() {
        return match &run.best {
            Some(costs) => tr!(
                "a plan with {costs}.",
                costs = values(objective(run), costs)
            ),
            None if run.planner.is_some() => tr!("no plan yet.").to_owned(),
            None => tr!("no bound yet.").to_owned(),
        };
    }
    format!("{known}.")
}

fn objective(run: &Solving) -> &Objective {
    let asked = run.request.objective.as_ref();
    asked.unwrap_or(&run.request.scene.objective)
}
