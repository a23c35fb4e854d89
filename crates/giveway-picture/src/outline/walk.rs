//! A set of cells of a rectangle, and the walk around it, side by side.

/// A cell by column and row, from 0.
pub(super) type At = (usize, usize);

/// The sides of a cell: upper, right, lower, left. Clockwise, so that the shape lies
/// to the right of a walk along them.
pub(super) const SIDES: [usize; 4] = [0, 1, 2, 3];

/// Where a walk along each side goes: right, down, left, up; also the directions.
const AHEAD: [(i64, i64); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

/// Columns and rows from one cell to the next one in a direction.
pub(super) const fn ahead(side: usize) -> (i64, i64) {
    AHEAD[side]
}

/// The side after a turn to the right, and after one to the left.
pub(super) const fn right(side: usize) -> usize {
    (side + 1) % 4
}

pub(super) const fn left(side: usize) -> usize {
    (side + 3) % 4
}

/// A set of cells of a rectangle.
#[derive(Clone)]
pub(super) struct Cells {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) has: Vec<bool>,
}

impl Cells {
    pub(super) fn all(&self) -> impl Iterator<Item = At> + use<> {
        let width = self.width;
        (0..self.height).flat_map(move |y| (0..width).map(move |x| (x, y)))
    }

    pub(super) const fn index(&self, (x, y): At) -> usize {
        y * self.width + x
    }

    pub(super) fn has(&self, at: At) -> bool {
        self.has.get(self.index(at)).copied().unwrap_or(false)
    }

    /// The cell of the rectangle in a direction.
    pub(super) fn towards(&self, (x, y): At, direction: usize) -> Option<At> {
        let (across, down) = AHEAD[direction];
        let x = x.checked_add_signed(across as isize)?;
        let y = y.checked_add_signed(down as isize)?;
        (x < self.width && y < self.height).then_some((x, y))
    }

    /// The cell of the set in a direction.
    pub(super) fn beside(&self, at: At, direction: usize) -> Option<At> {
        self.towards(at, direction).filter(|&at| self.has(at))
    }

    /// The side of the outline after one: of the same cell or another one.
    pub(super) fn next(&self, at: At, side: usize) -> (At, usize) {
        match self.beside(at, side) {
            None => (at, right(side)),
            Some(next) => match self.beside(next, left(side)) {
                None => (next, side),
                Some(inner) => (inner, left(side)),
            },
        }
    }

    /// The side of the outline before one.
    pub(super) fn before(&self, at: At, side: usize) -> (At, usize) {
        match self.beside(at, right(right(side))) {
            None => (at, left(side)),
            Some(before) => match self.beside(before, left(side)) {
                None => (before, side),
                Some(inner) => (inner, right(side)),
            },
        }
    }

    /// Whether the outline goes along a side of a cell of the set.
    pub(super) fn is_free(&self, at: At, side: usize) -> bool {
        self.beside(at, left(side)).is_none()
    }
}
