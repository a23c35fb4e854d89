//! The fill of a region: where a shape is cut it reaches a little over the border.

use super::path::{Corner, Units, close, inside};
use super::walk::{At, Cells, SIDES, left, right};
use super::{Pen, Region};

impl Region {
    /// The `d` of a path that fills the set. Cells that share a side are one shape;
    /// those that meet in a corner only stay apart. A hole runs the other way round,
    /// so that it is not filled.
    pub fn fill(&self, pen: Pen) -> String {
        let mut path = String::new();
        if !self.cells.has.contains(&true) {
            return path;
        }
        let cells = self.joined();
        // The upper sides that a walk went along: every outline and hole has one.
        let mut walked = vec![false; cells.has.len()];
        for begin in cells.all() {
            if walked[cells.index(begin)] || !cells.has(begin) || !cells.is_free(begin, 0) {
                continue;
            }
            let (mut at, mut side) = (begin, 0);
            let mut corners = Vec::new();
            loop {
                if side == 0 {
                    walked[cells.index(at)] = true;
                }
                let next = cells.next(at, side);
                if next.1 == side {
                    corners.extend(self.step(&cells, (at, side), next.0, pen));
                } else {
                    corners.push(self.cut_corner(&cells, (at, side), next, pen));
                }
                (at, side) = next;
                if (at, side) == (begin, 0) {
                    break;
                }
            }
            close(&corners, &mut path);
        }
        path
    }

    /// The cells of the area, and around it those that they go on in: what is drawn
    /// of these is only covered where the next tile draws them.
    fn joined(&self) -> Cells {
        let mut cells = self.cells.clone();
        let edges = |at: At| {
            let is_across = at.0 == 0 || at.0 + 1 == self.cells.width;
            let is_down = at.1 == 0 || at.1 + 1 == self.cells.height;
            usize::from(is_across) + usize::from(is_down)
        };
        // Cells beside the area first, then those beyond its corners.
        for count in [1, 2] {
            for at in self.cells.all().filter(|&at| edges(at) == count) {
                let nearer = SIDES.iter().filter_map(|&side| cells.towards(at, side));
                let mut nearer = nearer.filter(|&next| edges(next) < count);
                let goes_on = nearer.all(|next| cells.has(next));
                let index = cells.index(at);
                cells.has[index] &= goes_on;
            }
        }
        cells
    }

    /// Where a side of the fill ends: not far beyond the border of the area.
    fn cut_end(&self, at: At, side: usize, pen: Pen) -> Units {
        let clamped = |place: i64, first: u32, size: u32| {
            let (begin, end) = (100 * i64::from(first), 100 * i64::from(first + size));
            place.clamp(begin - pen.overlap, end + pen.overlap)
        };
        let (x, y) = self.end(at, side);
        (
            clamped(x, self.area.first.x, self.area.size.0),
            clamped(y, self.area.first.y, self.area.size.1),
        )
    }

    /// Whether a side of the fill is where a shape is cut.
    fn is_cut(&self, at: At, side: usize) -> bool {
        self.cells.towards(at, left(side)).is_none()
    }

    /// How far a side of the fill stays inside of its cell. What reaches over the
    /// border is a little narrower where the shape goes straight on: its own edges
    /// would be drawn twice, and seen.
    fn cut_inset(&self, cells: &Cells, at: At, side: usize, pen: Pen) -> i64 {
        if self.is_cut(at, side) {
            return 0;
        }
        let mut beside = SIDES.iter().filter_map(|&side| cells.towards(at, side));
        let inner = beside.find(|&inner| self.is_inside(inner));
        let inner = inner.filter(|_| !self.is_inside(at));
        match inner {
            Some(inner) if cells.is_free(inner, side) => pen.inset + pen.overlap / 4,
            _ => pen.inset,
        }
    }

    /// A corner of the fill, at the end of a side. Where a shape is cut it is sharp.
    fn cut_corner(&self, cells: &Cells, now: (At, usize), next: (At, usize), pen: Pen) -> Corner {
        let end = self.cut_end(now.0, now.1, pen);
        let from = inside(end, now.1, self.cut_inset(cells, now.0, now.1, pen));
        let is_sharp = self.is_cut(now.0, now.1) || self.is_cut(next.0, next.1);
        Corner {
            at: inside(from, next.1, self.cut_inset(cells, next.0, next.1, pen)),
            from: now.1,
            to: next.1,
            radius: if is_sharp { 0 } else { pen.radius },
        }
    }

    /// Where a side of the fill goes straight on in the next cell: a step, where it
    /// is narrower from there on, or wider.
    fn step(&self, cells: &Cells, (at, side): (At, usize), next: At, pen: Pen) -> Vec<Corner> {
        let inset = |at| self.cut_inset(cells, at, side, pen);
        let (before, after) = (inset(at), inset(next));
        if before == after {
            return Vec::new();
        }
        let turn = if after > before {
            right(side)
        } else {
            left(side)
        };
        let end = self.cut_end(at, side, pen);
        let corner = |inset, from, to| Corner {
            at: inside(end, side, inset),
            from,
            to,
            radius: 0,
        };
        vec![corner(before, side, turn), corner(after, turn, side)]
    }
}
