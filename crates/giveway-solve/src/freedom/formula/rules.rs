//! Rules between agents, among those of the formula.
//!
//! After the latest arrival every agent is at rest where it is in the best plan that is
//! known, or gone, so that later times need no clauses.

use super::BestPlans;
use crate::{
    budget::{Budget, Stop},
    encode::rules::RuleClauses,
    impose::Precedence,
    problem::Problem,
    sat::{Clauses, Lit},
    single::Place,
};

impl BestPlans<'_> {
    /// Writes zones with a limit, gaps, distances and precedences.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn keep_rules(&mut self, problem: &Problem, budget: &Budget) -> Result<(), Stop> {
        for &precedence in &problem.precedences {
            budget.check()?;
            self.precede(precedence);
        }
        if problem.between.is_empty() {
            return Ok(());
        }
        let mut rules = RuleClauses::default();
        let world = (&problem.between, &problem.terrain);
        for time in 0..=self.latest {
            budget.check()?;
            for (agent, code) in self.agents.iter().enumerate() {
                for (place, lit) in code.places_at(time) {
                    rules.occupy(world, (time, place), (agent, lit), &mut self.sat)?;
                }
            }
        }
        Ok(())
    }

    /// The second agent is at its vertex only after the first has been at its own.
    fn precede(&mut self, Precedence { first, second, .. }: Precedence) {
        let Self {
            sat,
            agents,
            latest,
        } = self;
        let (Some(one), Some(other)) = (agents.get(first.0), agents.get(second.0)) else {
            return;
        };
        // The first has been there before a time.
        let mut been: Option<Lit> = None;
        for time in 0..=*latest {
            if let Some(there) = other.at(time, Place::At(second.1)) {
                let clause = [Some(!there), been];
                sat.clause(&clause.into_iter().flatten().collect::<Vec<Lit>>());
            }
            let here = one.at(time, Place::At(first.1));
            if let Some(here) = here {
                let by_now = sat.fresh();
                let clause = [Some(!by_now), been, Some(here)];
                sat.clause(&clause.into_iter().flatten().collect::<Vec<Lit>>());
                been = Some(by_now);
            }
        }
    }
}
