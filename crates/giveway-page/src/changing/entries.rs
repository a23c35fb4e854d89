//! The entries of a list of changes: what is done to the ground of several cells one after the other
//! is one entry, and so is a robot that breaks down for good, with the obstacle that it becomes.

use std::mem::discriminant;

use giveway_model::change::What;
use giveway_model::{Cell, Plan, tr};

use super::listed::whose;
use super::stopped::obstacle_of;
use crate::words::at as at_cell;

/// One or several changes that are told and taken back together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    /// Their indices in the list, the first one first.
    pub(crate) changes: Vec<usize>,
    /// In words: `New obstacle at (3, 4), and 8 more`.
    pub(crate) text: String,
    /// Where a robot stays that breaks down for good.
    pub(crate) stays: Option<Cell>,
}

/// The entries of the changes of a time, in their order.
pub(crate) fn entries(plan: Option<&Plan>, list: &[What], at: u32) -> Vec<Entry> {
    let stop = |index: usize| obstacle_of(plan, list, at, index);
    let taken: Vec<usize> = (0..list.len())
        .filter_map(|index| Some(stop(index)?.0))
        .collect();
    let mut entries: Vec<Entry> = Vec::new();
    for (index, what) in list.iter().enumerate() {
        if taken.contains(&index) {
            continue;
        }
        if let (Some((obstacle, cell)), Some(agent)) = (stop(index), whose(what)) {
            entries.push(Entry {
                changes: vec![index, obstacle],
                text: tr!(
                    "{agent} breaks down for good at {cell}",
                    agent,
                    cell = at_cell(cell)
                ),
                stays: Some(cell),
            });
            continue;
        }
        let before = entries.last_mut().filter(|entry| {
            let last = entry.changes.last().and_then(|&last| list.get(last));
            entry.stays.is_none() && last.is_some_and(|last| is_one_stroke(last, what))
        });
        match before {
            Some(entry) => entry.changes.push(index),
            None => entries.push(Entry {
                changes: vec![index],
                text: what.sentence().0,
                stays: None,
            }),
        }
    }
    for entry in &mut entries {
        if entry.stays.is_none() && entry.changes.len() > 1 {
            entry.text = and_more(&entry.text, entry.changes.len() - 1);
        }
    }
    entries
}

/// The first of the entries of a time in words, and how many more changes there are.
pub(crate) fn in_words(plan: Option<&Plan>, list: &[What], at: u32) -> String {
    let entries = entries(plan, list, at);
    match entries.as_slice() {
        [] => String::new(),
        [only] => only.text.clone(),
        [first, rest @ ..] => and_more(&first.text, rest.len()),
    }
}

fn and_more(first: &str, more: usize) -> String {
    tr!("{first}, and {more} more", first, more)
}

/// Whether two changes do the same to the ground of a cell each.
fn is_one_stroke(one: &What, next: &What) -> bool {
    let is_ground = match one {
        What::AddObstacle { .. }
        | What::RemoveObstacle { .. }
        | What::SetSlow { .. }
        | What::SetNormal { .. }
        | What::AddCharger { .. }
        | What::RemoveCharger { .. } => true,
        What::MoveObstacle { .. }
        | What::AddAgent { .. }
        | What::RemoveAgent { .. }
        | What::SetGoal { .. }
        | What::AddWaypoint { .. }
        | What::DropWaypoint { .. }
        | What::SetBattery { .. }
        | What::DelayAgent { .. }
        | What::AddConstraint { .. }
        | What::RemoveConstraint { .. } => false,
    };
    is_ground && discriminant(one) == discriminant(next)
}
