//! The limits of each method: it refuses an instance by the name of the part that it cannot handle.

use giveway_model::Cost;

use super::Planner;
use crate::{
    AgentId,
    plain::{Plain, Unsupported},
    problem::Problem,
    single::{Bounds, Task},
};

/// Something in an instance that a planner has no method for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Inability {
    /// This agent has no goal.
    NoGoal(AgentId),
    /// This agent has a battery.
    Battery(AgentId),
    /// This agent has waypoints.
    Waypoints(AgentId),
    /// The map has slow zones.
    SlowZones,
    /// These two have one goal.
    SharedGoal(AgentId, AgentId),
    /// A question asks something of this agent beside its task.
    Condition(AgentId),
    /// A question leaves out rules between agents.
    Relaxed,
    /// The scene has rules of its own that the planner does not keep.
    Rules,
    /// The objective begins with this cost.
    Cost(Cost),
}

impl From<Unsupported> for Inability {
    fn from(unsupported: Unsupported) -> Self {
        match unsupported {
            Unsupported::NoGoal(agent) => Self::NoGoal(agent),
            Unsupported::Waypoints(agent) => Self::Waypoints(agent),
            Unsupported::Battery(agent) => Self::Battery(agent),
            Unsupported::Condition(agent)
            | Unsupported::Bounds(agent)
            | Unsupported::UnderWay(agent) => Self::Condition(agent),
            Unsupported::SharedGoal(a, b) => Self::SharedGoal(a, b),
            Unsupported::SlowZones => Self::SlowZones,
            Unsupported::Relaxed => Self::Relaxed,
            Unsupported::Rules => Self::Rules,
        }
    }
}

/// The part of the instance that a planner cannot handle, if any; CBS itself names the costs that it can
/// minimise.
pub(super) fn lack(planner: Planner, problem: &Problem) -> Option<Inability> {
    match planner {
        Planner::Pibt | Planner::Lacam => Plain::new(problem).err().map(Inability::from),
        Planner::Prioritised | Planner::Cbs | Planner::Lns => {
            let mut tasks = problem.tasks.iter();
            let no_goal = tasks.position(|task| task.goal.is_none());
            // Its split of a conflict at a goal needs to know the goal.
            if let (Planner::Cbs, Some(agent)) = (planner, no_goal) {
                return Some(Inability::NoGoal(agent));
            }
            // A node of its tree constrains single agents.
            if planner == Planner::Cbs && problem.has_rules_between() {
                return Some(Inability::Rules);
            }
            let keeps = if problem.is_constrained {
                is_asked_what_no_search_keeps
            } else {
                is_asked_for_more
            };
            problem
                .tasks
                .iter()
                .position(keeps)
                .map(Inability::Condition)
        }
    }
}

/// Whether a task is not that of an agent of an instance.
fn is_asked_for_more(task: &Task) -> bool {
    !task.conditions.is_empty()
        || !task.not_resting.is_empty()
        || task.transit.is_some()
        || (task.not_before, task.earliest_move) != (0, 0)
        || !matches!(task.bounds, Bounds::Free)
}

/// Whether a task has what searches of one agent keep by chance only.
fn is_asked_what_no_search_keeps(task: &Task) -> bool {
    task.conditions.needs_solver() || task.transit.is_some() || !matches!(task.bounds, Bounds::Free)
}
