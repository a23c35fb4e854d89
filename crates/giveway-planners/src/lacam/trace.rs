//! The steps of LaCAM as data: which configuration was made from which.

use super::ConfigurationId;
use crate::{pibt::Inheritance, terrain::Vertex};

/// The result of one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Made {
    /// A configuration that was not known; they are numbered from 0, the start.
    New(ConfigurationId),
    /// One that was known.
    Again(ConfigurationId),
    /// None: the constraints collide, or leave somebody without a cell.
    Nothing,
}

/// One step of the search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// The configuration that it begins in.
    pub from: ConfigurationId,
    /// Where the first agents of its order had to go.
    pub constraints: Vec<Vertex>,
    /// The inheritances of priority.
    pub inherited: Vec<Inheritance>,
    /// The result.
    pub made: Made,
}

/// The first steps of the search.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// The steps in their order.
    pub events: Vec<Event>,
    limit: usize,
}

impl Trace {
    /// With so many steps at the most.
    pub(super) fn new(limit: usize) -> Self {
        Self {
            events: Vec::new(),
            limit,
        }
    }

    /// Adds a step, while there is room.
    pub(super) fn tell(&mut self, event: impl FnOnce() -> Event) {
        if self.events.len() < self.limit {
            self.events.push(event());
        }
    }
}
