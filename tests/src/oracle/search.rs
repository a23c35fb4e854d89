//! Dijkstra's algorithm with cost vectors.
//!
//! A *label* says: this joint state can be reached at this cost. Labels are
//! taken up in the order of their vectors, the lexicographically smallest first,
//! and each makes a label for every joint step from its state. Prices are never
//! negative, and adding one price to two vectors keeps their order. So the first
//! label of an end that is taken up has the best vector.
//!
//! A label is dropped if another of the same state makes it needless:
//!
//! - For the lexicographic optimum, one whose vector is not larger. One label
//!   a state remains.
//! - For a Pareto front, one that is higher in no cost. Each state keeps a set
//!   of labels. A label is taken up after all that could make it needless, so
//!   the ends taken up are the front, as long as each is compared with those
//!   before it (Martins' algorithm).
//! - With a limit on a cost, it must not have spent more of it: that is a
//!   resource like time.
//! - With a horizon, it must in both cases have taken no more time either, since
//!   time is then a resource that a cheaper way may lack later.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use giveway_model::Cost;

use super::Point;
use super::joint::{Code, Joint};
use super::price::{Vector, after, nowhere_higher};
use super::trace;

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aim {
    /// The lexicographically smallest vector.
    Lexicographic,
    /// Every vector that no other dominates.
    Pareto,
}

/// A state reached at a cost.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Label {
    vector: Vector,
    /// The time, in steps from 0.
    time: u32,
    /// What was spent of the cost that is limited.
    spent: u32,
    pub(crate) state: Code,
    /// The number of the label from which it was made; `None` at time 0.
    pub(crate) parent: Option<usize>,
}

/// A search to be run.
pub(crate) struct Search<'a> {
    pub(crate) joint: &'a Joint,
    pub(crate) costs: &'a [Cost],
    pub(crate) aim: Aim,
    pub(crate) within: Option<u32>,
    pub(crate) cap: usize,
    pub(crate) limit: Option<Limit>,
}

/// A cost that must be below a number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limit {
    pub(crate) cost: Cost,
    pub(crate) below: u32,
}

/// The labels of a search under way.
#[derive(Default)]
struct Labels {
    all: Vec<Label>,
    /// The labels of each state that nothing has made needless so far.
    of_state: BTreeMap<Code, Vec<usize>>,
    /// Those not yet taken up: vector, time, number.
    waiting: BinaryHeap<Reverse<(Vector, u32, usize)>>,
}

impl Search<'_> {
    /// The points found, the lexicographically smallest first: at most one for
    /// the lexicographic aim. `None` where the cap was reached.
    pub(crate) fn run(&self) -> Option<Vec<Point>> {
        let mut labels = Labels::default();
        let mut ends: Vec<usize> = Vec::new();
        for state in self.joint.first() {
            let states = self.joint.decode(state);
            if self.in_time(0, &states) {
                self.add(&mut labels, Vector::default(), [0, 0], state, None);
            }
        }
        while let Some(Reverse((vector, time, number))) = labels.waiting.pop() {
            let Label { state, spent, .. } = labels.all[number];
            if !labels.of_state[&state].contains(&number) {
                continue;
            }
            let found = |end: &usize| nowhere_higher(&labels.all[*end].vector, &vector);
            if ends.iter().any(found) {
                continue;
            }
            let states = self.joint.decode(state);
            if self.joint.is_done(&states) {
                ends.push(number);
                if self.aim == Aim::Lexicographic {
                    break;
                }
                continue;
            }
            if labels.all.len() > self.cap {
                return None;
            }
            self.joint.steps(&states, |next, price| {
                let vector = after(vector, price, self.costs);
                let time = time + 1;
                let spent = spent + self.limit.map_or(0, |limit| price.adds_to(limit.cost));
                if self.limit.is_some_and(|limit| spent >= limit.below) {
                    return;
                }
                if self.within.is_none() || self.in_time(time, &self.joint.decode(next)) {
                    self.add(&mut labels, vector, [time, spent], next, Some(number));
                }
            });
        }
        Some(ends.iter().map(|&end| self.point(&labels, end)).collect())
    }

    /// Whether each agent may still arrive by the horizon, if it is not hindered.
    fn in_time(&self, time: u32, states: &[usize]) -> bool {
        self.within
            .is_none_or(|within| time + self.joint.to_go(states) <= within)
    }

    fn add(
        &self,
        labels: &mut Labels,
        vector: Vector,
        [time, spent]: [u32; 2],
        state: Code,
        parent: Option<usize>,
    ) {
        let new = Label {
            vector,
            time,
            spent,
            state,
            parent,
        };
        let Labels {
            all,
            of_state,
            waiting,
        } = labels;
        let rivals = of_state.entry(state).or_default();
        if rivals
            .iter()
            .any(|&old| self.makes_needless(&all[old], &new))
        {
            return;
        }
        rivals.retain(|&old| !self.makes_needless(&new, &all[old]));
        rivals.push(all.len());
        waiting.push(Reverse((vector, time, all.len())));
        all.push(new);
    }

    /// Whether one label of a state makes another needless.
    fn makes_needless(&self, one: &Label, other: &Label) -> bool {
        let in_costs = match self.aim {
            Aim::Lexicographic => one.vector <= other.vector,
            Aim::Pareto => nowhere_higher(&one.vector, &other.vector),
        };
        let in_time = self.within.is_none() || one.time <= other.time;
        in_costs && in_time && one.spent <= other.spent
    }

    fn point(&self, labels: &Labels, end: usize) -> Point {
        Point {
            vector: labels.all[end].vector[..self.costs.len()].to_vec(),
            plan: trace::plan(self.joint, &labels.all, end),
        }
    }
}
