//! A hand on an area: it draws a frame, stretches it, or moves what is on it.

use std::collections::BTreeSet;

use giveway_model::{Cell, Grid};

use super::{Area, Frame, frame, rectangle};

/// A hand on an area.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Hand {
    /// What it does.
    pub(crate) holds: Holds,
    /// The area as it was.
    pub(crate) before: Option<Area>,
}

/// What a hand on an area does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds {
    /// It draws a frame from a cell.
    Frame(Cell, Frame),
    /// It stretches a side or a corner.
    Side(i8, i8),
    /// It moves the area, from a cell.
    All(Cell),
}

impl Hand {
    /// The area when the hand has come to a cell.
    pub(crate) fn at(&self, cell: Cell, grid: &Grid) -> Option<Area> {
        match self.holds {
            Holds::Frame(from, frame) => {
                let drawn = rectangle(from, cell);
                let before = self.before.as_ref().map(|area| (*area.cells).clone());
                let mut cells = match frame {
                    Frame::Replace => BTreeSet::new(),
                    Frame::Add | Frame::Take => before.unwrap_or_default(),
                };
                match frame {
                    Frame::Replace | Frame::Add => cells.extend(drawn),
                    Frame::Take => drawn.for_each(|cell| {
                        cells.remove(&cell);
                    }),
                }
                Area::of(cells)
            }
            Holds::Side(right, down) => {
                let [x0, y0, x1, y1] = frame(&self.before.as_ref()?.cells);
                let ends = |side: i8, first: u32, last: u32, at: u32| match side {
                    ..0 => (at, last),
                    0 => (first, last),
                    1.. => (first, at),
                };
                let (x0, x1) = ends(right, x0, x1, cell.x);
                let (y0, y1) = ends(down, y0, y1, cell.y);
                Area::of(rectangle(Cell::new(x0, y0), Cell::new(x1, y1)).collect())
            }
            Holds::All(from) => {
                let before = self.before.clone()?;
                let go = |to: u32, from: u32, by: i32| {
                    let by = i64::from(by) + i64::from(to) - i64::from(from);
                    i32::try_from(by).unwrap_or(0)
                };
                let by = (
                    go(cell.x, from.x, before.by.0),
                    go(cell.y, from.y, before.by.1),
                );
                Some(before.moved(by, grid))
            }
        }
    }
}
