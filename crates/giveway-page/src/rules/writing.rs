//! The rule that is being written.

use giveway_model::{Constraint, Scene};

use super::{Slot, Value, parts, zone_of};

/// The rule that is being written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Writing {
    /// The rule as it stands.
    pub(crate) rule: Constraint,
    /// The rule of the scene that it takes the place of, by its index.
    pub(crate) index: Option<usize>,
    /// Whether it is asked why it is not so, instead of added.
    pub(crate) asks: bool,
    /// The slot that is open.
    pub(crate) open: Option<Slot>,
    /// What can be written as well.
    pub(crate) offers: Vec<Constraint>,
    /// The words typed last, where they are no rule, and why.
    pub(crate) misread: Option<(String, String)>,
}

impl Writing {
    /// Begins with the first of some offers; nothing where there is none.
    pub(crate) fn first(offers: Vec<Constraint>) -> Option<Self> {
        let rule = offers.first()?.clone();
        Some(Self {
            rule,
            index: None,
            asks: false,
            open: None,
            offers,
            misread: None,
        })
    }

    /// Edits a rule of the scene.
    pub(crate) fn of(rule: &Constraint, index: usize) -> Self {
        Self {
            rule: rule.clone(),
            index: Some(index),
            asks: false,
            open: None,
            offers: Vec::new(),
            misread: None,
        }
    }

    /// The zone that it is about.
    pub(crate) fn zone(&self) -> Option<&str> {
        zone_of(&self.rule.kind)
    }

    /// Writes another rule in its place.
    pub(crate) fn write(&mut self, rule: Constraint) {
        self.rule = rule;
        self.open = None;
        self.misread = None;
    }

    /// Fills a slot.
    pub(crate) fn fill(&mut self, value: Value) {
        self.misread = None;
        let parts = parts(&mut self.rule.kind);
        match value {
            Value::Number(index, number) => {
                if let Some(of) = parts.numbers.into_iter().nth(index) {
                    *of = number;
                }
            }
            Value::Who(agents) => self.rule.agents = agents,
            Value::Zone(name) => {
                if let Some(zone) = parts.zone {
                    *zone = name;
                }
            }
            Value::When(times) => {
                if let Some(of) = parts.times {
                    *of = times;
                }
            }
            Value::Cell(index, cell) => {
                if let Some(of) = parts.cells.into_iter().nth(index) {
                    *of = cell;
                }
            }
            Value::Agent(index, name) => {
                if let Some(of) = parts.agents.into_iter().nth(index) {
                    *of = name;
                }
            }
        }
    }

    /// Whether a scene still has the rule that is edited.
    pub(crate) fn fits(&self, scene: &Scene) -> bool {
        let count = scene.constraints.len();
        self.index.is_none_or(|index| index < count)
    }
}
