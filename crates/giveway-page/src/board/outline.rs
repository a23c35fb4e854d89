//! The outlines of sets of cells: neighbouring cells join into one shape.

use std::fmt::Write;

use giveway_model::Cell;

/// How an outline is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pen {
    /// How far it stays inside of the cells, in units.
    pub(super) inset: i32,
    /// The radius of its corners, in units; 0 draws them sharp.
    pub(super) radius: i32,
}

/// Regions that begin within a block of so many cells a side share a path: few
/// elements, and each small enough to be skipped where it is out of sight.
const BLOCK: u32 = 32;

/// A set of cells of a map.
pub(super) struct Region<'a> {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) contains: &'a dyn Fn(Cell) -> bool,
}

type Step = (i32, i32);

/// Right, down, left, up: walking clockwise, the shape lies to the right.
const AHEAD: [Step; 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];
const UP: usize = 3;

/// The side after a turn to the right, and after one to the left.
const fn right(side: usize) -> usize {
    (side + 1) % 4
}

const fn left(side: usize) -> usize {
    (side + 3) % 4
}

impl Region<'_> {
    /// The `d` of SVG paths that fill the set. Cells that share a side are one
    /// shape; those that meet in a corner only stay apart. A hole runs the
    /// other way round, so that it is not filled.
    pub(super) fn paths(&self, pen: Pen) -> Vec<String> {
        let across = self.width.div_ceil(BLOCK);
        let mut blocks = vec![String::new(); (across * self.height.div_ceil(BLOCK)) as usize];
        let firsts = self.first_cells();
        let mut walked = vec![false; firsts.len()];
        for cell in self.cells() {
            let index = self.index(cell);
            let Some(first) = firsts[index] else { continue };
            if walked[index] || self.beside(cell, UP).is_some() {
                continue;
            }
            let block = (first.y / BLOCK * across + first.x / BLOCK) as usize;
            self.walk(cell, &mut walked, pen, &mut blocks[block]);
        }
        blocks.retain(|path| !path.is_empty());
        blocks
    }

    fn cells(&self) -> impl Iterator<Item = Cell> + use<> {
        let width = self.width;
        (0..self.height).flat_map(move |y| (0..width).map(move |x| Cell::new(x, y)))
    }

    const fn index(&self, cell: Cell) -> usize {
        cell.y as usize * self.width as usize + cell.x as usize
    }

    /// The cell of the set beyond a side of a cell.
    fn beside(&self, cell: Cell, side: usize) -> Option<Cell> {
        let (across, down) = AHEAD[side];
        let x = cell.x.checked_add_signed(across)?;
        let y = cell.y.checked_add_signed(down)?;
        let beside = Cell::new(x, y);
        let is_on_map = x < self.width && y < self.height;
        (is_on_map && (self.contains)(beside)).then_some(beside)
    }

    /// For each cell of the set the first one of its shape, row by row.
    fn first_cells(&self) -> Vec<Option<Cell>> {
        let mut firsts = vec![None; self.width as usize * self.height as usize];
        let mut open = Vec::new();
        for first in self.cells() {
            if firsts[self.index(first)].is_some() || !(self.contains)(first) {
                continue;
            }
            firsts[self.index(first)] = Some(first);
            open.push(first);
            while let Some(cell) = open.pop() {
                for next in (0..4).filter_map(|side| self.beside(cell, side)) {
                    let known = &mut firsts[self.index(next)];
                    if known.is_none() {
                        *known = Some(first);
                        open.push(next);
                    }
                }
            }
        }
        firsts
    }

    /// Walks once around, from the upper side of a cell. `walked` keeps the
    /// upper sides that a walk went along: every outline and hole has one.
    fn walk(&self, begin: Cell, walked: &mut [bool], pen: Pen, path: &mut String) {
        let (mut cell, mut side) = (begin, 0);
        let mut corners = Vec::new();
        loop {
            if side == 0 {
                walked[self.index(cell)] = true;
            }
            let next = self.beside(cell, side);
            let (next_cell, next_side) = match next {
                None => (cell, right(side)),
                Some(next) => match self.beside(next, left(side)) {
                    None => (next, side),
                    Some(inner) => (inner, left(side)),
                },
            };
            if next_side != side {
                corners.push(corner(cell, side, next_side, pen));
            }
            (cell, side) = (next_cell, next_side);
            if (cell, side) == (begin, 0) {
                break;
            }
        }
        draw(&corners, pen, path);
    }
}

