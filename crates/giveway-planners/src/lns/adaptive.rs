//! Which kind of neighbourhood to try: one that has gained much of late.
//!
//! Adaptive large neighbourhood search (Ropke and Pisinger 2006), in whole numbers,
//! so that every machine chooses alike.

use fastrand::Rng;

/// How agents are chosen together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Neighbourhood {
    /// A delayed agent, and those that it meets where it walks about at random
    /// A delayed agent, and the agents that it meets on a random walk that does not make it later.
    Delay,
    /// A delayed agent, and the agents on an optimal path of its own.
    OwnWay,
    /// Agents that pass near a crossing.
    Crossing,
    /// Random agents.
    Random,
}

const KINDS: [Neighbourhood; 4] = [
    Neighbourhood::Delay,
    Neighbourhood::OwnWay,
    Neighbourhood::Crossing,
    Neighbourhood::Random,
];

/// The weight at the beginning, and the least.
const FIRST: u64 = 10_000;
const LEAST: u64 = 100;

/// The weights of all kinds.
pub(super) struct Adaptive([u64; KINDS.len()]);

impl Default for Adaptive {
    fn default() -> Self {
        Self([FIRST; KINDS.len()])
    }
}

impl Adaptive {
    /// A kind, by chance and weight.
    pub(super) fn choose(&self, rng: &mut Rng) -> Neighbourhood {
        let mut left = rng.u64(..self.0.iter().sum::<u64>().max(1));
        for (kind, &weight) in KINDS.into_iter().zip(&self.0) {
            if left < weight {
                return kind;
            }
            left -= weight;
        }
        Neighbourhood::Random
    }

    /// Notes what a kind has gained: its weight becomes 0.99 of what it was, plus 100 for each step
    /// of gain.
    pub(super) fn learn(&mut self, kind: Neighbourhood, gain: u32) {
        for (other, weight) in KINDS.into_iter().zip(&mut self.0) {
            if other == kind {
                let learnt = *weight - *weight / 100 + u64::from(gain) * 100;
                *weight = learnt.max(LEAST);
            }
        }
    }
}
