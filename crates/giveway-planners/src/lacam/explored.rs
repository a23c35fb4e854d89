//! The configurations that were found, each once, with what is known of it.

use rustc_hash::FxBuildHasher;

use super::constraints::Constraints;
use crate::{pibt::Priorities, terrain::Vertex};

/// A configuration by its number, in the order in which they were found.
pub type ConfigurationId = u32;

#[expect(
    clippy::disallowed_types,
    reason = "only looked up, never iterated, so its order cannot matter"
)]
type Table = std::collections::HashMap<u64, ConfigurationId, FxBuildHasher>;

/// A configuration that was reached.
pub(super) struct Node {
    /// From where it is reached with the least loss; `None` at the start.
    pub(super) parent: Option<ConfigurationId>,
    /// The sum of losses on the way here.
    pub(super) loss: u64,
    /// A lower bound on the loss from here on.
    pub(super) least: u64,
    pub(super) priorities: Priorities,
    pub(super) constraints: Constraints,
    /// The configurations that were made from this one, ascending, each with what the step
    /// there loses.
    pub(super) successors: Vec<(ConfigurationId, u64)>,
    /// Another one with the same hash.
    twin: Option<ConfigurationId>,
}

impl Node {
    /// A node without successors.
    pub(super) fn new(
        parent: Option<ConfigurationId>,
        [loss, least]: [u64; 2],
        priorities: Priorities,
    ) -> Self {
        Self {
            parent,
            loss,
            least,
            priorities,
            constraints: Constraints::new(),
            successors: Vec::new(),
            twin: None,
        }
    }

    /// The least loss of a plan by way of this one, as far as is known.
    pub(super) fn bound(&self) -> u64 {
        self.loss + self.least
    }

    /// Where a successor is to be noted; `None` where it is noted already.
    pub(super) fn place_of(&self, to: ConfigurationId) -> Option<usize> {
        let place = self.successors.binary_search_by_key(&to, |&(to, _)| to);
        place.err()
    }
}

/// All of them.
pub(super) struct Explored {
    agents: usize,
    cells: Vec<Vertex>,
    pub(super) nodes: Vec<Node>,
    by_hash: Table,
}

impl Explored {
    pub(super) fn new(agents: usize) -> Self {
        Self {
            agents,
            cells: Vec::new(),
            nodes: Vec::new(),
            by_hash: Table::default(),
        }
    }

    /// Where the agents are in a configuration.
    pub(super) fn cells(&self, id: ConfigurationId) -> &[Vertex] {
        let begin = id as usize * self.agents;
        &self.cells[begin..begin + self.agents]
    }

    /// The number of a configuration that was found before.
    pub(super) fn find(&self, cells: &[Vertex]) -> Option<ConfigurationId> {
        let mut found = self.by_hash.get(&hash(cells)).copied();
        while let Some(id) = found {
            if self.cells(id) == cells {
                return found;
            }
            found = self.nodes[id as usize].twin;
        }
        None
    }

    /// Adds a configuration that was not found before.
    pub(super) fn add(&mut self, cells: &[Vertex], mut node: Node) -> ConfigurationId {
        let id = self.nodes.len() as ConfigurationId;
        node.twin = self.by_hash.insert(hash(cells), id);
        self.nodes.push(node);
        self.cells.extend_from_slice(cells);
        id
    }

    /// The memory that a configuration takes, without its constraints and
    /// successors.
    pub(super) fn bytes_each(&self) -> usize {
        3 * self.agents * size_of::<u32>() + size_of::<Node>() + 2 * size_of::<u64>()
    }
}

/// The same on every machine.
fn hash(cells: &[Vertex]) -> u64 {
    let mix = |hash: u64, &v: &Vertex| {
        let mixed = (hash ^ u64::from(v)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        mixed ^ (mixed >> 29)
    };
    cells.iter().fold(0x51_7C_C1_B7, mix)
}
