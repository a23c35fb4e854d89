//! Which repairs are told, and in which order.

use std::collections::BTreeSet;

use super::{Edit, Repair};

/// The most repairs that are told.
const MOST: usize = 12;

/// The place of an edit in the order in which repairs are told.
pub(super) const fn rank(edit: &Edit) -> u8 {
    match edit {
        Edit::RemoveObstacle { .. } => 0,
        Edit::AddCharger { .. } => 1,
        Edit::Battery { .. } => 2,
        Edit::Deadline { .. } => 3,
        Edit::MakeNormal { .. } => 4,
        Edit::DropWaypoint { .. } => 5,
        Edit::Vanish => 6,
        Edit::LeaveOut { .. } => 7,
    }
}

/// The first of them, the best of each kind among these.
pub(super) fn at_most(found: Vec<Repair>) -> Vec<Repair> {
    let kinds = |repair: &Repair| repair.edits.iter().map(rank).collect::<Vec<_>>();
    let mut seen = BTreeSet::new();
    let best: Vec<bool> = found
        .iter()
        .map(|repair| seen.insert(kinds(repair)))
        .collect();
    let mut spare = MOST.saturating_sub(seen.len());
    let mut kept = Vec::new();
    for (repair, best) in found.into_iter().zip(best) {
        if best {
            kept.push(repair);
        } else if spare > 0 {
            spare -= 1;
            kept.push(repair);
        }
    }
    kept.truncate(MOST);
    kept
}
