//! Columns and rows that can come or go where something is selected.

use giveway_model::{Cell, tr};

use crate::edit::{Axis, Lines};
use crate::{MAX_SIDE, Selection, State};

/// Columns or rows that can come or go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineOffer {
    /// What it does.
    pub name: String,
    /// Which come or go.
    pub lines: Lines,
}

/// What can come and go beside the cell or the part of the floor that is selected: as many
/// columns and rows as that has. Nothing where nothing is selected.
pub fn offers(state: &State) -> Vec<LineOffer> {
    let Some([x0, y0, x1, y1]) = selected(state).filter(|_| state.can_grow()) else {
        return Vec::new();
    };
    let grid = state.document.draft.grid();
    let [across, down] = [x1 - x0 + 1 == grid.width(), y1 - y0 + 1 == grid.height()];
    // Of whole columns columns come and go, of whole rows rows.
    let axes = [(Axis::Columns, x0, x1), (Axis::Rows, y0, y1)].into_iter();
    let axes = axes.filter(|(axis, ..)| match axis {
        Axis::Columns => down || !across,
        Axis::Rows => across || !down,
    });
    let offers = axes.map(|(axis, first, last)| {
        let count = last - first + 1;
        let more = i32::try_from(count).unwrap_or(i32::MAX);
        let come = |at| Lines { axis, at, more };
        let (before, after, gone) = match axis {
            Axis::Columns => (
                tr!("Insert {n} column left" | "Insert {n} columns left" % count),
                tr!("Insert {n} column right" | "Insert {n} columns right" % count),
                match count {
                    1 => tr!("Remove column {first}", first),
                    _ => tr!("Remove columns {first} to {last}", first, last),
                },
            ),
            Axis::Rows => (
                tr!("Insert {n} row above" | "Insert {n} rows above" % count),
                tr!("Insert {n} row below" | "Insert {n} rows below" % count),
                match count {
                    1 => tr!("Remove row {first}", first),
                    _ => tr!("Remove rows {first} to {last}", first, last),
                },
            ),
        };
        let go = Lines {
            more: more.saturating_neg(),
            ..come(first)
        };
        [(before, come(first)), (after, come(last + 1)), (gone, go)]
    });
    let all = offers.flatten();
    let all = all.filter(|(_, lines)| state.can_take(*lines));
    all.map(|(name, lines)| LineOffer { name, lines }).collect()
}

/// The same where whole columns or rows are selected: it is what they are selected for.
pub fn offers_of_lines(state: &State) -> Vec<LineOffer> {
    let grid = state.document.draft.grid();
    let is_lines = state.area().is_some_and(|area| {
        let [x0, y0, x1, y1] = area.frame();
        let is_whole = x1 - x0 + 1 == grid.width() || y1 - y0 + 1 == grid.height();
        area.is_rectangle() && is_whole
    });
    if is_lines { offers(state) } else { Vec::new() }
}

/// The first and last column and row of what is selected.
fn selected(state: &State) -> Option<[u32; 4]> {
    if let Some(area) = state.area() {
        return (!area.has_ghost()).then(|| area.frame());
    }
    match state.view.selection {
        Selection::Cell(Cell { x, y }) => Some([x, y, x, y]),
        Selection::Agent(_) | Selection::Nothing => None,
    }
}

impl State {
    /// Whether such columns or rows can come or go: one of each is left, and there are at most
    /// [`MAX_SIDE`].
    pub(crate) fn can_take(&self, lines: Lines) -> bool {
        let grid = self.document.draft.grid();
        let length = match lines.axis {
            Axis::Columns => grid.width(),
            Axis::Rows => grid.height(),
        };
        let count = u64::from(lines.count());
        match lines.more {
            ..0 => u64::from(lines.at) + count <= u64::from(length) && count < u64::from(length),
            0 => false,
            1.. => lines.at <= length && u64::from(length) + count <= u64::from(MAX_SIDE),
        }
    }
}

impl Lines {
    /// The first cell of those that move.
    pub(super) const fn behind(self) -> Cell {
        let going = if self.more < 0 { self.count() } else { 0 };
        match self.axis {
            Axis::Columns => Cell::new(self.at.saturating_add(going), 0),
            Axis::Rows => Cell::new(0, self.at.saturating_add(going)),
        }
    }
}
