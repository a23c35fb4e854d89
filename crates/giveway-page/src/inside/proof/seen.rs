//! What is seen of a step of the proof on the board: its robots, where they can be,
//! and where they get into each other's way.

use giveway_model::{Cell, tr};
use giveway_solve::together::{MeetingKind, MustMeet};
use giveway_solve::trace::SearchEvent;

use super::chosen_event;
use super::closer::{alone, limits, told};
use crate::State;
use crate::board::middle;
use crate::board::{CELL, shade};
use crate::inside::board::{Meeting, Overlay, Shade, between};
use crate::inside::index;

/// More regions would hide each other and the map.
const SHADES: usize = 6;
/// So many meetings are marked.
const MEETINGS: usize = 4;

/// The robots that a step is about; `None` where it is about all.
fn lit(state: &State) -> Option<Vec<usize>> {
    let names: Vec<String> = match &chosen_event(state)?.event {
        SearchEvent::Core(core) => limits(core).into_iter().map(|limit| limit.agent).collect(),
        SearchEvent::Entered { agents } => {
            let with = agents.iter().flat_map(|agent| agent.with.iter().cloned());
            agents
                .iter()
                .map(|agent| agent.agent.clone())
                .chain(with)
                .collect()
        }
        SearchEvent::Impossible(cannot) if !cannot.agents.is_empty() => cannot.agents.clone(),
        _ => {
            let (view, _) = alone(state)?;
            limits(&view.core)
                .into_iter()
                .map(|limit| limit.agent)
                .collect()
        }
    };
    Some(names.iter().filter_map(|name| index(state, name)).collect())
}

/// What is drawn of a step.
pub(crate) fn overlay(overlay: &mut Overlay, state: &State) {
    overlay.lit = lit(state);
    let Some(told) = told(state) else {
        return;
    };
    let grid = state.document.draft.grid();
    let size = (grid.width(), grid.height());
    let regions = told
        .regions
        .iter()
        .filter(|region| !region.cells.is_empty());
    for region in regions.take(SHADES) {
        let Some(agent) = index(state, &region.agent) else {
            continue;
        };
        let mut is_in = vec![false; (size.0 * size.1) as usize];
        let place = |cell: Cell| (cell.y * size.0 + cell.x) as usize;
        for times in &region.cells {
            if let Some(is_in) = is_in.get_mut(place(times.cell)) {
                *is_in = true;
            }
        }
        let has = |cell: Cell| is_in.get(place(cell)).copied().unwrap_or(false);
        overlay.shades.push(Shade {
            agent,
            path: shade(size, has),
        });
    }
    let meetings = told.meetings.iter().take(MEETINGS);
    overlay.meetings = meetings.map(|meeting| mark(meeting, size.0)).collect();
}

fn mark(meeting: &MustMeet, width: u32) -> Meeting {
    let at = match meeting.kind {
        MeetingKind::Vertex { cell } | MeetingKind::Target { cell } => middle(cell),
        MeetingKind::Swap { edge } => between(edge),
    };
    // Beside it, where the map has room.
    let is_left = at.0 + 300.0 > f64::from(width) * CELL && at.0 > 300.0;
    Meeting {
        at,
        is_left,
        text: tr!("time {time}", time = meeting.time),
    }
}
