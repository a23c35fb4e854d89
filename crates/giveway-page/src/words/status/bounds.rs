//! What is proved of each cost, in words: bounds while the solver works, and after.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Objective};

use crate::Solving;
use crate::words::costs::{name, value, values};

/// `Solving: makespan is at least 17, the best plan so far has 20.`
pub(super) fn solving(run: &Solving) -> String {
    let known = known(objective(run), &run.bounds, run.best.as_ref());
    if known.is_empty() {
        return match &run.best {
            Some(costs) => format!("Solving: a plan with {}.", values(objective(run), costs)),
            None => "Solving: no bound yet.".to_owned(),
        };
    }
    format!("Solving: {known}.")
}

fn objective(run: &Solving) -> &Objective {
    let asked = run.request.objective.as_ref();
    asked.unwrap_or(&run.request.scene.objective)
}

/// What is proved of each cost in turn: `makespan is 18; sum of costs is at
/// least 33, the best plan so far has 35`.
pub(super) fn known(
    objective: &Objective,
    bounds: &BTreeMap<Cost, u32>,
    best: Option<&Costs>,
) -> String {
    let parts = objective.costs().iter().filter_map(|&cost| {
        let at_least = *bounds.get(&cost)?;
        let name = name(cost);
        Some(match best.map(|costs| costs.get(cost)) {
            Some(best) if best == at_least => format!("{name} is {best}"),
            Some(best) if best > at_least => {
                format!("{name} is at least {at_least}, the best plan so far has {best}")
            }
            _ => format!("{name} is at least {at_least}"),
        })
    });
    parts.collect::<Vec<_>>().join("; ")
}

/// `makespan 20, proved at least 17; 3 charges`.
pub(super) fn with_bounds(
    objective: &Objective,
    costs: &Costs,
    bounds: &BTreeMap<Cost, u32>,
) -> String {
    let parts = objective.costs().iter().map(|&cost| {
        let n = costs.get(cost);
        let said = value(cost, n);
        match bounds.get(&cost) {
            None => said,
            Some(&bound) if bound >= n => format!("{said}, proved"),
            Some(&bound) => format!("{said}, at least {bound}"),
        }
    });
    parts.collect::<Vec<_>>().join("; ")
}
