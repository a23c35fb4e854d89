//! What the lanes say of an order: who plans when, around whom, and where it ends.

use giveway_model::tr;
use giveway_solve::plan::words;

use super::{Method, index, steps};
use crate::State;

/// Where a robot ends without having arrived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stop {
    /// The time.
    pub time: u32,
    /// What is said of it.
    pub text: String,
    /// The same where there is little room.
    pub short: &'static str,
}

impl Stop {
    /// How many more times the axis has, so that there is room behind the lane.
    pub fn room(&self) -> u32 {
        ((self.time + 1) * 45 / 100 + 1).min(12)
    }
}

/// What the lane of a robot says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// The robot, by its index.
    pub agent: usize,
    /// Its place in the order, from 1.
    pub place: usize,
    /// Around whom it plans.
    pub around: String,
    /// Where it ends without having arrived.
    pub stop: Option<Stop>,
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
            tr!("no free cell at {time}", time = last.saturating_add(1))
        } else {
            tr!("no way on").to_owned()
        };
        let stop = Stop {
            time: last,
            text: said,
            short: tr!("a robot is" => "stuck"),
        };
        Some(Note {
            agent: index(state, name)?,
            place: place + 1,
            around: words::around(&run.told, place),
            stop: (is_stuck && place < at).then_some(stop),
            is_planned: place < at,
        })
    };
    Some(run.told.order.iter().enumerate().filter_map(note).collect())
}
