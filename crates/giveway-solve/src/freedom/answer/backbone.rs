//! The backbone: the visits that all best plans share.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Cell;
use serde::{Deserialize, Serialize};

use super::Known;

/// One entry of an agent's path in the plan, at one time up to its arrival.
///
/// A step from one time to the next is in every best plan just when the entries at
/// both times are: see [`same_steps`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Visit {
    /// The time.
    pub time: u32,
    /// The cell; `null` in transit.
    pub cell: Option<Cell>,
    /// Whether the agent is there at that time in every best plan; in transit: whether
    /// it is between the same two cells, in the same direction.
    pub always: Known,
    /// Whether it is there at that time in no best plan but this one.
    pub only: Known,
    /// Where it charges at that time: whether it does so in every best plan, or in
    /// this one alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub charge: Option<Shared>,
}

/// Whether something of this plan is in every best plan, or in no other.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Shared {
    /// In every best plan.
    pub always: Known,
    /// In no best plan but this one.
    pub only: Known,
}

/// How many steps of an agent are proved to be the same in every best plan, and how
/// many it takes in this one; each half of a slow move is a step.
pub fn same_steps(visits: &[Visit]) -> (usize, usize) {
    let both = |pair: &&[Visit]| pair.iter().all(|visit| visit.always.is_proved());
    let same = visits.windows(2).filter(both).count();
    (same, visits.len().saturating_sub(1))
}
