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

type Step = (i64, i64);

/// Right, down, left, up: walking clockwise, the shape lies to the right.
const AHEAD: [Step; 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

impl Region<'_> {
    /// The `d` of SVG paths that fill the set. Cells that share a side are one
    /// shape; those that meet in a corner only stay apart. A hole runs the
    /// other way round, so that it is not filled.
    pub(super) fn paths(&self, pen: Pen) -> Vec<String> {
        let across = self.width.div_ceil(BLOCK);
        let mut blocks = vec![String::new(); (across * self.height.div_ceil(BLOCK)) as usize];
        let firsts = self.first_cells();
        let mut walked = vec![false; firsts.len()];
        for (index, first) in firsts.iter().enumerate() {
            let (x, y) = (
                index as i64 % i64::from(self.width),
                index as i64 / i64::from(self.width),
            );
            let Some(first) = *first else { continue };
            if walked[index] || self.has((x, y - 1)) {
                continue;
            }
            let block = (first.y / BLOCK * across + first.x / BLOCK) as usize;
            self.walk((x, y), &mut walked, pen, &mut blocks[block]);
        }
        blocks.retain(|path| !path.is_empty());
        blocks
    }

    fn has(&self, (x, y): Step) -> bool {
        let cell = (u32::try_from(x), u32::try_from(y));
        let (Ok(x), Ok(y)) = cell else { return false };
        x < self.width && y < self.height && (self.contains)(Cell::new(x, y))
    }

    /// For each cell of the set the first one of its shape, row by row.
    fn first_cells(&self) -> Vec<Option<Cell>> {
        let mut firsts = vec![None; self.width as usize * self.height as usize];
        let index = |cell: Cell| cell.y as usize * self.width as usize + cell.x as usize;
        let mut open = Vec::new();
        for y in 0..self.height {
            for x in 0..self.width {
                let first = Cell::new(x, y);
                if firsts[index(first)].is_some() || !(self.contains)(first) {
                    continue;
                }
                firsts[index(first)] = Some(first);
                open.push(first);
                while let Some(cell) = open.pop() {
                    let at = (i64::from(cell.x), i64::from(cell.y));
                    for step in AHEAD {
                        let next = (at.0 + step.0, at.1 + step.1);
                        if !self.has(next) {
                            continue;
                        }
                        let next = Cell::new(next.0 as u32, next.1 as u32);
                        if firsts[index(next)].is_none() {
                            firsts[index(next)] = Some(first);
                            open.push(next);
                        }
                    }
                }
            }
        }
        firsts
    }

    /// Walks once around, from the upper side of a cell. `walked` keeps the
    /// upper sides that a walk went along: every outline and hole has one.
    fn walk(&self, begin: Step, walked: &mut [bool], pen: Pen, path: &mut String) {
        let (mut cell, mut side) = (begin, 0);
        let mut corners = Vec::new();
        loop {
            if side == 0 {
                walked[(cell.1 * i64::from(self.width) + cell.0) as usize] = true;
            }
            let (ahead, out) = (AHEAD[side], AHEAD[(side + 3) % 4]);
            let next = (cell.0 + ahead.0, cell.1 + ahead.1);
            let beside = (next.0 + out.0, next.1 + out.1);
            let (next_cell, next_side) = if !self.has(next) {
                (cell, (side + 1) % 4)
            } else if self.has(beside) {
                (beside, (side + 3) % 4)
            } else {
                (next, side)
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
    at: Step,
    from: usize,
    to: usize,
}

/// The corner at the end of a cell's side, moved into the shape.
fn corner((x, y): Step, from: usize, to: usize, pen: Pen) -> Corner {
    // The end of the upper side is the upper right corner, and so on.
    let (right, down) = [(1, 0), (1, 1), (0, 1), (0, 0)][from];
    let inset = i64::from(pen.inset);
    let (a, b) = (AHEAD[(from + 3) % 4], AHEAD[(to + 3) % 4]);
    let at = (
        100 * (x + right) - inset * (a.0 + b.0),
        100 * (y + down) - inset * (a.1 + b.1),
    );
    Corner { at, from, to }
}

fn draw(corners: &[Corner], pen: Pen, path: &mut String) {
    let radius = i64::from(pen.radius);
    let along = |corner: &Corner, side: usize, by: i64| {
        let ahead = AHEAD[side];
        (corner.at.0 + by * ahead.0, corner.at.1 + by * ahead.1)
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
            let outwards = u8::from(corner.to == (corner.from + 1) % 4);
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
