//! Cells of the map as one soft shape.

use giveway_model::Cell;

use giveway_picture::{Area, Pen, Region};

/// How far it stays inside of its cells, and the radius of its corners, in units.
const PEN: Pen = Pen {
    inset: 4,
    radius: 18,
    overlap: 0,
};

/// The `d` of the outline of the cells that are in a set, of a map of a size.
pub(crate) fn shade(size: (u32, u32), has: impl Fn(Cell) -> bool) -> String {
    let first = Cell::new(0, 0);
    Region::new(Area { first, size }, has).fill(PEN)
}
