//! The priorities of a step: the order in which agents choose.
//!
//! The agent with the most steps since it was last at its goal comes first; among equals, the agent with the
//! longest way at the start.

use crate::{plain::Plain, terrain::Vertex};

/// The agents by their distance at the start, the farthest first.
pub(crate) struct Ranks {
    by_rank: Vec<u32>,
    rank: Vec<u32>,
}

impl Ranks {
    pub(crate) fn new(plain: &Plain) -> Self {
        let starts = plain.starts().iter().enumerate();
        let mut keys: Vec<u64> = starts
            .map(|(agent, &v)| key(plain.distance(agent, v), agent as u32))
            .collect();
        keys.sort_unstable();
        let by_rank: Vec<u32> = keys.iter().map(|&key| key as u32).collect();
        let mut rank = vec![0; by_rank.len()];
        for (place, &agent) in by_rank.iter().enumerate() {
            rank[agent as usize] = place as u32;
        }
        Self { by_rank, rank }
    }
}

/// Larger first, then the smaller second.
fn key(larger: u32, smaller: u32) -> u64 {
    u64::from(!larger) << 32 | u64::from(smaller)
}

/// The priorities in one configuration.
pub(crate) struct Priorities {
    /// The steps of each agent since it was last at its goal.
    elapsed: Box<[u32]>,
    /// The agents in the order in which they choose.
    pub(crate) order: Box<[u32]>,
}

impl Priorities {
    /// The priorities at the start.
    pub(crate) fn first(ranks: &Ranks) -> Self {
        Self {
            elapsed: vec![0; ranks.rank.len()].into(),
            order: ranks.by_rank.as_slice().into(),
        }
    }

    /// The priorities in a configuration, one step later.
    pub(crate) fn after(&self, ranks: &Ranks, cells: &[Vertex], goals: &[Vertex]) -> Self {
        let onward = self.elapsed.iter().zip(cells.iter().zip(goals));
        let elapsed: Box<[u32]> = onward
            .map(|(&elapsed, (v, goal))| if v == goal { 0 } else { elapsed + 1 })
            .collect();
        let ranked = elapsed.iter().zip(&ranks.rank);
        let mut keys: Vec<u64> = ranked.map(|(&elapsed, &rank)| key(elapsed, rank)).collect();
        keys.sort_unstable();
        let order = keys.iter().map(|&key| ranks.by_rank[key as u32 as usize]);
        Self {
            order: order.collect(),
            elapsed,
        }
    }
}
