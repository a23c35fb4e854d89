//! How late the agents of a search may arrive.

use super::Search;
use crate::{budget::Stop, encode::collisions::AgentId};

impl Search<'_, '_, '_> {
    /// The latest arrival of an agent that is still of interest.
    pub(crate) fn cap(&self, agent: AgentId) -> u32 {
        self.deadlines.cap(agent)
    }

    /// The latest arrival of any agent.
    pub(crate) const fn latest(&self) -> u32 {
        self.deadlines.latest()
    }

    /// Allows no plan in which an agent arrives later.
    pub(crate) fn lower_cap(&mut self, agent: AgentId, cap: u32) {
        if self.deadlines.lower(agent, cap) {
            self.harden_cap(agent);
        }
    }

    /// Allows no plan in which an agent arrives later, as only plans worse than the best
    /// one have that.
    pub(crate) fn lower_cap_by_best(&mut self, agent: AgentId, cap: u32) {
        if self.deadlines.lower_by_best(agent, cap) {
            self.harden_cap(agent);
        }
    }

    /// Makes the cap a clause, once the MDD reaches it.
    pub(super) fn harden_cap(&mut self, agent: AgentId) {
        if self.team.is_inside(agent)
            && let Some(cap) = self.deadlines.harden(agent, self.team.deadline(agent))
            && let Some(by) = self.team.by(agent, cap)
        {
            if self.deadlines.is_of_best(agent) {
                self.claim.has_excluded();
            }
            self.team.harden(by);
        }
    }

    /// Lets an inside agent arrive up to a time, or up to its cap.
    pub(crate) fn grow(&mut self, agent: AgentId, deadline: u32) -> Result<(), Stop> {
        self.team.grow(agent, deadline.min(self.cap(agent)))?;
        self.harden_cap(agent);
        Ok(())
    }

    /// Doubles the delay that an agent may have, up to a latest arrival; false
    /// where it may arrive so late already.
    pub(crate) fn grow_further(&mut self, agent: AgentId, latest: u32) -> Result<bool, Stop> {
        let covered = self.team.deadline(agent);
        let optimum = self.problem.optima[agent];
        let Some(next) = self.deadlines.next(agent, covered, optimum, latest) else {
            return Ok(false);
        };
        self.grow(agent, next)?;
        Ok(true)
    }
}
