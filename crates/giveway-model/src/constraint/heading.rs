//! The directions of a map.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Deserializer, Serialize};

use crate::Cell;
use crate::object::one_of;

/// A direction on the map; `north` is up, against y.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Heading {
    /// Up.
    North,
    /// To the right.
    East,
    /// Down.
    South,
    /// To the left.
    West,
}

const HEADINGS: [(&str, Heading); 4] = [
    ("north", Heading::North),
    ("east", Heading::East),
    ("south", Heading::South),
    ("west", Heading::West),
];

impl<'de> Deserialize<'de> for Heading {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        one_of(deserializer, &HEADINGS)
    }
}

impl Heading {
    /// The direction from a cell to one that shares a side with it; `None` where it does not.
    ///
    /// ```
    /// use giveway_model::{Cell, constraint::Heading};
    /// assert_eq!(Heading::of(Cell::new(1, 1), Cell::new(1, 0)), Some(Heading::North));
    /// ```
    pub fn of(from: Cell, to: Cell) -> Option<Self> {
        let (dx, dy) = (
            i64::from(to.x) - i64::from(from.x),
            i64::from(to.y) - i64::from(from.y),
        );
        match (dx, dy) {
            (0, -1) => Some(Self::North),
            (1, 0) => Some(Self::East),
            (0, 1) => Some(Self::South),
            (-1, 0) => Some(Self::West),
            _ => None,
        }
    }

    /// The quarter turns from one direction to another: 0 straight on, 2 back.
    pub const fn quarters_to(self, other: Self) -> u32 {
        let turned = (4 + other as u32 - self as u32) % 4;
        if turned == 3 { 1 } else { turned }
    }

    /// All of them, clockwise from the north.
    pub const ALL: [Self; 4] = [Self::North, Self::East, Self::South, Self::West];
}
