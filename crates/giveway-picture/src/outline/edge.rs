//! The line around a region: closed around a whole shape, open where a shape is cut.

use std::fmt::Write;

use super::path::{Corner, along, close, inside, straight};
use super::walk::{At, SIDES};
use super::{Pen, Region};

impl Region {
    /// The `d` of a path along the outline of the set, as far as it goes along cells
    /// of the area.
    pub fn edge(&self, pen: Pen) -> String {
        let mut path = String::new();
        let cells = &self.cells;
        let inside = || {
            cells
                .all()
                .filter(|&at| self.is_inside(at) && cells.has(at))
        };
        let sides = || {
            let sides = inside().flat_map(|at| SIDES.map(|side| (at, side)));
            sides.filter(|&(at, side)| cells.is_free(at, side))
        };
        let mut walked = vec![[false; 4]; cells.has.len()];
        let comes_in = |&(at, side): &(At, usize)| !self.is_inside(cells.before(at, side).0);
        // What comes from another tile first: what is left are closed shapes.
        for begin in sides().filter(comes_in).chain(sides()) {
            if walked[cells.index(begin.0)][begin.1] {
                continue;
            }
            let (mut now, mut corners) = (begin, Vec::new());
            let is_closed = loop {
                walked[cells.index(now.0)][now.1] = true;
                let next = cells.next(now.0, now.1);
                if next.1 != now.1 {
                    corners.push(self.corner(now, next.1, pen));
                }
                if next == begin {
                    break true;
                }
                if !self.is_inside(next.0) {
                    break false;
                }
                now = next;
            };
            if is_closed {
                close(&corners, &mut path);
            } else {
                self.open(begin, now, &corners, pen, &mut path);
            }
        }
        path
    }

    /// A line that comes from another tile along its first side and leaves the area
    /// after its last one.
    fn open(
        &self,
        first: (At, usize),
        last: (At, usize),
        corners: &[Corner],
        pen: Pen,
        path: &mut String,
    ) {
        let before = self.cells.before(first.0, first.1);
        let begin = if before.1 == first.1 {
            inside(self.end(before.0, before.1), first.1, pen.inset)
        } else {
            self.corner(before, first.1, pen).end()
        };
        let next = self.cells.next(last.0, last.1);
        let end = match corners.last() {
            Some(corner) if next.1 != last.1 => corner.end(),
            _ => inside(self.end(last.0, last.1), last.1, pen.inset),
        };
        // Writing to a string cannot fail.
        let _ = write!(path, "M{} {}", begin.0, begin.1);
        for corner in corners {
            corner.draw(path);
        }
        straight(along(end, next.1, pen.overlap), next.1, path);
    }

    /// The corner of the outline at the end of a side.
    fn corner(&self, (at, from): (At, usize), to: usize, pen: Pen) -> Corner {
        Corner {
            at: inside(inside(self.end(at, from), from, pen.inset), to, pen.inset),
            from,
            to,
            radius: pen.radius,
        }
    }
}
