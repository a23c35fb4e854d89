//! The rules of the scene's own, in clauses: one function for each kind, from their table.
//!
//! | file | kinds |
//! |---|---|
//! | `zones` | capacity, closed, no-waiting |
//! | `ways` | one-way, depart, turns |
//! | `tasks` | sequence, visit, arrive |
//! | `between` | gap, apart, before |
//! | `penalty` | avoid, arrive with a weight |
//!
//! The formula is about plans in which all agents have arrived at its last time; what a rule
//! says of later times is said of the agents at rest.

mod between;
mod penalty;
mod tasks;
mod ways;
mod zones;

use std::collections::BTreeSet;

use giveway_model::constraint::{ConstraintKind, InForce};
use giveway_model::{Cell, Instance, Zone};

use super::agent::Walker;
use super::{Cnf, NoFormula};
use crate::Budget;

pub(super) use penalty::{limit, penalties};

/// Says that all rules in force are kept.
pub(super) fn require(
    cnf: &mut Cnf,
    instance: &Instance,
    walkers: &[Walker<'_>],
    budget: &Budget<'_>,
) -> Result<(), NoFormula> {
    for rule in instance.constraints_in_force() {
        let bound = walkers
            .iter()
            .filter(|walker| rule.agents.contains(&walker.index()));
        let writer = Writer {
            instance,
            rule: &rule,
            walkers: bound.collect(),
            limit: budget.clauses,
        };
        writer.require(cnf);
        super::check(cnf, budget)?;
    }
    Ok(())
}

/// Writes one rule.
struct Writer<'a> {
    instance: &'a Instance,
    rule: &'a InForce<'a>,
    /// The agents that it binds.
    walkers: Vec<&'a Walker<'a>>,
    /// The clauses at which it may end early, with too few of them.
    limit: usize,
}

impl Writer<'_> {
    fn require(&self, cnf: &mut Cnf) {
        match &self.rule.constraint.kind {
            ConstraintKind::Capacity { zone, most, times } => {
                self.capacity(cnf, &self.area(zone), *most, *times);
            }
            ConstraintKind::Closed { zone, times } => self.closed(cnf, &self.area(zone), *times),
            ConstraintKind::OneWay { lane } => self.one_way(cnf, lane),
            ConstraintKind::Gap { steps } => self.gap(cnf, *steps),
            ConstraintKind::Apart { distance, times } => self.apart(cnf, *distance, *times),
            ConstraintKind::Sequence { cells, .. } => self.sequence(cnf, cells),
            ConstraintKind::Visit { cell, stay, times } => self.visit(cnf, *cell, *stay, *times),
            ConstraintKind::Arrive { times } => self.arrive(cnf, *times),
            ConstraintKind::Depart { from } => self.depart(cnf, *from),
            ConstraintKind::Before { first, second } => self.before(cnf, first, second),
            ConstraintKind::NoWaiting { zone, most } => {
                self.no_waiting(cnf, &self.area(zone), *most);
            }
            ConstraintKind::Turns { quarter } => self.turns(cnf, *quarter),
            // They forbid nothing; what they cost is counted where a claim limits it.
            ConstraintKind::Late { .. } | ConstraintKind::Avoid { .. } => {}
        }
    }

    /// The number of the rule in the scene.
    const fn index(&self) -> usize {
        self.rule.index
    }

    /// The last time of the formula.
    fn last(&self) -> u32 {
        self.walkers.first().map_or(0, |walker| walker.last())
    }

    /// Whether there are more clauses than fit, so that the rest may be left out.
    fn is_full(&self, cnf: &Cnf) -> bool {
        cnf.clauses() > self.limit
    }

    /// The cells of a zone.
    fn area(&self, name: &str) -> BTreeSet<Cell> {
        area(self.instance, name)
    }
}

/// The cells of a zone.
fn area(instance: &Instance, name: &str) -> BTreeSet<Cell> {
    instance.zone(name).map(Zone::cell_set).unwrap_or_default()
}
