//! All best plans, as far as they are known: those that were found, and the formula
//! that has them all.

use std::collections::BTreeSet;

use giveway_model::{Costs, Instance, Objective, Plan, check::check};

use super::formula::{BestPlans, Way, plan_of};
use crate::{budget::Stop, problem::Problem, sat::Lit, single::Place};

/// All best plans.
pub(super) struct Every<'a, 'h> {
    pub(super) problem: &'a Problem,
    pub(super) instance: &'a Instance,
    pub(super) objective: &'a Objective,
    /// The costs that all of them have, of the costs that count.
    best: Vec<u32>,
    pub(super) formula: BestPlans<'h>,
    /// Best plans that were found, each passed by the judge; first the plan that is asked about.
    found: Vec<Vec<Way>>,
    known: BTreeSet<Vec<Way>>,
}

impl<'a, 'h> Every<'a, 'h> {
    /// Begins with the plan that is asked about.
    pub(super) fn new(
        problem: &'a Problem,
        instance: &'a Instance,
        (objective, best): (&'a Objective, &Costs),
        formula: BestPlans<'h>,
        plan: Vec<Way>,
    ) -> Self {
        Self {
            problem,
            instance,
            objective,
            best: best.vector(objective),
            formula,
            known: BTreeSet::from([plan.clone()]),
            found: vec![plan],
        }
    }

    /// The plan that is asked about.
    pub(super) fn own(&self) -> &[Way] {
        self.found.first().map_or(&[], Vec::as_slice)
    }

    /// The plans that were found, the own one first.
    pub(super) fn found(&self) -> &[Vec<Way>] {
        &self.found
    }

    /// The other plans that were found.
    pub(super) fn others(&self) -> &[Vec<Way>] {
        self.found.get(1..).unwrap_or_default()
    }

    /// Where an agent is at a time on a way: after its arrival at its goal where it
    /// stays, and nowhere where it vanishes.
    pub(super) fn place(&self, agent: usize, way: &Way, time: u32) -> Option<Place> {
        let task = &self.problem.tasks[agent];
        let end = || {
            task.end_of(&way.places)
                .filter(|_| self.problem.rests(agent))
        };
        way.at(time).or_else(end)
    }

    /// Ways as a plan.
    pub(super) fn plan(&self, ways: &[Way]) -> Plan {
        plan_of(self.problem, self.instance, ways)
    }

    /// Looks for a best plan under assumptions, and keeps it; whether there is one.
    /// No plan counts that the judge does not pass, or that is not as good as the
    /// best.
    ///
    /// # Errors
    /// When the budget is spent, or the judge contradicts the formula.
    pub(super) fn find(&mut self, assumptions: &[Lit]) -> Result<bool, Stop> {
        let Some(ways) = self.formula.find(assumptions)? else {
            return Ok(false);
        };
        if !self.known.contains(&ways) {
            if !self.passes(&ways) {
                return Err(Stop::Contradiction);
            }
            self.keep(ways);
        }
        Ok(true)
    }

    /// Keeps ways that may be a best plan, where they are one that was not known.
    pub(super) fn offer(&mut self, ways: Vec<Way>) {
        if !self.known.contains(&ways) && self.passes(&ways) {
            self.keep(ways);
        }
    }

    /// Whether the judge passes ways, and they are as good as the best plan.
    fn passes(&self, ways: &[Way]) -> bool {
        let report = check(self.instance, &self.plan(ways));
        let vector = report.costs.map(|costs| costs.vector(self.objective));
        report.violations.is_empty() && vector.as_ref() == Some(&self.best)
    }

    fn keep(&mut self, ways: Vec<Way>) {
        self.known.insert(ways.clone());
        self.found.push(ways);
    }

    /// Literals one of which fails in every other plan than this one.
    pub(super) fn marks(&self, plan: &[Way]) -> Vec<Lit> {
        let each = plan.iter().enumerate();
        each.flat_map(|(agent, way)| self.formula.marks(agent, way))
            .collect()
    }

    /// A literal under which the plan is another one than this.
    pub(super) fn other_than(&mut self, plan: &[Way]) -> Lit {
        let marks = self.marks(plan);
        self.formula.some(marks.into_iter().map(|lit| !lit))
    }
}
