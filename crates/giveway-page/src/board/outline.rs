//! The outlines of sets of cells: neighbouring cells join into one shape.
//!
//! A map is outlined tile by tile, so that a change of one cell draws little anew.
//! A shape that goes on in the next tile is cut at the border: its fill reaches a
//! little over it, and so does the line around it, so that no seam is seen.

use std::fmt::Write;

use giveway_model::Cell;

/// How an outline is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pen {
    /// How far it stays inside of the cells, in units.
    pub(super) inset: i64,
    /// The radius of its corners, in units; 0 draws them sharp.
    pub(super) radius: i64,
    /// How far a shape that is cut reaches over the border of its tile, in units;
    /// at most the side of a cell.
    pub(super) overlap: i64,
}

/// A part of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Area {
    /// The first column and row.
    pub(super) first: Cell,
    /// Columns and rows.
    pub(super) size: (u32, u32),
}

impl Area {
    /// Its cells, row by row.
    pub(super) fn cells(self) -> impl Iterator<Item = Cell> {
        let Cell { x, y } = self.first;
        let (width, height) = self.size;
        (y..y + height).flat_map(move |y| (x..x + width).map(move |x| Cell::new(x, y)))
    }

    pub(super) fn contains(self, cell: Cell) -> bool {
        let is_in = |at: u32, first: u32, size: u32| at >= first && at - first < size;
        is_in(cell.x, self.first.x, self.size.0) && is_in(cell.y, self.first.y, self.size.1)
    }
}

/// A set of cells in an area and one cell around it: that much tells where a
/// shape goes on.
pub(super) struct Region {
    area: Area,
    cells: Cells,
}

/// A cell by column and row, counted from one before the area.
type At = (usize, usize);
type Step = (i64, i64);

/// Right, down, left, up: walking clockwise, the shape lies to the right.
const AHEAD: [Step; 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];
const SIDES: [usize; 4] = [0, 1, 2, 3];

/// The side after a turn to the right, and after one to the left.
const fn right(side: usize) -> usize {
    (side + 1) % 4
}

const fn left(side: usize) -> usize {
    (side + 3) % 4
}

/// A set of cells of a rectangle.
#[derive(Clone)]
struct Cells {
    width: usize,
    height: usize,
    has: Vec<bool>,
}

impl Cells {
    fn all(&self) -> impl Iterator<Item = At> + use<> {
        let width = self.width;
        (0..self.height).flat_map(move |y| (0..width).map(move |x| (x, y)))
    }

    const fn index(&self, (x, y): At) -> usize {
        y * self.width + x
    }

    fn has(&self, at: At) -> bool {
        self.has.get(self.index(at)).copied().unwrap_or(false)
    }

    /// The cell of the rectangle in a direction.
    fn towards(&self, (x, y): At, direction: usize) -> Option<At> {
        let (across, down) = AHEAD[direction];
        let x = x.checked_add_signed(across as isize)?;
        let y = y.checked_add_signed(down as isize)?;
        (x < self.width && y < self.height).then_some((x, y))
    }

    /// The cell of the set in a direction.
    fn beside(&self, at: At, direction: usize) -> Option<At> {
        self.towards(at, direction).filter(|&at| self.has(at))
    }

    /// The side of the outline after one: of the same cell or another one.
    fn next(&self, at: At, side: usize) -> (At, usize) {
        match self.beside(at, side) {
            None => (at, right(side)),
            Some(next) => match self.beside(next, left(side)) {
                None => (next, side),
                Some(inner) => (inner, left(side)),
            },
        }
    }

    /// The side of the outline before one.
    fn before(&self, at: At, side: usize) -> (At, usize) {
        match self.beside(at, right(right(side))) {
            None => (at, left(side)),
            Some(before) => match self.beside(before, left(side)) {
                None => (before, side),
                Some(inner) => (inner, right(side)),
            },
        }
    }

    /// Whether the outline goes along a side of a cell of the set.
    fn is_free(&self, at: At, side: usize) -> bool {
        self.beside(at, left(side)).is_none()
    }
}

impl Region {
    /// The cells of an area that are in a set.
    pub(super) fn new(area: Area, contains: impl Fn(Cell) -> bool) -> Self {
        let mut cells = Cells {
            width: area.size.0 as usize + 2,
            height: area.size.1 as usize + 2,
            has: Vec::new(),
        };
        let is_in = |(x, y): At| {
            let x = (area.first.x as usize + x).checked_sub(1)?;
            let y = (area.first.y as usize + y).checked_sub(1)?;
            Some(contains(Cell::new(x as u32, y as u32)))
        };
        cells.has = cells.all().map(|at| is_in(at) == Some(true)).collect();
        Self { area, cells }
    }

    const fn is_inside(&self, (x, y): At) -> bool {
        x > 0 && y > 0 && x + 1 < self.cells.width && y + 1 < self.cells.height
    }

