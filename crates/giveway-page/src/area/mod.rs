//! A selected part of the floor: what is on it is moved, copied, mirrored, turned, repeated or
//! erased as a whole.

mod clip;
mod drawn;
mod hand;
mod repeat;
mod shown;
#[cfg(test)]
mod tests;
mod way;

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::{Cell, Grid};

use crate::{Axis, State, Tool};

pub(crate) use clip::{Clip, ground};
pub(crate) use hand::{Hand, Holds};
pub use repeat::{Direction, FARTHEST, MOST_COPIES, Repeat};
pub use shown::{Card, Ghost, Shown, card, shown};
pub(crate) use way::Way;

/// What a person does with an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaAction {
    /// A frame begins at a cell.
    Begin(Cell, Frame),
    /// The area is taken hold of at a cell, to be moved.
    Grab(Cell),
    /// A side or a corner of its frame is taken hold of: -1 is left and above, 1 right and
    /// below, 0 neither.
    Stretch(i8, i8),
    /// All of the floor.
    All,
    /// A column or a row, by its number.
    Line(Axis, u32, Frame),
    /// It goes so many cells right and down, until that is made or dropped.
    Nudge(i32, i32),
    /// What is on it is remembered.
    Copy,
    /// What was remembered comes to the cursor, until that is made or dropped.
    Paste,
    /// It is mirrored: left and right change places (`true`), or above and below.
    Mirror(bool),
    /// It is turned right by a quarter.
    Turn,
    /// It is to be repeated, or not any longer.
    Repeat(bool),
    /// So many copies.
    Copies(u32),
    /// From one copy to the next, in cells.
    Step(u32),
    /// Where the copies go.
    To(Direction),
    /// What is on it goes.
    Erase,
    /// What stands as a ghost is made.
    Make,
    /// The ghost is dropped; without one, the area is.
    Drop,
}

/// What a frame does to the area that there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// It takes its place.
    Replace,
    /// It is added.
    Add,
    /// It is taken away.
    Take,
}

/// A selected part of the floor.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Area {
    /// Its cells, at least one; of something pasted, where they were copied from.
    pub(crate) cells: Rc<BTreeSet<Cell>>,
    /// How far its ghost stands from them: cells right and down.
    pub(crate) by: (i32, i32),
    pub(crate) doing: Doing,
}

/// What a ghost of an area is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Doing {
    /// What is on it, where it goes.
    Moves,
    /// Something that was copied.
    Pastes(Rc<Clip>),
    /// Its copies.
    Repeats(Repeat),
}

impl Area {
    /// An area of cells; `None` without any.
    pub(crate) fn of(cells: BTreeSet<Cell>) -> Option<Self> {
        (!cells.is_empty()).then(|| Self {
            cells: Rc::new(cells),
            by: (0, 0),
            doing: Doing::Moves,
        })
    }

    /// Its first and last column and row: `[x0, y0, x1, y1]`, where its ghost stands.
    pub(crate) fn frame(&self) -> [u32; 4] {
        let [x0, y0, x1, y1] = frame(&self.cells);
        let (dx, dy) = self.by;
        let (x, y) = (
            |x: u32| x.saturating_add_signed(dx),
            |y: u32| y.saturating_add_signed(dy),
        );
        [x(x0), y(y0), x(x1), y(y1)]
    }

    /// Whether it has a ghost, which may be made or dropped.
    pub(crate) fn has_ghost(&self) -> bool {
        match self.doing {
            Doing::Moves => self.by != (0, 0),
            Doing::Pastes(_) | Doing::Repeats(_) => true,
        }
    }

    /// Whether a cell is one of those that it stands on.
    pub(crate) fn has(&self, cell: Cell) -> bool {
        let Cell { x, y } = cell;
        let x = x.checked_add_signed(self.by.0.saturating_neg());
        let y = y.checked_add_signed(self.by.1.saturating_neg());
        x.zip(y)
            .is_some_and(|(x, y)| self.cells.contains(&Cell::new(x, y)))
    }

    /// Whether it is a rectangle: only then it can be stretched.
    pub(crate) fn is_rectangle(&self) -> bool {
        let [x0, y0, x1, y1] = frame(&self.cells);
        self.cells.len() as u64 == u64::from(x1 - x0 + 1) * u64::from(y1 - y0 + 1)
    }

    /// The same as far right and down as it fits on the map.
    pub(crate) fn moved(self, (dx, dy): (i32, i32), grid: &Grid) -> Self {
        let [x0, y0, x1, y1] = frame(&self.cells);
        let within = |by: i32, first: u32, last: u32, side: u32| {
            let least = 0_i32.saturating_sub_unsigned(first);
            let most = 0_i32.saturating_add_unsigned(side.saturating_sub(last.saturating_add(1)));
            by.clamp(least, most.max(least))
        };
        Self {
            by: (
                within(dx, x0, x1, grid.width()),
                within(dy, y0, y1, grid.height()),
            ),
            ..self
        }
    }
}

/// The first and last column and row of some cells.
pub(crate) fn frame(cells: &BTreeSet<Cell>) -> [u32; 4] {
    let first = [u32::MAX, u32::MAX, 0, 0];
    let wider = |[x0, y0, x1, y1]: [u32; 4], &Cell { x, y }: &Cell| {
        [x0.min(x), y0.min(y), x1.max(x), y1.max(y)]
    };
    if cells.is_empty() {
        [0; 4]
    } else {
        cells.iter().fold(first, wider)
    }
}

/// The cells between two corners, both included.
fn rectangle(one: Cell, other: Cell) -> impl Iterator<Item = Cell> {
    let columns = one.x.min(other.x)..=one.x.max(other.x);
    let rows = one.y.min(other.y)..=one.y.max(other.y);
    columns.flat_map(move |x| rows.clone().map(move |y| Cell::new(x, y)))
}

impl State {
    /// Whether parts of the floor can be selected: the scene itself is on the board, with the
    /// tool that selects.
    pub fn can_select_area(&self) -> bool {
        self.view.tool == Tool::Select && self.can_place_fleet()
    }

    /// The area that is selected.
    pub(crate) fn area(&self) -> Option<&Area> {
        self.view.area.as_ref().filter(|_| self.can_select_area())
    }

    /// Whether there is an area.
    pub fn has_area(&self) -> bool {
        self.area().is_some()
    }

    /// Whether a cell is part of the area.
    pub fn is_in_area(&self, cell: Cell) -> bool {
        self.area().is_some_and(|area| area.has(cell))
    }

    /// Whether a cell is all of the area: a finger that stayed there has framed it.
    pub fn is_framed(&self, cell: Cell) -> bool {
        let area = self.area();
        area.is_some_and(|area| area.cells.len() == 1 && area.has(cell))
    }
}

/// What is on the area, as drawn text.
pub fn text(state: &State) -> Option<String> {
    let area = state.area()?;
    Some(Clip::of(&area.cells, &state.document.draft).text())
}

/// Whether the ghost of the area may be made.
pub fn has_ghost(state: &State) -> bool {
    state.area().is_some_and(Area::has_ghost)
}

/// Whether a text is what was copied of a floor last, and may come back to it.
pub fn is_copied(state: &State, text: &str) -> bool {
    let clip = state.view.clip.as_ref().filter(|_| state.can_select_area());
    clip.is_some_and(|clip| clip.text().lines().eq(text.lines()))
}
