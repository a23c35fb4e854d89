//! As few agents as can be do something else.
//!
//! By core-guided search ([`oll`](crate::search::oll)) over "does as before". An agent that
//! no core names is not inside the SAT solver at all, but in everyone's way where it was
//! before.

use super::{Near, NoneCloser};
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    sat::{Lit, Sat},
    search::{
        growing::{AssumptionCore, Growing, Until},
        oll::{Formula, Kept, Level, Oll},
    },
};

/// The soft constraint that an agent does as in the given plan.
#[derive(Clone, Copy, Debug)]
pub(super) enum AsBefore {
    /// An agent that is not inside the SAT solver.
    Outside(AgentId, Lit),
    /// One that is.
    Inside(Lit),
}

impl Level for AsBefore {
    /// It has one level: an agent that does anything else is not measured further.
    fn raised(self, _: u32) -> Option<Self> {
        None
    }
}

impl<'h> Formula for Near<'_, 'h> {
    type Out = Sat<'h>;

    fn clauses(&mut self) -> &mut Sat<'h> {
        self.search.team.clauses()
    }
}

impl Kept<Near<'_, '_>> for AsBefore {
    fn literal(self, _: &mut Near) -> Result<Option<Lit>, Stop> {
        let (Self::Outside(_, same) | Self::Inside(same)) = self;
        Ok(Some(same))
    }

    fn violation(self, kept: Lit, near: &mut Near) -> Result<Option<Lit>, Stop> {
        match self {
            Self::Outside(agent, _) => {
                // From now on its place inside says where it is.
                near.search.team.harden(!kept);
                Ok(near.enter(agent)?.map(|same| !same))
            }
            Self::Inside(_) => Ok(Some(!kept)),
        }
    }
}

impl Near<'_, '_> {
    /// As few agents as can be do something else; the refutation where there is no plan.
    pub(super) fn few_agents(
        &mut self,
        mut oll: Oll<AsBefore>,
    ) -> Result<Result<NoneCloser, AssumptionCore>, Stop> {
        loop {
            self.extend()?;
            let assumptions = oll.assumptions(false);
            match self.search.solve_growing(assumptions, Until::EVER)? {
                Growing::Model if oll.is_waiting() => {
                    oll.begin_round(self)?;
                }
                Growing::Model => break,
                Growing::Grown(_) => {}
                Growing::Core(core) if core.lits().is_empty() => return Ok(Err(core)),
                Growing::Core(core) => oll.add_core(self, core.lits())?,
            }
        }
        // Agents that change in every plan with so few changes have been named.
        oll.harden(self);
        Ok(Ok(NoneCloser(())))
    }
}
