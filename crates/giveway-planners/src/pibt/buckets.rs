//! A queue of vertices by cost, a list for each cost (Dial 1969).
//!
//! Costs that wait lie close together, so a few lists are used in turn. That is
//! several times as fast as a heap.

use crate::terrain::Vertex;

/// The queue. What is pushed costs no less than what was popped last, and less
/// than as many more as there are lists.
pub(super) struct Buckets {
    lists: Vec<Vec<Vertex>>,
    cost: u32,
    waiting: usize,
}

impl Buckets {
    /// Empty, for costs that differ by no more than this.
    pub(super) fn new(most: u32) -> Self {
        Self {
            lists: vec![Vec::new(); most as usize + 1],
            cost: 0,
            waiting: 0,
        }
    }

    /// Empty again, from a cost on.
    pub(super) fn begin(&mut self, cost: u32) {
        if self.waiting > 0 {
            self.lists.iter_mut().for_each(Vec::clear);
        }
        (self.cost, self.waiting) = (cost, 0);
    }

    pub(super) fn push(&mut self, cost: u32, v: Vertex) {
        let turn = self.lists.len();
        self.lists[cost as usize % turn].push(v);
        self.waiting += 1;
    }

    /// The cheapest one; among equals the last one.
    pub(super) fn pop(&mut self) -> Option<(u32, Vertex)> {
        let turn = self.lists.len();
        while self.waiting > 0 {
            if let Some(v) = self.lists[self.cost as usize % turn].pop() {
                self.waiting -= 1;
                return Some((self.cost, v));
            }
            self.cost += 1;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cheapest_comes_first_and_among_equals_the_last() {
        let mut buckets = Buckets::new(3);
        buckets.begin(10);
        for (cost, v) in [(12, 1), (10, 2), (13, 3), (10, 4)] {
            buckets.push(cost, v);
        }
        assert_eq!(buckets.pop(), Some((10, 4)));
        assert_eq!(buckets.pop(), Some((10, 2)));
        assert_eq!(buckets.pop(), Some((12, 1)));
        buckets.push(15, 5);
        assert_eq!(buckets.pop(), Some((13, 3)));
        buckets.begin(7);
        assert_eq!(buckets.pop(), None);
        buckets.push(8, 6);
        assert_eq!(buckets.pop(), Some((8, 6)));
    }
}
