//! As few agents as can be do something else.
//!
//! By unsatisfiable cores over "does as before" (as in [`crate::search::sum`]); an
//! agent that no core names is not inside the SAT solver at all, but in everyone's
//! way where it was before.

use super::Near;
use crate::{
    encode::{collisions::AgentId, totalizer::totalizer},
    meter::Stop,
    sat::{Lit, Outcome},
};

/// An agent that does as before, or does not.
#[derive(Clone, Copy, Debug)]
pub(super) enum Soft {
    /// An agent that is not inside the SAT solver.
    Outside(AgentId),
    /// One that is.
    Inside,
    /// No more than this one of those that a core names.
    Total,
}

impl Near<'_, '_> {
    /// As few agents as can be do something else; false where there is no plan.
    pub(super) fn few_agents(&mut self) -> Result<bool, Stop> {
        loop {
            self.extend()?;
            let guards = self.search.guards();
            let mut assumptions: Vec<Lit> = self.softs.keys().copied().collect();
            assumptions.extend(guards.keys());
            match self.search.team.solve(&assumptions)? {
                Outcome::Sat if !self.cores.is_empty() => self.assume_totals(),
                Outcome::Sat => break,
                Outcome::Unsat(core) => {
                    let mut grown = false;
                    for lit in &core {
                        if let Some(&agent) = guards.get(lit) {
                            grown |= self.search.grow_further(agent, u32::MAX)?;
                        }
                    }
                    if !grown {
                        self.learn(&core)?;
                        if core.is_empty() {
                            return Ok(false);
                        }
                    }
                }
            }
        }
        // Whoever does something else in any plan with so few has been named.
        for &lit in self.softs.keys() {
            self.search.team.harden(lit);
        }
        Ok(true)
    }

    /// One of those that a core names does something else.
    fn learn(&mut self, core: &[Lit]) -> Result<(), Stop> {
        let mut violations = Vec::new();
        for lit in core {
            match self.softs.remove(lit) {
                Some(Soft::Outside(agent)) => {
                    // From now on its place inside says where it is.
                    self.search.team.harden(!*lit);
                    if let Some(same) = self.enter(agent)? {
                        violations.push(!same);
                    }
                }
                Some(Soft::Inside | Soft::Total) => violations.push(!*lit),
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
                self.softs.insert(!more, Soft::Total);
            }
        }
    }
}
