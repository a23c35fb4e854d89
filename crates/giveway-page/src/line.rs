//! The cells on the way of a pointer.

use giveway_model::Cell;

/// The cells on the way of a pointer that jumped from one cell to another: each
/// shares a side with the next, so that a fast stroke leaves no gaps.
pub(crate) fn line(from: Cell, to: Cell) -> Vec<Cell> {
    let (width, height) = (from.x.abs_diff(to.x), from.y.abs_diff(to.y));
    let (mut at, mut across, mut down) = (from, 0, 0);
    let mut cells = vec![from];
    while at != to {
        // The direction of which the smaller share is done.
        let (done_across, done_down) = ((2 * across + 1) * height, (2 * down + 1) * width);
        if down == height || (across < width && done_across <= done_down) {
            across += 1;
            at.x = towards(at.x, to.x);
        } else {
            down += 1;
            at.y = towards(at.y, to.y);
        }
        cells.push(at);
    }
    cells
}

const fn towards(at: u32, to: u32) -> u32 {
    if to > at {
        at + 1
    } else {
        at.saturating_sub(1)
    }
}
