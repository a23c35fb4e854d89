//! Labels of the search, and when one is no better than another.

use super::{Driving, allowance::Allowance};
use crate::{single::State, terrain::Vertex};

/// A walk up to a time.
#[derive(Clone, Copy)]
pub(super) struct Label {
    pub(super) state: State,
    pub(super) time: u32,
    pub(super) driving: Driving,
    /// Where the last move began.
    pub(super) came_from: Option<Vertex>,
    pub(super) charges: u32,
    pub(super) moves: u32,
    pub(super) parent: u32,
    /// Another label of the same place, time and waypoints.
    pub(super) next: u32,
}

/// No label.
pub(super) const NONE: u32 = u32::MAX;

impl Label {
    /// Whether a label is no better than this one of the same place, time and waypoints.
    pub(super) fn dominates(&self, label: &Self, allowance: &Allowance) -> bool {
        let Allowance {
            charges,
            moves,
            waits,
            ..
        } = *allowance;
        let (a, b) = (self.driving, label.driving);
        // The next move of one may be a turn, and that of the other none.
        let turn = u32::from(self.came_from != label.came_from);
        self.state.battery >= label.state.battery
            && (charges.is_none() || self.charges <= label.charges)
            && (moves.is_none() || self.moves <= label.moves)
            && (waits.is_none() || a.waits <= b.waits)
            && (a.motion, a.waits, a.turns + turn, a.earliness)
                <= (b.motion, b.waits, b.turns, b.earliness)
    }
}
