//! A selected part of the floor: framed by hand or keys, and what is done with it.

mod made;
mod paste;

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::{Cell, tr_data};

use super::stroke;
use crate::area::{Area, AreaAction, Clip, Doing, Frame, Hand, Holds, Repeat, Way, frame};
use crate::edit::AreaEdit;
use crate::gesture::Gesture;
use crate::{Axis, Edit, Notice, Selection, State};

pub(crate) use made::copies;
pub(super) use made::keep;
use made::make;

/// How far a key goes with Shift, in cells.
const FAR: i32 = 5;

#[inline(never)]
pub(super) fn area(state: &mut State, action: AreaAction) {
    if !state.can_select_area() {
        return;
    }
    match action {
        AreaAction::Begin(cell, frame) => begin(state, cell, frame),
        AreaAction::Grab(cell) => take(state, Holds::All(cell), cell),
        AreaAction::Stretch(right, down) => {
            take(state, Holds::Side(right, down), state.view.cursor);
        }
        AreaAction::All => {
            stroke::release(state);
            keep(state);
            let cells = state.document.draft.grid().cells().map(|(cell, _)| cell);
            select(state, Area::of(cells.collect()));
        }
        AreaAction::Line(axis, at, frame) => line(state, (axis, at), frame),
        AreaAction::Nudge(right, down) => nudge(state, (right, down)),
        AreaAction::Copy => {
            if let Some(area) = standing(state) {
                let clip = Clip::of(&area.cells, &state.document.draft);
                state.view.clip = Some(Rc::new(clip));
                state.view.notice = Some(Notice::information(tr_data!(
                    "{n} cell copied." | "{n} cells copied." % area.cells.len()
                )));
            }
        }
        AreaAction::Paste => paste::paste(state),
        AreaAction::Mirror(across) => {
            turn(state, |area| Way::mirror(frame(&area.cells), across));
        }
        AreaAction::Turn => {
            let grid = state.document.draft.grid();
            let board = (grid.width(), grid.height());
            turn(state, |area| Way::turn(frame(&area.cells), board));
        }
        AreaAction::Repeat(on) => {
            if let Some(area) = standing(state) {
                let repeat = Repeat::of(frame(&area.cells));
                let doing = if on {
                    Doing::Repeats(repeat)
                } else {
                    Doing::Moves
                };
                state.view.area = Some(Area { doing, ..area });
            }
        }
        AreaAction::Copies(copies) => {
            repeat(state, |repeat| {
                repeat.copies = copies.clamp(1, crate::area::MOST_COPIES);
            });
        }
        AreaAction::Step(step) => {
            repeat(state, |repeat| {
                repeat.step = step.clamp(1, crate::area::FARTHEST);
            });
        }
        AreaAction::To(to) => {
            if let Some(frame) = state.view.area.as_ref().map(|area| frame(&area.cells)) {
                repeat(state, |repeat| *repeat = repeat.turned(to, frame));
            }
        }
        AreaAction::Erase => {
            if let Some(area) = standing(state) {
                make(state, &[Edit::Area(AreaEdit::Erase(area.cells))]);
            }
        }
        AreaAction::Make => paste::make(state),
        AreaAction::Drop => match state.view.area.take() {
            Some(area) if area.has_ghost() && !matches!(area.doing, Doing::Pastes(_)) => {
                state.view.area = Some(without_ghost(area));
            }
            Some(_) | None => {}
        },
    }
}

/// A column or a row is selected, or comes to the area that there is, or goes from it.
#[inline(never)]
fn line(state: &mut State, (axis, at): (Axis, u32), frame: Frame) {
    stroke::release(state);
    keep(state);
    let cells = state.document.draft.grid().cells().map(|(cell, _)| cell);
    let is_on = |cell: &Cell| match axis {
        Axis::Columns => cell.x == at,
        Axis::Rows => cell.y == at,
    };
    let line: BTreeSet<Cell> = cells.filter(is_on).collect();
    let before = state.view.area.take();
    let before = before.map_or_else(BTreeSet::new, |area| (*area.cells).clone());
    let cells = match frame {
        Frame::Replace => line,
        Frame::Add => &before | &line,
        Frame::Take => &before - &line,
    };
    select(state, Area::of(cells));
}

/// A frame begins: what was a ghost is made first.
fn begin(state: &mut State, cell: Cell, frame: Frame) {
    stroke::release(state);
    keep(state);
    let cell = state.document.draft.clamp(cell);
    let before = state.view.area.take();
    select(state, before);
    take(state, Holds::Frame(cell, frame), cell);
}