    /// The `d` of a path that fills the set. Cells that share a side are one shape;
    /// those that meet in a corner only stay apart. A hole runs the other way round,
    /// so that it is not filled.
    pub(super) fn fill(&self, pen: Pen) -> String {
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
    fn cut_end(&self, at: At, side: usize, pen: Pen) -> Step {
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

    /// The `d` of a path along the outline of the set, as far as it goes along cells
    /// of the area.
    pub(super) fn edge(&self, pen: Pen) -> String {
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

    /// Where a side of a cell ends: of the upper side that is the upper right
    /// corner, and so on; in units of the map.
    fn end(&self, (x, y): At, side: usize) -> Step {
        let (across, down) = [(1, 0), (1, 1), (0, 1), (0, 0)][side];
        let place =
            |first: u32, at: usize, end: i64| 100 * (i64::from(first + at as u32) - 1 + end);
        (
            place(self.area.first.x, x, across),
            place(self.area.first.y, y, down),
        )
    }
}

/// A point moved along a side.
const fn along((x, y): Step, side: usize, by: i64) -> Step {
    let (across, down) = AHEAD[side];
    (x + by * across, y + by * down)
}

/// A point moved from a side into the shape.
const fn inside(at: Step, side: usize, by: i64) -> Step {
    along(at, left(side), -by)
}

/// A corner of an outline.
struct Corner {
    at: Step,
    from: usize,
    to: usize,
    radius: i64,
}

impl Corner {
    /// Where the next side begins.
    const fn end(&self) -> Step {
        along(self.at, self.to, self.radius)
    }

    /// Goes on along its side, and around it.
    fn draw(&self, path: &mut String) {
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
fn straight((x, y): Step, side: usize, path: &mut String) {
    // Writing to a string cannot fail.
    let _ = match side % 2 {
        0 => write!(path, "H{x}"),
        _ => write!(path, "V{y}"),
    };
}

fn close(corners: &[Corner], path: &mut String) {
    let Some(last) = corners.last() else { return };
    let (x, y) = last.end();
    // Writing to a string cannot fail.
    let _ = write!(path, "M{x} {y}");
    for corner in corners {
        corner.draw(path);
    }
    path.push('Z');
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHARP: Pen = Pen {
        inset: 0,
        radius: 0,
        overlap: 0,
    };
    const ROUND: Pen = Pen {
        inset: 6,
        radius: 16,
        overlap: 0,
    };

    fn region(rows: &[&str], first: (u32, u32), size: (u32, u32)) -> Region {
        let row = |cell: Cell| rows.get(cell.y as usize)?.as_bytes().get(cell.x as usize);
        let area = Area {
            first: first.into(),
            size,
        };
        Region::new(area, |cell| row(cell) == Some(&b'#'))
    }

    /// Of a map that is one tile.
    #[track_caller]
    fn check(rows: &[&str], pen: Pen, expect: &str) {
        let whole = region(rows, (0, 0), (rows[0].len() as u32, rows.len() as u32));
        assert_eq!(whole.fill(pen), expect);
        assert_eq!(whole.edge(pen), expect);
    }

    #[test]
    fn a_shelf_is_one_rounded_shape() {
        let corner = "a16 16 0 0 1";
        let expect = format!(
            "M22 6H178{corner} 16 16V78{corner} -16 16H22{corner} -16 -16V22{corner} 16 -16Z"
        );
        check(&["##"], ROUND, &expect);
    }

    #[test]
    fn a_shape_with_an_inner_corner() {
        check(&["#.", "##"], SHARP, "M0 0H100V100H200V200H0V0Z");
        let pen = Pen { radius: 0, ..ROUND };
        check(&["#.", "##"], pen, "M6 6H94V106H194V194H6V6Z");
    }

    #[test]
    fn cells_that_meet_in_a_corner_stay_apart() {
        let apart = "M0 0H100V100H0V0ZM100 100H200V200H100V100Z";
        check(&["#.", ".#"], SHARP, apart);
    }

    #[test]
    fn a_hole_runs_the_other_way() {
        let rows = ["###", "#.#", "###"];
        let whole = region(&rows, (0, 0), (3, 3));
        let ring = "M0 0H300V300H0V0ZM100 200H200V100H100V200Z";
        assert_eq!(whole.fill(SHARP), ring);
        // The same hole, from its upper side.
        let ring = "M0 0H300V300H0V0ZM200 100H100V200H200V100Z";
        assert_eq!(whole.edge(SHARP), ring);
    }

    #[test]
    fn nothing_has_no_path() {
        check(&["..", ".."], SHARP, "");
    }

    #[test]
    fn a_shape_that_is_cut_reaches_over_the_border() {
        let pen = Pen {
            overlap: 8,
            ..SHARP
        };
        let left = region(&["##"], (0, 0), (1, 1));
        // A little narrower there.
        assert_eq!(left.fill(pen), "M0 0H100V2H108V98H100V100H0V0Z");
        let right = region(&["##"], (1, 0), (1, 1));
        assert_eq!(right.fill(pen), "M92 2H100V0H200V100H100V98H92V2Z");
        let right = right.edge(pen);
        // From its upper left corner around to its lower one, and 8 on.
        assert_eq!(right, "M100 0H200V100H92");
    }

    #[test]
    fn a_shape_beside_a_tile_is_none_of_its_own() {
        let beside = region(&[".#", "##"], (0, 0), (1, 1));
        assert_eq!((beside.fill(ROUND), beside.edge(ROUND)), Default::default());
    }

    #[test]
    fn an_inner_corner_on_a_border_is_round_all_the_same() {
        // The corner around which it turns is where the tile ends.
        let elbow = region(&["#.", "##"], (0, 1), (1, 1));
        let arc = "V90a16 16 0 0 0 16 16";
        assert!(elbow.fill(ROUND).contains(arc), "{}", elbow.fill(ROUND));
        let above = region(&["#.", "##"], (0, 0), (2, 1));
        assert!(above.edge(ROUND).contains(arc), "{}", above.edge(ROUND));
    }
}
