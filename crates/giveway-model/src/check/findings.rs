//! The violations found so far, and their order.

use super::{BrokenConstraint, MAX_VIOLATIONS, Rule, Violation, sentence};
use crate::constraint::InForce;
use crate::sorting::sort_by;
use crate::{Cell, Instance};

/// Where a violation lies.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    /// At no cell.
    Nowhere,
    /// At a cell.
    Cell(Cell),
    /// On an edge, from and to.
    Edge(Cell, Cell),
}

/// Collects violations; agents are indices of the instance here.
pub(super) struct Findings<'a> {
    names: Vec<&'a str>,
    found: Vec<(Vec<usize>, Violation)>,
}

impl<'a> Findings<'a> {
    pub(super) fn new(instance: &'a Instance) -> Self {
        let agents = instance.agents().iter();
        Self::named(agents.map(|agent| agent.name.as_str()).collect())
    }

    /// The same for agents of these names.
    pub(super) const fn named(names: Vec<&'a str>) -> Self {
        Self {
            names,
            found: Vec::new(),
        }
    }

    /// Whether the report is as long as it may be.
    pub(super) const fn is_full(&self) -> bool {
        self.found.len() >= MAX_VIOLATIONS
    }

    /// Notes a violation by agents of the instance, in its order.
    pub(super) fn push(
        &mut self,
        rule: Rule,
        time: usize,
        agents: &[usize],
        place: Place,
        message: String,
    ) {
        if self.is_full() {
            return;
        }
        let names = agents.iter().map(|&a| self.name(a).to_owned()).collect();
        let violation = violation(rule, time, names, place, message);
        self.found.push((agents.to_vec(), violation));
    }

    /// Notes that a rule of the scene's own is broken.
    pub(super) fn push_constraint(
        &mut self,
        rule: &InForce<'_>,
        time: u32,
        agents: &[usize],
        cells: Vec<Cell>,
    ) {
        if self.is_full() {
            return;
        }
        let names: Vec<String> = agents.iter().map(|&a| self.name(a).to_owned()).collect();
        let message = sentence::constraint(rule.constraint, &names, time);
        let violation = Violation {
            rule: Rule::Constraint,
            agents: names,
            cell: None,
            edge: None,
            time,
            message,
            broken: Some(Box::new(BrokenConstraint {
                kind: rule.constraint.kind_name().to_owned(),
                index: rule.index as u32,
                name: rule.constraint.name.clone(),
                cells,
            })),
        };
        self.found.push((agents.to_vec(), violation));
    }

    /// Notes that the plan names an agent that the instance has not.
    pub(super) fn push_stranger(&mut self, name: &str, message: String) {
        if self.is_full() {
            return;
        }
        let names = vec![name.to_owned()];
        let violation = violation(Rule::Shape, 0, names, Place::Nowhere, message);
        self.found.push((vec![usize::MAX], violation));
    }

    /// The name of an agent.
    pub(super) fn name(&self, agent: usize) -> &'a str {
        self.names.get(agent).copied().unwrap_or("")
    }

    /// All violations by time, rule and agents.
    pub(super) fn into_violations(mut self) -> Vec<Violation> {
        sort_by(&mut self.found, |(a, v), (b, w)| {
            (v.time, v.rule, a).cmp(&(w.time, w.rule, b))
        });
        self.found.into_iter().map(|(_, v)| v).collect()
    }
}

fn violation(
    rule: Rule,
    time: usize,
    agents: Vec<String>,
    place: Place,
    message: String,
) -> Violation {
    let (cell, edge) = match place {
        Place::Nowhere => (None, None),
        Place::Cell(cell) => (Some(cell), None),
        Place::Edge(from, to) => (None, Some([from, to])),
    };
    Violation {
        rule,
        agents,
        cell,
        edge,
        time: time as u32,
        message,
        broken: None,
    }
}
