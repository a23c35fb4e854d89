//! The five costs of a plan.

use super::steps::{Step, steps};
use super::walk::Walk;
use crate::{Costs, Instance, Plan};

/// The five costs of a plan, broken or not; `None` where an agent has no path.
///
/// Trailing repeats of a goal are cut first. Where the plan is broken, every
/// charge listed and every change of cell counts.
///
/// ```
/// use giveway_model::{check::costs, format::native};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": [".~~."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] }]
/// }"#).unwrap();
/// let plan = native::read_plan(r#"{
///     "giveway": 1,
///     "paths": { "A1": [[0, 0], [0, 0], [1, 0], null, [2, 0], [3, 0]] }
/// }"#).unwrap();
/// let costs = costs(&instance, &plan).unwrap();
/// assert_eq!((costs.makespan, costs.moves, costs.waits), (5, 3, 1));
/// ```
pub fn costs(instance: &Instance, plan: &Plan) -> Option<Costs> {
    let walks = Walk::all(instance, plan);
    if walks.len() < instance.agents().len() {
        return None;
    }
    let mut costs = Costs::default();
    for walk in &walks {
        let arrival = walk.arrival() as u32;
        costs.makespan = costs.makespan.max(arrival);
        costs.sum_of_costs = costs.sum_of_costs.saturating_add(arrival);
        costs.charges = costs.charges.saturating_add(walk.charges.len() as u32);
        for (_, step) in steps(instance.grid(), walk.path) {
            let counter = match step {
                Step::Wait => &mut costs.waits,
                Step::Move { .. } | Step::SlowMove { .. } | Step::Broken { .. } => &mut costs.moves,
            };
            *counter = counter.saturating_add(1);
        }
    }
    Some(costs)
}

/// The arrival of each agent, in the order of the instance; `None` for one
/// without a path.
pub fn arrivals(instance: &Instance, plan: &Plan) -> Vec<Option<u32>> {
    (0..instance.agents().len())
        .map(|agent| Walk::of(instance, agent, plan).map(|walk| walk.arrival() as u32))
        .collect()
}
