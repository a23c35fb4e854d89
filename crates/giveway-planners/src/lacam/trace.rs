//! The steps of LaCAM as data: which configuration was made from which.

use super::ConfigurationId;
use crate::{AgentId, pibt::Inheritance, terrain::Vertex};

/// The cells of so many agents are told, of all configurations together.
const MOST_CELLS: usize = 50_000;

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
    /// The first agents of its order, which had to go somewhere.
    pub constrained: Vec<AgentId>,
    /// Where they had to go.
    pub constraints: Vec<Vertex>,
    /// The inheritances of priority.
    pub inherited: Vec<Inheritance>,
    /// The result.
    pub made: Made,
    /// Where the agents are in a configuration that is new; nothing of others, and where
    /// configurations are too many to be told.
    pub cells: Vec<Vertex>,
}

/// The first steps of the search.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// The steps in their order.
    pub events: Vec<Event>,
    limit: usize,
    /// How many more cells are told.
    cells: usize,
}

impl Trace {
    /// With so many steps at the most.
    pub(super) fn new(limit: usize) -> Self {
        Self {
            events: Vec::new(),
            limit,
            cells: MOST_CELLS,
        }
    }

    /// Adds a step, while there is room.
    pub(super) fn tell(&mut self, event: impl FnOnce() -> Event) {
        if self.events.len() < self.limit {
            let mut event = event();
            match self.cells.checked_sub(event.cells.len()) {
                Some(left) => self.cells = left,
                None => event.cells.clear(),
            }
            self.events.push(event);
        }
    }
}
