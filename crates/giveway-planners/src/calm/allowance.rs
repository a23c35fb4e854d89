//! The allowance of an agent's new walk: its costs may not exceed it.

use giveway_model::Cost;

use super::Plan;
use crate::{
    AgentId,
    walk::{arrival, costs_of},
};

/// Upper limits on a walk; `None` where a cost does not count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowance {
    /// The latest arrival.
    pub(super) latest: u32,
    pub(super) charges: Option<u32>,
    pub(super) moves: Option<u32>,
    pub(super) waits: Option<u32>,
}

impl Allowance {
    /// As much as the walk that an agent has, of each cost of the objective. The makespan
    /// is kept even where it is no cost.
    pub(super) fn new(plan: &Plan, agent: AgentId) -> Self {
        let walk = &plan.walks[agent];
        let own = costs_of(plan.problem, agent, walk);
        let counts = |cost| plan.objective.costs().contains(&cost);
        let limit = |cost| counts(cost).then(|| own.get(cost));
        Self {
            latest: if counts(Cost::SumOfCosts) {
                arrival(walk)
            } else {
                plan.makespan
            },
            charges: limit(Cost::Charges),
            moves: limit(Cost::Moves),
            // (What an agent stood before is part of every walk, and no wait of this one.)
            waits: limit(Cost::Waits).map(|waits| {
                waits.saturating_sub(plan.problem.tasks[agent].waits_if_it_leaves_goal)
            }),
        }
    }
}
