//! The directions of a map.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Deserializer, Serialize};

use super::{Constraint, ConstraintKind};
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

/// The time steps of a quarter turn of an agent under the rules in force; 0 where turns are free.
/// Of several rules each is kept by itself, so the largest number counts.
///
/// ```
/// use giveway_model::constraint::quarter_turn;
/// let rules = [serde_json::from_str(r#"{ "kind": "turns", "quarter": 2 }"#).unwrap()];
/// assert_eq!(quarter_turn(&rules, "A1"), 2);
/// assert_eq!(quarter_turn(&[], "A1"), 0);
/// ```
pub fn quarter_turn(rules: &[Constraint], agent: &str) -> u32 {
    let binds = |rule: &&Constraint| {
        let names = rule.agents.as_ref();
        !rule.off && names.is_none_or(|names| names.iter().any(|name| name == agent))
    };
    let steps = rules
        .iter()
        .filter(binds)
        .filter_map(|rule| match rule.kind {
            ConstraintKind::Turns { quarter } => Some(quarter),
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Avoid { .. } => None,
        });
    steps.max().unwrap_or(0)
}