/// A corner of an outline.
struct Corner {
    at: (i64, i64),
    from: usize,
    to: usize,
}

/// The corner at the end of a cell's side, moved into the shape.
fn corner(cell: Cell, from: usize, to: usize, pen: Pen) -> Corner {
    // The end of the upper side is the upper right corner, and so on.
    let (across, down) = [(1, 0), (1, 1), (0, 1), (0, 0)][from];
    let (a, b) = (AHEAD[left(from)], AHEAD[left(to)]);
    let at = |cell: u32, end: i64, a: i32, b: i32| {
        100 * (i64::from(cell) + end) - i64::from(pen.inset * (a + b))
    };
    let at = (at(cell.x, across, a.0, b.0), at(cell.y, down, a.1, b.1));
    Corner { at, from, to }
}

fn draw(corners: &[Corner], pen: Pen, path: &mut String) {
    let radius = i64::from(pen.radius);
    let along = |corner: &Corner, side: usize, by: i64| {
        let (across, down) = AHEAD[side];
        let (across, down) = (by * i64::from(across), by * i64::from(down));
        (corner.at.0 + across, corner.at.1 + down)
    };
    // Writing to a string cannot fail.
    let Some(last) = corners.last() else { return };
    let (x, y) = along(last, last.to, radius);
    let _ = write!(path, "M{x} {y}");
    for corner in corners {
        let (x, y) = along(corner, corner.from, -radius);
        let _ = match corner.from % 2 {
            0 => write!(path, "H{x}"),
            _ => write!(path, "V{y}"),
        };
        if radius > 0 {
            let end = along(corner, corner.to, radius);
            let outwards = u8::from(corner.to == right(corner.from));
            let (dx, dy) = (end.0 - x, end.1 - y);
            let _ = write!(path, "a{radius} {radius} 0 0 {outwards} {dx} {dy}");
        }
    }
    path.push('Z');
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHARP: Pen = Pen {
        inset: 0,
        radius: 0,
    };

    #[track_caller]
    fn check(rows: &[&str], pen: Pen, expect: &[&str]) {
        let has = |cell: Cell| rows[cell.y as usize].as_bytes()[cell.x as usize] == b'#';
        let region = Region {
            width: rows[0].len() as u32,
            height: rows.len() as u32,
            contains: &has,
        };
        assert_eq!(region.paths(pen), expect);
    }

    #[test]
    fn a_shelf_is_one_rounded_shape() {
        let pen = Pen {
            inset: 6,
            radius: 16,
        };
        let corner = "a16 16 0 0 1";
        let expect = format!(
            "M22 6H178{corner} 16 16V78{corner} -16 16H22{corner} -16 -16V22{corner} 16 -16Z"
        );
        check(&["##"], pen, &[&expect]);
    }

    #[test]
    fn a_shape_with_an_inner_corner() {
        check(&["#.", "##"], SHARP, &["M0 0H100V100H200V200H0V0Z"]);
        let pen = Pen {
            inset: 6,
            radius: 0,
        };
        check(&["#.", "##"], pen, &["M6 6H94V106H194V194H6V6Z"]);
    }

    #[test]
    fn cells_that_meet_in_a_corner_stay_apart() {
        let apart = "M0 0H100V100H0V0ZM100 100H200V200H100V100Z";
        check(&["#.", ".#"], SHARP, &[apart]);
    }

    #[test]
    fn a_hole_runs_the_other_way() {
        let ring = "M0 0H300V300H0V0ZM100 200H200V100H100V200Z";
        check(&["###", "#.#", "###"], SHARP, &[ring]);
    }

    #[test]
    fn nothing_has_no_path() {
        check(&["..", ".."], SHARP, &[]);
    }

    #[test]
    fn a_hole_stays_with_its_shape_across_blocks() {
        let mut rows = vec!["#".repeat(40); 40];
        rows[36].replace_range(36..37, ".");
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        let expect = "M0 0H4000V4000H0V0ZM3600 3700H3700V3600H3600V3700Z";
        check(&rows, SHARP, &[expect]);
    }
}
