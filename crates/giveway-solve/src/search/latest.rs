//! The latest arrivals that a proof leaves to the agents.
//!
//! Where the least sum of costs is proved by cores, each plan that has it keeps every level
//! that no core names (hardening; Ansótegui, Bonet and Levy 2013). So an agent arrives by its
//! cap in every best plan, and a later search for plans of the same costs needs no larger MDDs.

use borsh::{BorshDeserialize, BorshSerialize};

use super::{bound::Optimum, for_ever::Proved, horizon::Horizon, stage::Search};
use crate::{encode::collisions::AgentId, problem::Problem};

/// The latest arrival of each agent, in time steps and in the order of the scene, in any plan that
/// is as good as the best one, whatever its makespan.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub(crate) struct LatestArrivals(Vec<u32>);

/// The proof that an agent needs longer, even alone, than any plan of the best costs leaves it.
/// Only [`LatestArrivals`] makes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TooLateAlone(());

impl LatestArrivals {
    /// What the search leaves that has just proved the least sum of costs. Nothing where agents
    /// vanish, since its clauses leave out plans in which one leaves its goal again; and where it
    /// holds up to the horizon alone.
    pub(super) fn left_by(search: &Search, sum: Optimum, horizon: Horizon) -> Option<Self> {
        let problem = search.problem;
        let mut agents = 0..problem.agents();
        let in_time = horizon.covers(problem, sum.cost(), sum.least()).is_some();
        let holds = in_time || search.deadlines.free_of_horizon(&[]).is_some();
        let is_exact = agents.clone().all(|agent| problem.rests(agent));
        let claimed = |agent| search.deadlines.claimed(agent).unwrap_or(u32::MAX);
        (holds && is_exact).then(|| Self(agents.by_ref().map(claimed).collect()))
    }

    /// The latest arrival of an agent.
    pub(crate) fn of(&self, agent: AgentId) -> u32 {
        self.0.get(agent).copied().unwrap_or(u32::MAX)
    }

    /// The proof that no plan of the best costs meets the conditions of a problem, where an agent
    /// cannot meet them in time even alone.
    pub(crate) fn refute(&self, problem: &Problem) -> Option<Proved> {
        let mut agents = 0..problem.agents();
        let is_late = agents.any(|agent| problem.optima[agent] > self.of(agent));
        is_late.then(|| Proved::no_plan(TooLateAlone(())))
    }
}
