//! What the lanes say of an order: who plans when, around whom, and where it ends.

use giveway_solve::plan::words;

use super::{Method, index, steps};
use crate::State;

/// What the lane of a robot says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// The robot, by its index.
    pub agent: usize,
    /// Its place in the order, from 1.
    pub place: usize,
    /// Around whom it plans.
    pub around: String,
    /// Where it ends without having arrived: the time, and what is said of it.
    pub stop: Option<(u32, String)>,
    /// Whether it has planned by the step that is shown.
    pub is_planned: bool,
}

/// The notes in the order in which robots plan; nothing where no order is looked at.
pub fn notes(state: &State) -> Option<Vec<Note>> {
    if !state.is_inside() || state.inside.method != Method::Orders {
        return None;
    }
    let run = state.looked()?.orders.get(state.inside.order)?;
    let (at, ..) = steps::place(state)?;
    let stuck = run.told.stuck.as_ref();
    let note = |(place, name): (usize, &String)| {
        let is_stuck = stuck.is_some_and(|stuck| stuck.agent == *name);
        let last = run.told.furthest.len().saturating_sub(1);
        let last = u32::try_from(last).unwrap_or(u32::MAX);
        let said = if run.told.dead_end {
            format!("no free cell at {}", last.saturating_add(1))
        } else {
            "no way to its goal".to_owned()
        };
        Some(Note {
            agent: index(state, name)?,
            place: place + 1,
            around: words::around(&run.told, place),
            stop: is_stuck.then_some((last, said)).filter(|_| place < at),
            is_planned: place < at,
        })
    };
    Some(run.told.order.iter().enumerate().filter_map(note).collect())
}
