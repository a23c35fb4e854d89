//! What each method cannot do: it is refused by name, not ignored.

use giveway_model::Cost;

use super::{Asked, Planner};
use crate::{
    AgentId,
    cbs::Aim,
    single::{Bounds, Task},
};

/// Something in an instance that a planner has no method for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Inability {
    /// This agent has a battery.
    Battery(AgentId),
    /// This agent has waypoints.
    Waypoints(AgentId),
    /// The map has slow zones.
    SlowZones,
    /// A question asks something of this agent beside its task.
    Demand(AgentId),
    /// The objective begins with this cost.
    Cost(Cost),
    /// The planner is not built yet.
    NotThereYet,
}

/// What a planner lacks for what is asked; nothing where it can do it.
pub(super) fn lacks(planner: Planner, asked: &Asked) -> Vec<Inability> {
    // Both walk through the time steps of all agents at once.
    let by_steps = matches!(planner, Planner::Pibt | Planner::Lacam);
    let problem = asked.problem;
    let mut lacks = Vec::new();
    if planner == Planner::Cbs
        && let Err(cost) = Aim::of(asked.objective)
    {
        lacks.push(Inability::Cost(cost));
    }
    let mut vertices = 0..problem.terrain.size() as u32;
    let is_slow = |v| problem.terrain.arcs(v).iter().any(|arc| arc.slow);
    if by_steps && vertices.any(is_slow) {
        lacks.push(Inability::SlowZones);
    }
    let first = |has: &dyn Fn(&Task) -> bool| problem.tasks.iter().position(has);
    if by_steps {
        let waypoints = first(&|task| !task.waypoints.is_empty());
        lacks.extend(waypoints.map(Inability::Waypoints));
        let battery = first(&|task| task.reserve.is_some());
        lacks.extend(battery.map(Inability::Battery));
    }
    lacks.extend(first(&is_asked_for_more).map(Inability::Demand));
    lacks
}

/// Whether a task is not that of an agent of an instance.
fn is_asked_for_more(task: &Task) -> bool {
    task.demand.is_some()
        || task.transit.is_some()
        || (task.not_before, task.held) != (0, 0)
        || !matches!(task.bounds, Bounds::Free)
}
