//! Cells that a map falls apart without.
//!
//! Depth-first search (Hopcroft and Tarjan 1973): a vertex is a cut where a subtree of it has no edge
//! that leads above it. The subtrees are intervals of the order of the search, so that it takes no further
//! search to tell whether two vertices lie on different sides of a cut.

use crate::{
    budget::{Budget, Stop},
    terrain::{Terrain, Vertex},
};

/// The vertices of a map in the order of a depth-first search.
pub(super) struct Cuts {
    /// The number of each vertex in the order, and the last one below it.
    interval: Vec<(u32, u32)>,
    /// The tree of each vertex, by the number of its root.
    tree: Vec<u32>,
    /// Of each vertex the subtrees that only it joins to the rest, as intervals.
    below: Vec<Vec<(u32, u32)>>,
}

/// A vertex of the search under way.
struct Visit {
    at: Vertex,
    parent: Option<Vertex>,
    /// The next of its arcs.
    next: usize,
    /// The least number to which an edge of its subtree leads.
    low: u32,
}

impl Cuts {
    /// Searches a map.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn of(terrain: &Terrain, budget: &dyn Budget) -> Result<Self, Stop> {
        const UNKNOWN: u32 = u32::MAX;
        let size = terrain.size();
        budget.spend(size as u64)?;
        let mut cuts = Self {
            interval: vec![(UNKNOWN, UNKNOWN); size],
            tree: vec![UNKNOWN; size],
            below: vec![Vec::new(); size],
        };
        let mut number = 0;
        for root in 0..size as Vertex {
            if cuts.number(root) != UNKNOWN {
                continue;
            }
            let mut way = vec![cuts.enter(root, None, root, &mut number)];
            while let Some(visit) = way.last_mut() {
                if let Some(arc) = terrain.arcs(visit.at).get(visit.next) {
                    visit.next += 1;
                    let (to, at) = (arc.to, visit.at);
                    let known = cuts.interval[to as usize].0;
                    if known == UNKNOWN {
                        let visit = cuts.enter(to, Some(at), root, &mut number);
                        way.push(visit);
                    } else if visit.parent != Some(to) {
                        visit.low = visit.low.min(known);
                    }
                    continue;
                }
                let Visit { at, low, .. } = *visit;
                way.pop();
                let first = cuts.interval[at as usize].0;
                cuts.interval[at as usize].1 = number - 1;
                if let Some(above) = way.last_mut() {
                    above.low = above.low.min(low);
                    if low >= cuts.interval[above.at as usize].0 {
                        cuts.below[above.at as usize].push((first, number - 1));
                    }
                }
            }
        }
        Ok(cuts)
    }

    fn enter(
        &mut self,
        at: Vertex,
        parent: Option<Vertex>,
        root: Vertex,
        number: &mut u32,
    ) -> Visit {
        let own = *number;
        *number += 1;
        self.interval[at as usize].0 = own;
        self.tree[at as usize] = root;
        Visit {
            at,
            parent,
            next: 0,
            low: own,
        }
    }

    fn number(&self, v: Vertex) -> u32 {
        self.interval[v as usize].0
    }

    /// The vertices that some vertices may lie on different sides of.
    pub(super) fn all(&self) -> impl Iterator<Item = Vertex> + '_ {
        let cuts = self.below.iter().enumerate();
        cuts.filter_map(|(v, below)| (!below.is_empty()).then_some(v as Vertex))
    }

    /// Whether a vertex is one of them.
    pub(super) fn is_cut(&self, v: Vertex) -> bool {
        !self.below[v as usize].is_empty()
    }

    /// Whether every way from one vertex to another leads over a third.
    pub(super) fn parts(&self, cut: Vertex, from: Vertex, to: Vertex) -> bool {
        let tree = |v: Vertex| self.tree[v as usize];
        from != cut
            && to != cut
            && tree(from) == tree(cut)
            && tree(to) == tree(cut)
            && self.side(cut, from) != self.side(cut, to)
    }

    /// The side of a cut on which a vertex lies: a subtree, or all the rest.
    fn side(&self, cut: Vertex, v: Vertex) -> Option<usize> {
        let number = self.number(v);
        let mut below = self.below[cut as usize].iter();
        below.position(|&(first, last)| (first..=last).contains(&number))
    }
}
