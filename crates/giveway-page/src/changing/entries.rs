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
    /// The first of them in words: `New obstacle at (3, 4)`.
    first: String,
    /// Where a robot stays that breaks down for good.
    pub(crate) stays: Option<Cell>,
}

impl Entry {
    /// In words: `New obstacle at (3, 4), and 8 more`.
    pub(crate) fn text(&self) -> String {
        and_more(&self.first, self.more())
    }

    /// How many changes there are beside the one that its words begin with.
    fn more(&self) -> usize {
        match self.stays {
            Some(_) => 0,
            None => self.changes.len() - 1,
        }
    }
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
                first: tr!(
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
            entry.stays.is_none() && last.is_some_and(|last| is_the_same_elsewhere(last, what))
        });
        match before {
            Some(entry) => entry.changes.push(index),
            None => entries.push(Entry {
                changes: vec![index],
                first: what.sentence().0,
                stays: None,
            }),
        }
    }
    entries
}

/// The first of the entries of a time in words, and how many more changes there are.
pub(crate) fn in_words(plan: Option<&Plan>, list: &[What], at: u32) -> String {
    let entries = entries(plan, list, at);
    match entries.as_slice() {
        [] => String::new(),
        [first, rest @ ..] => and_more(&first.first, first.more() + rest.len()),
    }
}

fn and_more(first: &str, more: usize) -> String {
    match more {
        0 => first.to_owned(),
        _ => tr!("{first}, and {more} more", first, more),
    }
}

/// Whether two changes do the same to the ground of one cell each.
fn is_the_same_elsewhere(one: &What, next: &What) -> bool {
    let is_ground = match one {
        What::AddObstacle { .. }
        | What::RemoveObstacle { .. }
        | What::AddCharger { .. }
        | What::RemoveCharger { .. } => true,
        // Those of slow cells name all of their cells.
        What::SetSlow { .. }
        | What::SetNormal { .. }
        | What::MoveObstacle { .. }
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
