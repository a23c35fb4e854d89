//! What is seen of a step of the proof on the board: its robots, where they can be,
//! and where they get into each other's way.

use giveway_model::Cell;
use giveway_solve::together::MeetingKind;
use giveway_solve::trace::SearchEvent;

use super::chosen_event;
use crate::State;
use crate::board::shade;
use crate::inside::board::{Meeting, Overlay, Shade, middle};
use crate::inside::index;

/// The robots that a step is about; `None` where it is about all.
fn lit(state: &State) -> Option<Vec<usize>> {
    let names: Vec<&String> = match &chosen_event(state)?.event {
        SearchEvent::Core(core) => match (&core.together, core.sums.is_empty()) {
            (Some(together), false) => together.agents.iter().map(|own| &own.agent).collect(),
            _ => core.limits.iter().map(|limit| &limit.agent).collect(),
        },
        SearchEvent::Entered { agents } => {
            let with = agents.iter().flat_map(|agent| &agent.with);
            agents.iter().map(|agent| &agent.agent).chain(with).collect()
        }
        SearchEvent::Impossible(cannot) if !cannot.agents.is_empty() => {
            cannot.agents.iter().collect()
        }
        _ => return None,
    };
    Some(names.into_iter().filter_map(|name| index(state, name)).collect())
}

/// What is drawn of a step.
pub(crate) fn overlay(overlay: &mut Overlay, state: &State) {
    overlay.lit = lit(state);
    let Some(event) = chosen_event(state) else {
        return;
    };
    let looked = state.looked();
    let together = looked.and_then(|looked| looked.together.get(&event.number));
    let Some(Ok(told)) = together.filter(|_| state.inside.alone.is_none()) else {
        return;
    };
    let grid = state.document.draft.grid();
    let size = (grid.width(), grid.height());
    for region in told.regions.iter().filter(|region| !region.cells.is_empty()) {
        let Some(agent) = index(state, &region.agent) else {
            continue;
        };
        let has = |cell: Cell| region.cells.iter().any(|times| times.cell == cell);
        overlay.shades.push(Shade {
            agent,
            path: shade(size, has),
        });
    }
    for meeting in &told.meetings {
        let at = match meeting.kind {
            MeetingKind::Vertex { cell } | MeetingKind::Target { cell } => middle(cell),
            MeetingKind::Swap { edge: [a, b] } => {
                let ((x, y), (u, v)) = (middle(a), middle(b));
                (f64::midpoint(x, u), f64::midpoint(y, v))
            }
        };
        // Beside it, where the map has room.
        let aside = if at.0 + 200.0 > f64::from(size.0) * 100.0 { -122.0 } else { 122.0 };
        overlay.meetings.push(Meeting {
            at,
            label: (at.0 + aside, at.1),
            text: format!("time {}", meeting.time),
        });
    }
}
