//! Sets of vertices.

use std::rc::Rc;

use crate::terrain::Vertex;

/// A set of vertices; clones share it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Area {
    /// One vertex alone.
    One(Vertex),
    /// The vertices marked here.
    Many(Rc<Vec<bool>>),
}

impl Area {
    /// The set of some vertices, of so many in all.
    pub fn of(vertices: impl Iterator<Item = Vertex>, size: usize) -> Self {
        let mut marked = vec![false; size];
        for v in vertices {
            if let Some(mark) = marked.get_mut(v as usize) {
                *mark = true;
            }
        }
        Self::Many(Rc::new(marked))
    }

    /// Whether a vertex is one of them.
    pub fn has(&self, v: Vertex) -> bool {
        match self {
            Self::One(one) => *one == v,
            Self::Many(marked) => marked.get(v as usize) == Some(&true),
        }
    }
}
