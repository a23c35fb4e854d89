//! The entries of a list of changes: what is done to the ground of several cells one after the other
//! is one entry.

use std::mem::discriminant;

use giveway_model::change::What;
use giveway_model::{Plan, tr};

use super::stopped::stand;
use crate::words::at as at_cell;

/// One or several changes that are told and taken back together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    /// Their indices in the list, the first one first.
    pub(crate) changes: Vec<usize>,
    /// The first of them in words: `New obstacle at (3, 4)`.
    first: String,
}

impl Entry {
    /// In words: `New obstacle at (3, 4), and 8 more`.
    pub(crate) fn text(&self) -> String {
        and_more(&self.first, self.more())
    }

    /// How many changes there are beside the one that its words begin with.
    const fn more(&self) -> usize {
        self.changes.len() - 1
    }
}

/// The entries of the changes of a time, in their order.
pub(crate) fn entries(plan: Option<&Plan>, list: &[What], at: u32) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for (index, what) in list.iter().enumerate() {
        let before = entries.last_mut().filter(|entry| {
            let last = entry.changes.last().and_then(|&last| list.get(last));
            last.is_some_and(|last| is_the_same_elsewhere(last, what))
        });
        match before {
            Some(entry) => entry.changes.push(index),
            None => entries.push(Entry {
                changes: vec![index],
                first: told(plan, what, at),
            }),
        }
    }
    entries
}

/// A change in words; of a breakdown for good where it is, too.
fn told(plan: Option<&Plan>, what: &What, at: u32) -> String {
    match what {
        What::StopAgent { agent } if let Some(cell) = stand(plan, agent, at) => tr!(
            "{agent} breaks down for good at {cell}",
            agent,
            cell = at_cell(cell)
        ),
        what => what.sentence().0,
    }
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
        | What::StopAgent { .. }
        | What::AddConstraint { .. }
        | What::RemoveConstraint { .. } => false,
    };
    is_ground && discriminant(one) == discriminant(next)
}
