//! The five costs of a plan.

use super::constraints;
use super::steps::{Step, steps};
use super::walk::Walk;
use crate::{Cost, Costs, Instance, Plan};

/// The costs of a plan, broken or not; `None` where an agent has no path.
///
/// They count from time 0. An agent that had been at its goal before and goes on is the
/// exception: then these steps count in the sum of costs, and those that it did not
/// sleep through are waits.
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
    (walks.len() == instance.agents().len()).then(|| of_walks(instance, &walks))
}

/// The costs of one agent in a plan; its makespan is its arrival. `None` where it has
/// no path.
pub fn own_costs(instance: &Instance, name: &str, plan: &Plan) -> Option<Costs> {
    let walk = Walk::named(instance, name, plan)?;
    Some(of_walks(instance, &[walk]))
}

/// A cost of a plan: of one agent, or of all of them.
pub fn cost_of(instance: &Instance, plan: &Plan, agent: Option<&str>, cost: Cost) -> Option<u32> {
    let costs = match agent {
        Some(name) => own_costs(instance, name, plan),
        None => costs(instance, plan),
    };
    Some(costs?.get(cost))
}

fn of_walks(instance: &Instance, walks: &[Walk<'_>]) -> Costs {
    let mut costs = Costs::default();
    for walk in walks {
        let arrival = walk.arrival() as u32;
        if arrival > 0 {
            let start = instance.start_state(&walk.agent.name);
            costs.sum_of_costs = costs.sum_of_costs.saturating_add(start.rested);
            costs.waits = costs.waits.saturating_add(start.rested_awake);
        }
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
    costs.penalty = constraints::penalty(instance, walks);
    costs
}

/// The arrival of each agent, in the order of the instance; `None` for one
/// without a path.
pub fn arrivals(instance: &Instance, plan: &Plan) -> Vec<Option<u32>> {
    (0..instance.agents().len())
        .map(|agent| Walk::of(instance, agent, plan).map(|walk| walk.arrival() as u32))
        .collect()
}
