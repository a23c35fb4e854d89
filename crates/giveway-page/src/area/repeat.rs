//! Copies of an area in a row: how many, how far from each other, where to.

use giveway_model::tr;

/// The most copies at once.
pub const MOST_COPIES: u32 = 64;
/// The farthest from one copy to the next, in cells.
pub const FARTHEST: u32 = 64;

/// Where copies go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// To the right.
    Right,
    /// Down.
    Down,
    /// To the left.
    Left,
    /// Up.
    Up,
}

impl Direction {
    /// All of them, each turned right by a quarter from the one before.
    pub const ALL: [Self; 4] = [Self::Right, Self::Down, Self::Left, Self::Up];

    /// Its word in "3 cells down".
    pub fn word(self) -> &'static str {
        match self {
            Self::Right => tr!("cells to the" => "right"),
            Self::Down => tr!("cells" => "down"),
            Self::Left => tr!("cells to the" => "left"),
            Self::Up => tr!("cells" => "up"),
        }
    }

    const fn step(self) -> (i32, i32) {
        match self {
            Self::Right => (1, 0),
            Self::Down => (0, 1),
            Self::Left => (-1, 0),
            Self::Up => (0, -1),
        }
    }
}

/// Copies of an area in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Repeat {
    /// How many.
    pub copies: u32,
    /// From one to the next, in cells.
    pub step: u32,
    /// Where to.
    pub to: Direction,
}

impl Repeat {
    /// One copy across the longer side of a frame, so that an aisle is left.
    pub(crate) fn of([x0, y0, x1, y1]: [u32; 4]) -> Self {
        let (width, height) = (x1 - x0 + 1, y1 - y0 + 1);
        let (to, side) = if width >= height {
            (Direction::Down, height)
        } else {
            (Direction::Right, width)
        };
        Self {
            copies: 1,
            step: (side + 1).min(FARTHEST),
            to,
        }
    }

    /// The copies of a frame in another direction, with the same gap between two of them.
    pub(crate) fn turned(self, to: Direction, [x0, y0, x1, y1]: [u32; 4]) -> Self {
        let side = |to: Direction| match to {
            Direction::Right | Direction::Left => x1 - x0 + 1,
            Direction::Down | Direction::Up => y1 - y0 + 1,
        };
        let gap = self.step.checked_sub(side(self.to));
        let step = gap.map_or(self.step, |gap| (side(to) + gap).min(FARTHEST));
        Self { step, to, ..self }
    }

    /// How far each copy stands from the area: cells right and down.
    pub(crate) fn places(self) -> impl Iterator<Item = (i32, i32)> {
        let (right, down) = self.to.step();
        (1..=self.copies.min(MOST_COPIES)).map(move |copy| {
            let by = i32::try_from(copy * self.step.min(FARTHEST)).unwrap_or(0);
            (right * by, down * by)
        })
    }
}
