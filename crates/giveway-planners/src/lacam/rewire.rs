//! The loss on the way to a configuration, and its update where the configuration is reached at less loss:
//! the part of LaCAM* that LaCAM does not have.

use super::{explored::ConfigurationId, search::Search};
use crate::terrain::Vertex;

/// Once in so many times that a known configuration comes again the search goes
/// on at the start.
const RESTART: u8 = 100;

impl Search<'_> {
    /// The loss of a step: one for each agent that is not at its goal both before and after it.
    pub(super) fn edge(&self, from: &[Vertex], to: &[Vertex]) -> u64 {
        let steps = from.iter().zip(to).zip(self.plain.goals());
        steps
            .filter(|&((u, v), goal)| u != goal || v != goal)
            .count() as u64
    }

    /// The sum of distances after a step, from that before it.
    pub(super) fn onward(&self, mut sum: u64, from: &[Vertex], to: &[Vertex]) -> u64 {
        for (agent, (&u, &v)) in from.iter().zip(to).enumerate() {
            if u != v {
                sum += u64::from(self.plain.distance(agent, v));
                sum -= u64::from(self.plain.distance(agent, u));
            }
        }
        sum
    }

    /// A known configuration was made again: there may be a better way to it and
    /// to all that follow it. The search goes on there, or now and then at the
    /// start.
    pub(super) fn again(&mut self, from: ConfigurationId, to: ConfigurationId) {
        self.link(from, to);
        self.rewire(from);
        let next = if self.rng.u8(..RESTART) == 0 { 0 } else { to };
        if !self.cannot_improve(next) {
            self.open.push(next);
        }
    }

    /// Hands the loss of a configuration on to those that follow it, wherever
    /// they become cheaper.
    fn rewire(&mut self, from: ConfigurationId) {
        let mut queue = vec![from];
        let mut next = 0;
        while let Some(&from) = queue.get(next) {
            next += 1;
            let node = &self.explored.nodes[from as usize];
            let loss = node.loss;
            for i in 0..node.successors.len() {
                let (to, step) = self.explored.nodes[from as usize].successors[i];
                let loss = loss + step;
                let node = &mut self.explored.nodes[to as usize];
                if loss >= node.loss {
                    continue;
                }
                node.loss = loss;
                node.parent = Some(from);
                queue.push(to);
                if self.goal.is_some() && !self.cannot_improve(to) {
                    self.open.push(to);
                }
            }
        }
    }
}
