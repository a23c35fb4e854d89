//! Which repairs are told, and in which order.

use std::collections::BTreeSet;

use giveway_model::{Objective, sorting::sort_by_key};

use super::{Edit, Repair};

/// The most repairs that are told.
const MOST: usize = 12;

/// The place of an edit in the order in which repairs are told.
pub(super) const fn rank(edit: &Edit) -> u8 {
    match edit {
        Edit::RemoveObstacle { .. } => 0,
        Edit::AddCharger { .. } => 1,
        Edit::Battery { .. } => 2,
        Edit::BatteryFloor { .. } => 3,
        Edit::Deadline { .. } => 4,
        Edit::MakeNormal { .. } => 5,
        Edit::DropWaypoint { .. } => 6,
        Edit::Vanish => 7,
        Edit::AllowMore { .. } => 8,
        Edit::GiveUntil { .. } => 9,
        Edit::SwitchOff { .. } => 10,
        Edit::LeaveOut { .. } => 11,
    }
}

/// The kinds of a repair's edits.
fn kinds(repair: &Repair) -> Vec<u8> {
    repair.edits.iter().map(rank).collect()
}

/// The best repair of each kind, then the others, by the number of edits, their kinds
/// and the costs; at most twelve, with how many more there are.
pub(super) fn first_of_each_kind(
    mut found: Vec<Repair>,
    objective: &Objective,
) -> (Vec<Repair>, u32) {
    sort_by_key(&mut found, |repair| {
        let costs = repair.costs.vector(objective);
        let edits = repair.edits.clone();
        (edits.len(), kinds(repair), costs, edits)
    });
    let mut seen = BTreeSet::new();
    let (mut told, others): (Vec<Repair>, Vec<Repair>) = found
        .into_iter()
        .partition(|repair| seen.insert(kinds(repair)));
    told.extend(others);
    let further = told.len().saturating_sub(MOST) as u32;
    told.truncate(MOST);
    (told, further)
}