fn take(state: &mut State, holds: Holds, cell: Cell) {
    let before = match holds {
        Holds::Frame(..) | Holds::All(_) => state.view.area.clone(),
        // What is stretched has no ghost.
        Holds::Side(..) => state.view.area.take().map(without_ghost),
    };
    if before.is_none() && !matches!(holds, Holds::Frame(..)) {
        return;
    }
    state.view.notice = None;
    state.view.gesture = Gesture::Area(Rc::new(Hand { holds, before }));
    if matches!(holds, Holds::Frame(..)) {
        drag(state, cell);
    } else if matches!(holds, Holds::Side(..)) {
        state.view.area = state.hand().and_then(|hand| hand.before.clone());
    }
}

/// The hand has come to a cell.
pub(super) fn drag(state: &mut State, cell: Cell) {
    let grid = state.document.draft.grid();
    let Some(area) = state.hand().map(|hand| hand.at(cell, grid)) else {
        return;
    };
    // A hand that takes all of an area away may give it back.
    state.view.area = area;
    state.view.cursor = cell;
}

/// The hand is lifted: what it moved is made.
pub(super) fn release(state: &mut State, hand: &Hand) {
    if let Holds::All(_) = hand.holds {
        let is_moved = state.view.area.as_ref().map(|area| area.by)
            != hand.before.as_ref().map(|area| area.by);
        if is_moved {
            keep(state);
        }
    }
}

/// The area as it was before the hand.
pub(super) fn abandon(state: &mut State, hand: &Hand) {
    state.view.area.clone_from(&hand.before);
}

/// The keyboard: with nothing selected, Shift and arrows draw a frame from the cursor.
pub(super) fn step(state: &mut State, by: (i32, i32), carries: bool) -> bool {
    if state.hand().is_some() {
        let Cell { x, y } = state.view.cursor;
        let to = Cell::new(x.saturating_add_signed(by.0), y.saturating_add_signed(by.1));
        let to = state.document.draft.clamp(to);
        if carries {
            drag(state, to);
            return true;
        }
        stroke::release(state);
    }
    if state.area().is_some() {
        let far = if carries { FAR } else { 1 };
        nudge(state, (by.0.saturating_mul(far), by.1.saturating_mul(far)));
        return true;
    }
    let cursor = state.view.cursor;
    if !carries || !state.can_select_area() || state.can_move(cursor) {
        return false;
    }
    begin(state, cursor, Frame::Replace);
    let to = Cell::new(
        cursor.x.saturating_add_signed(by.0),
        cursor.y.saturating_add_signed(by.1),
    );
    drag(state, state.document.draft.clamp(to));
    true
}

fn nudge(state: &mut State, (right, down): (i32, i32)) {
    let Some(area) = state.view.area.take() else {
        return;
    };
    let by = (
        area.by.0.saturating_add(right),
        area.by.1.saturating_add(down),
    );
    let area = match area.doing {
        Doing::Repeats(_) => without_ghost(area),
        Doing::Moves | Doing::Pastes(_) => area,
    };
    state.view.area = Some(area.moved(by, state.document.draft.grid()));
}

fn select(state: &mut State, area: Option<Area>) {
    super::board::select(state, Selection::Nothing);
    state.view.area = area;
}

fn repeat(state: &mut State, change: impl FnOnce(&mut Repeat)) {
    if let Some(Area {
        doing: Doing::Repeats(repeat),
        ..
    }) = &mut state.view.area
    {
        change(repeat);
    }
}

/// The area where it stands, without a hand on it and with its ghost made.
fn standing(state: &mut State) -> Option<Area> {
    stroke::release(state);
    let is_repeat = |area: &Area| matches!(area.doing, Doing::Repeats(_));
    match state.view.area.as_ref() {
        Some(area) if is_repeat(area) => {}
        Some(_) | None => keep(state),
    }
    state.view.area.clone().map(without_ghost)
}

fn without_ghost(area: Area) -> Area {
    Area {
        by: (0, 0),
        doing: Doing::Moves,
        ..area
    }
}

/// Moves what is on the area within its frame; what is being pasted turns before it is made.
fn turn(state: &mut State, way: impl Fn(&Area) -> Way) {
    stroke::release(state);
    if let Some(turned) = paste::turned(state, &way) {
        state.view.area = Some(turned);
        return;
    }
    let Some(area) = standing(state) else { return };
    let way = way(&area);
    if make(
        state,
        &[Edit::Area(AreaEdit::Move(Rc::clone(&area.cells), way))],
    ) {
        state.view.area = Area::of(area.cells.iter().filter_map(|&cell| way.of(cell)).collect());
    }
}

/// The area goes where another thing is selected or done, and with cells that are gone.
pub(super) fn settle(state: &mut State) {
    let Some(area) = &state.view.area else { return };
    let grid = state.document.draft.grid();
    let [.., x1, y1] = area.frame();
    let fits = x1 < grid.width() && y1 < grid.height();
    if !fits || !state.can_select_area() || state.view.selection != Selection::Nothing {
        state.view.area = None;
        if state.hand().is_some() {
            state.view.gesture = Gesture::None;
        }
    }
}
