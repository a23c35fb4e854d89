//! The size of the floor: counted before it is so.

use super::document::edit;
use super::stroke;
use crate::edit::{Lost, Reshape, Sides};
use crate::grow::{GrowAction, Growing, Side, losses};
use crate::{Edit, MAX_SIDE, Selection, State};

#[inline(never)]
pub(super) fn grow(state: &mut State, action: GrowAction) {
    if let (GrowAction::To(width, height), false) = (action, state.can_grow()) {
        return edit(state, Edit::Resize(width, height));
    }
    if !state.can_grow() {
        return;
    }
    match action {
        GrowAction::Open => open(state, Reshape::Sides(Sides::default())),
        GrowAction::Side(side, more) => {
            if let Some(growing) = state.view.growing {
                let (least, most) = state.side_limits(side);
                if (least..=most).contains(&more) {
                    state.view.growing = Some(growing.with(side, more));
                }
            }
        }
        GrowAction::Step(side, by) => {
            if let Some(growing) = state.view.growing {
                let (least, most) = state.side_limits(side);
                let more = side.of(growing.sides()).saturating_add(by);
                state.view.growing = Some(growing.with(side, more.min(most).max(least)));
            }
        }
        GrowAction::Hold => {
            if let Some(growing) = &mut state.view.growing {
                growing.held = Some(growing.sides());
            }
        }
        GrowAction::Drag(side, more) => {
            if let Some(growing) = state.view.growing.filter(|growing| growing.held.is_some()) {
                let (least, most) = state.side_limits(side);
                let more = more.min(most).max(least);
                state.view.growing = Some(growing.with(side, more));
            }
        }
        GrowAction::Release => let_go(state, false),
        GrowAction::Abandon => let_go(state, true),
        GrowAction::To(width, height) => {
            let grid = state.document.draft.grid();
            let more = |to: u32, from: u32| {
                i32::try_from(i64::from(to.clamp(1, MAX_SIDE)) - i64::from(from)).unwrap_or(0)
            };
            let sides = Sides {
                right: more(width, grid.width()),
                bottom: more(height, grid.height()),
                ..Sides::default()
            };
            begin(state, Reshape::Sides(sides));
        }
        GrowAction::Lines(lines) => {
            if state.can_take(lines) {
                begin(state, Reshape::Lines(lines));
            }
        }
        GrowAction::Lost(lost) => {
            if let Some(growing) = &mut state.view.growing {
                growing.lost = lost;
            }
        }
        GrowAction::Make => keep(state),
        GrowAction::Cancel => state.view.growing = None,
    }
}

/// The floor gets its size at once where nothing is lost; else it is asked what becomes of that.
fn begin(state: &mut State, to: Reshape) {
    if !losses(state, to).is_empty() {
        return open(state, to);
    }
    if let Reshape::Lines(_) = to {
        // Other cells lie there then.
        state.view.area = None;
    }
    edit(state, Edit::Grow(to, Lost::Move));
}

fn open(state: &mut State, to: Reshape) {
    super::board::select(state, Selection::Nothing);
    stroke::release(state);
    state.view.area = None;
    state.view.growing = Some(Growing::new(to));
}

/// The hand leaves the side that it holds; `goes_back` undoes the drag.
fn let_go(state: &mut State, goes_back: bool) {
    if let Some(growing) = &mut state.view.growing {
        let held = growing.held.take();
        if let Some(sides) = held.filter(|_| goes_back) {
            growing.to = Reshape::Sides(sides);
        }
    }
}

/// Whether the floor has at least a row and a column then, and not too many.
fn is_possible(state: &State, to: Reshape) -> bool {
    let sides = match to {
        Reshape::Sides(sides) => sides,
        Reshape::Lines(lines) => return state.can_take(lines),
    };
    let grid = state.document.draft.grid();
    Side::ALL.into_iter().all(|side| {
        let (least, most) = side.limits(sides, grid);
        (least..=most).contains(&side.of(sides))
    })
}

/// The floor gets its size, as one step of undo.
pub(super) fn keep(state: &mut State) {
    if let Some(Growing { to, lost, .. }) = state.view.growing.take() {
        edit(state, Edit::Grow(to, lost));
    }
}

/// A size on its way goes where something else is looked at.
pub(super) fn settle(state: &mut State) {
    let is_possible = state
        .view
        .growing
        .is_none_or(|growing| is_possible(state, growing.to));
    if !is_possible || !state.can_grow() || state.view.selection != Selection::Nothing {
        state.view.growing = None;
    }
}
