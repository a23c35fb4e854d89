//! Calls under assumptions, in which MDDs grow.
//!
//! Every stage does the same: it assumes what it would like to hold, and the
//! deadlines of all MDDs; a core that names deadlines is no proof yet, but
//! tells whose MDDs must grow. So this is the one place that tells a core
//! that proves something from one that does not.

use std::collections::BTreeMap;

use super::stage::Search;
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    sat::{Core, Lit, Outcome},
};

/// Which deadlines are assumed beside what is assumed anyway.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Until {
    /// The nodes of all MDDs that matter for arrivals up to this time.
    Time(u32),
    /// None: the assumptions guard the MDDs themselves.
    Guarded,
}

impl Until {
    /// All nodes of all MDDs.
    pub(crate) const EVER: Self = Self::Time(u32::MAX);
}

/// The result of a call under assumptions.
#[derive(Clone, Debug)]
pub(crate) enum Growing {
    /// There is a model.
    Model,
    /// There is none yet: MDDs have grown, by a core of so many literals.
    Grown(usize),
    /// There is none, however late the deadlines are that can still grow.
    Core(AssumptionCore),
}

/// Assumptions that exclude each other.
#[derive(Clone, Debug)]
pub(crate) struct AssumptionCore {
    lits: Core,
    agents: Vec<AgentId>,
    effort: CoreEffort,
}

/// The effort for a core.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CoreEffort {
    /// Its literals before it was verified and made smaller.
    pub(crate) stated: usize,
    /// Its literals in the end.
    pub(crate) literals: usize,
    /// Conflicts.
    pub(crate) conflicts: u64,
}

/// Only [`Search::solve_growing`] makes one, so that a core is a proof.
impl AssumptionCore {
    /// The assumptions; none where nothing has to be assumed.
    pub(crate) fn lits(&self) -> &Core {
        &self.lits
    }

    /// The agents whose deadlines are among them.
    pub(crate) fn agents(&self) -> &[AgentId] {
        &self.agents
    }

    /// The effort for it.
    pub(crate) const fn effort(&self) -> CoreEffort {
        self.effort
    }
}

impl Search<'_, '_, '_> {
    /// The guards of the MDDs, as far as arrivals up to `until` matter:
    /// under these literals the clauses are as they would be if nothing were
    /// left out.
    fn guards(&mut self, until: u32) -> BTreeMap<Lit, AgentId> {
        let mut guards = BTreeMap::new();
        for agent in self.team.insiders() {
            let covered = self.team.deadline(agent);
            if let Some(deadline) = self.deadlines.assumed(agent, covered, until)
                && let Some(by) = self.team.by(agent, deadline)
            {
                guards.insert(by, agent);
            }
        }
        guards
    }

    /// Solves under assumptions, and under the deadlines of all MDDs, as
    /// far as arrivals up to `until` matter. Where a core names deadlines that
    /// can be later, its agents' MDDs grow; otherwise it is told.
    pub(crate) fn solve_growing(
        &mut self,
        assumptions: Vec<Lit>,
        until: Until,
    ) -> Result<Growing, Stop> {
        let mut guards = match until {
            Until::Guarded => BTreeMap::new(),
            Until::Time(until) => self.guards(until),
        };
        for lit in &assumptions {
            guards.remove(lit);
        }
        let mut assumptions = assumptions;
        assumptions.extend(guards.keys());
        let before = self.budget.conflicts();
        let Outcome::Unsat(mut core) = self.team.solve(&assumptions)? else {
            return Ok(Growing::Model);
        };
        let stated = self.team.stated();
        if self.claim.minimises_cores() {
            core = self.team.minimise(core)?;
        }
        let agents: Vec<AgentId> = core
            .iter()
            .filter_map(|lit| guards.get(lit).copied())
            .collect();
        let mut grown = false;
        for &agent in &agents {
            let latest = match until {
                Until::Guarded => u32::MAX,
                Until::Time(until) => until,
            };
            grown |= self.grow_further(agent, latest)?;
        }
        if grown {
            return Ok(Growing::Grown(core.len()));
        }
        let effort = CoreEffort {
            stated,
            literals: core.len(),
            conflicts: self.budget.conflicts() - before,
        };
        Ok(Growing::Core(AssumptionCore {
            lits: core,
            agents,
            effort,
        }))
    }
}
