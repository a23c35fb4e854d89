//! The latest arrivals that a search looks at.
//!
//! Each agent has a *cap*. A later arrival is of no interest, for one of two
//! reasons: the claim itself excludes it (a limit, a demand, a better plan), or
//! it lies beyond the horizon. Only what was shown without caps of the second
//! kind holds whatever the horizon, so they are never mixed up: whoever makes a
//! cap a clause does so here, and what entered the formula is remembered.

use super::horizon::Horizon;
use crate::{encode::collisions::AgentId, problem::Problem};

/// How the caps are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Keeping {
    /// As assumptions: cores tell whose they are.
    Assumed,
    /// As clauses, from when an MDD reaches them.
    Hard,
}

/// Why no later arrival is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum DeadlineReason {
    /// The claim excludes it at any horizon.
    Claim,
    /// So does the best plan: only worse ones arrive later.
    Best,
    /// It lies beyond the horizon.
    Horizon,
}

/// The latest arrival of one agent.
#[derive(Clone, Copy, Debug)]
struct Cap {
    latest: u32,
    reason: DeadlineReason,
    is_clause: bool,
}

/// The proof that no cap of the horizon had a part in a refutation. Only
/// [`Deadlines`] makes it, since it knows which caps became clauses, and why.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NoHorizon(());

/// The caps of all agents.
#[derive(Clone, Debug)]
pub(crate) struct Deadlines {
    latest: u32,
    keeping: Keeping,
    caps: Vec<Cap>,
    /// Whether a cap of the horizon became a clause.
    entered: bool,
}

impl Deadlines {
    /// Every agent has until the horizon, or as long as limits on the makespan
    /// and its own demand allow.
    pub(super) fn new(
        problem: &Problem,
        horizon: Horizon,
        makespan: Option<u32>,
        keeping: Keeping,
    ) -> Self {
        let limit = makespan.unwrap_or(u32::MAX);
        let cap = |agent| {
            let claimed = limit.min(problem.not_after(agent));
            let horizon_first = claimed > horizon.latest() && !horizon.is_beyond_use();
            Cap {
                latest: claimed.min(horizon.latest()),
                reason: if horizon_first {
                    DeadlineReason::Horizon
                } else {
                    DeadlineReason::Claim
                },
                is_clause: false,
            }
        };
        Self {
            latest: limit.min(horizon.latest()),
            keeping,
            caps: (0..problem.agents()).map(cap).collect(),
            entered: false,
        }
    }

    /// The latest arrival of any agent.
    pub(super) const fn latest(&self) -> u32 {
        self.latest
    }

    /// The latest arrival of an agent that is still of interest.
    pub(super) fn cap(&self, agent: AgentId) -> u32 {
        self.caps[agent].latest
    }

    /// The latest arrival of an agent that the claim does not exclude, whatever the horizon; `None`
    /// where it excludes none.
    pub(super) fn claimed(&self, agent: AgentId) -> Option<u32> {
        let cap = self.caps[agent];
        (cap.reason != DeadlineReason::Horizon).then_some(cap.latest)
    }

    /// The latest of all caps.
    pub(super) fn last_cap(&self) -> u32 {
        self.caps.iter().map(|cap| cap.latest).max().unwrap_or(0)
    }

    /// Excludes later arrivals of an agent, as what is claimed does; whether
    /// that is news.
    pub(super) fn lower(&mut self, agent: AgentId, latest: u32) -> bool {
        self.lower_for(agent, latest, DeadlineReason::Claim)
    }

    /// The same, as only plans worse than the best one have later arrivals.
    pub(super) fn lower_by_best(&mut self, agent: AgentId, latest: u32) -> bool {
        self.lower_for(agent, latest, DeadlineReason::Best)
    }

    fn lower_for(&mut self, agent: AgentId, latest: u32, reason: DeadlineReason) -> bool {
        let cap = &mut self.caps[agent];
        if latest >= cap.latest {
            return false;
        }
        *cap = Cap {
            latest,
            reason,
            is_clause: false,
        };
        true
    }

    /// The cap of an agent that is to become a clause now, its MDD covering
    /// arrivals up to `covered`.
    pub(super) fn harden(&mut self, agent: AgentId, covered: u32) -> Option<u32> {
        let cap = &mut self.caps[agent];
        if self.keeping == Keeping::Assumed || cap.is_clause || covered < cap.latest {
            return None;
        }
        cap.is_clause = true;
        self.entered |= cap.reason == DeadlineReason::Horizon;
        Some(cap.latest)
    }

    /// The deadline to assume of an agent whose MDD covers arrivals up to
    /// `covered`, where arrivals up to `until` matter; `None` where a clause
    /// says so already.
    pub(super) fn assumed(&self, agent: AgentId, covered: u32, until: u32) -> Option<u32> {
        let deadline = covered.min(until);
        let open = self.keeping == Keeping::Assumed || deadline < self.caps[agent].latest;
        open.then_some(deadline)
    }

    /// The deadline up to which an MDD grows next, with twice the delay, and
    /// not beyond `until`; `None` where it reaches so far already.
    pub(super) fn next(
        &self,
        agent: AgentId,
        covered: u32,
        optimum: u32,
        until: u32,
    ) -> Option<u32> {
        let until = until.min(self.caps[agent].latest);
        let delay = covered.saturating_sub(optimum).max(1);
        (covered < until).then(|| covered.saturating_add(delay).min(until))
    }

    /// The horizon, where a cap of it became a clause.
    pub(super) fn horizon_in_force(&self) -> Option<u32> {
        self.entered.then_some(self.latest)
    }

    /// Whether only plans worse than the best one are known to have later arrivals of
    /// an agent.
    pub(super) fn is_of_best(&self, agent: AgentId) -> bool {
        self.caps[agent].reason == DeadlineReason::Best
    }

    /// Whether a refutation under the caps of these agents, and of no others, did not use the
    /// horizon. Deadlines that were assumptions of the call must be named among them.
    pub(super) fn free_of_horizon(&self, agents: &[AgentId]) -> Option<NoHorizon> {
        let claimed = |&agent: &AgentId| self.caps[agent].reason != DeadlineReason::Horizon;
        let free = !self.entered && agents.iter().all(claimed);
        free.then_some(NoHorizon(()))
    }
}
