//! As few agents as can be do something else.
//!
//! By unsatisfiable cores over "does as before" (as in [`crate::search::sum`]); an
//! agent that no core names is not inside the SAT solver at all, but in everyone's
//! way where it was before.

use super::{Near, NoneCloser};
use crate::{
    budget::Stop,
    encode::{collisions::AgentId, totalizer::totalizer},
    sat::Lit,
    search::growing::{Growing, Until},
};

/// An agent that does as before, or does not.
#[derive(Clone, Copy, Debug)]
pub(super) enum SoftAgent {
    /// An agent that is not inside the SAT solver.
    Outside(AgentId),
    /// One that is.
    Inside,
    /// No more than this one of those that a core names.
    Total,
}

impl Near<'_, '_> {
    /// As few agents as can be do something else; `None` where there is no plan.
    pub(super) fn few_agents(&mut self) -> Result<Option<NoneCloser>, Stop> {
        loop {
            self.extend()?;
            let assumptions: Vec<Lit> = self.softs.keys().copied().collect();
            match self.search.solve_growing(assumptions, Until::EVER)? {
                Growing::Model if !self.cores.is_empty() => self.assume_totals(),
                Growing::Model => break,
                Growing::Grown(_) => {}
                Growing::Core(core) if core.lits().is_empty() => return Ok(None),
                Growing::Core(core) => self.add_core(core.lits())?,
            }
        }
        // Whoever does something else in any plan with so few has been named.
        for &lit in self.softs.keys() {
            self.search.team.harden(lit);
        }
        Ok(Some(NoneCloser(())))
    }

    /// One of those that a core names does something else.
    fn add_core(&mut self, core: &[Lit]) -> Result<(), Stop> {
        let mut violations = Vec::new();
        for lit in core {
            match self.softs.remove(lit) {
                Some(SoftAgent::Outside(agent)) => {
                    // From now on its place inside says where it is.
                    self.search.team.harden(!*lit);
                    if let Some(same) = self.enter(agent)? {
                        violations.push(!same);
                    }
                }
                Some(SoftAgent::Inside | SoftAgent::Total) => violations.push(!*lit),
                None => {}
            }
        }
        match violations.as_slice() {
            [one] => self.search.team.harden(*one),
            _ => self.cores.push(violations),
        }
        Ok(())
    }

    fn assume_totals(&mut self) {
        for violations in std::mem::take(&mut self.cores) {
            let outputs = totalizer(&violations, self.search.team.clauses());
            // One of them is paid for; every further one costs as much again.
            for &more in outputs.iter().skip(1) {
                self.softs.insert(!more, SoftAgent::Total);
            }
        }
    }
}
