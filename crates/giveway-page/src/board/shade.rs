//! Cells of the map as one soft shape.

use std::collections::BTreeSet;

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

/// The same of some cells of a large map, so far inside of them.
pub(crate) fn outline(cells: &BTreeSet<Cell>, inset: i64) -> String {
    let all = || cells.iter().copied();
    let first = all().reduce(|a, b| Cell::new(a.x.min(b.x), a.y.min(b.y)));
    let last = all().reduce(|a, b| Cell::new(a.x.max(b.x), a.y.max(b.y)));
    let (Some(first), Some(last)) = (first, last) else {
        return String::new();
    };
    let size = (last.x - first.x + 1, last.y - first.y + 1);
    let pen = Pen {
        inset,
        radius: 12,
        overlap: 0,
    };
    Region::new(Area { first, size }, |cell| cells.contains(&cell)).fill(pen)
}
