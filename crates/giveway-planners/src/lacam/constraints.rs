//! The low-level search of one configuration: which agents are made to go where.
//!
//! A tree in the order of its levels. Its root asks for nothing; the children of
//! a node on level *k* say where the *k*-th agent in the order goes. Each node
//! gives one next configuration, and PIBT fills in what it leaves open. On the
//! last level everything is said, so in time all configurations come.

use crate::terrain::Vertex;

/// A node of the tree, but for the agent, which its level tells.
#[derive(Clone, Copy, Debug)]
struct Constraint {
    parent: u32,
    to: Vertex,
    depth: u32,
}

/// The tree, as far as it is grown.
#[derive(Debug)]
pub(super) struct Constraints {
    nodes: Vec<Constraint>,
    next: usize,
}

impl Constraints {
    /// The root alone.
    pub(super) fn new() -> Self {
        let root = Constraint {
            parent: 0,
            to: 0,
            depth: 0,
        };
        Self {
            nodes: vec![root],
            next: 0,
        }
    }

    /// Takes the next node off; `None` where all were taken. Fills `path` with
    /// where the first agents in the order have to go.
    pub(super) fn take(&mut self, path: &mut Vec<Vertex>) -> Option<u32> {
        let taken = self.next;
        let mut node = *self.nodes.get(taken)?;
        self.next += 1;
        path.clear();
        while node.depth > 0 {
            path.push(node.to);
            node = self.nodes[node.parent as usize];
        }
        path.reverse();
        Some(taken as u32)
    }

    /// Adds the children of a node: one for each way of the next agent.
    pub(super) fn add(&mut self, parent: u32, ways: &[Vertex]) {
        let depth = self.nodes[parent as usize].depth + 1;
        let children = ways.iter().map(|&to| Constraint { parent, to, depth });
        self.nodes.extend(children);
    }

    /// Forgets the tree, once all its nodes were taken.
    pub(super) fn close(&mut self) -> usize {
        let bytes = self.bytes();
        self.nodes = Vec::new();
        self.next = 0;
        bytes
    }

    /// The memory that it takes.
    pub(super) fn bytes(&self) -> usize {
        self.nodes.len() * size_of::<Constraint>()
    }
}
