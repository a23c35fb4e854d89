//! The path data of outlines: straight sides and round corners, in units of the map.

use std::fmt::Write;

use super::walk::{ahead, left, right};

/// A point of the map: across and down, in units.
pub(super) type Units = (i64, i64);

/// A point moved along a side.
pub(super) const fn along((x, y): Units, side: usize, by: i64) -> Units {
    let (across, down) = ahead(side);
    (x + by * across, y + by * down)
}

/// A point moved from a side into the shape.
pub(super) const fn inside(at: Units, side: usize, by: i64) -> Units {
    along(at, left(side), -by)
}

/// A corner of an outline.
pub(super) struct Corner {
    pub(super) at: Units,
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) radius: i64,
}

impl Corner {
    /// Where the next side begins.
    pub(super) const fn end(&self) -> Units {
        along(self.at, self.to, self.radius)
    }

    /// Goes on along its side, and around it.
    pub(super) fn draw(&self, path: &mut String) {
        let (x, y) = along(self.at, self.from, -self.radius);
        straight((x, y), self.from, path);
        if self.radius > 0 {
            let end = self.end();
            let outwards = u8::from(self.to == right(self.from));
            let (dx, dy, radius) = (end.0 - x, end.1 - y, self.radius);
            // Writing to a string cannot fail.
            let _ = write!(path, "a{radius} {radius} 0 0 {outwards} {dx} {dy}");
        }
    }
}

/// Goes on to a point along a side.
pub(super) fn straight((x, y): Units, side: usize, path: &mut String) {
    // Writing to a string cannot fail.
    let _ = match side % 2 {
        0 => write!(path, "H{x}"),
        _ => write!(path, "V{y}"),
    };
}

pub(super) fn close(corners: &[Corner], path: &mut String) {
    let Some(last) = corners.last() else { return };
    let (x, y) = last.end();
    // Writing to a string cannot fail.
    let _ = write!(path, "M{x} {y}");
    for corner in corners {
        corner.draw(path);
    }
    path.push('Z');
}
