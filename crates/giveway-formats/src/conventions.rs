//! The conventions of a plan: the meaning of its numbers and letters.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use super::{Walk, WrittenPlan};

/// Which number of a pair is which.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub enum CellOrder {
    /// The row (`y`) first, as in a matrix.
    #[serde(rename = "row, column")]
    RowColumn,
    /// The column (`x`) first, as in a chart.
    #[serde(rename = "column, row")]
    ColumnRow,
}

/// Where cells are counted from.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub enum Origin {
    /// The first row and column are 0.
    #[serde(rename = "0")]
    Zero,
    /// The first row and column are 1.
    #[serde(rename = "1")]
    One,
}

/// The direction of *up* in rows, which are counted from the top of the map.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub enum Up {
    /// `u` goes to the row above: `y - 1`.
    #[serde(rename = "y - 1")]
    Lowers,
    /// `u` goes to the row below: `y + 1`.
    #[serde(rename = "y + 1")]
    Raises,
}

/// How a plan is read. A file without letters takes no notice of `up`, one
/// without cells none of `cells` and `origin`.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Conventions {
    /// Which number of a cell is the row.
    pub cells: CellOrder,
    /// Where cells are counted from.
    pub origin: Origin,
    /// The meaning of `u`.
    pub up: Up,
}

impl Conventions {
    /// Columns first, from 0, up to the row above: as this project writes cells.
    pub const OWN: Self = Self {
        cells: CellOrder::ColumnRow,
        origin: Origin::Zero,
        up: Up::Lowers,
    };

    /// All ways to read a plan: the documented one first, then those that differ
    /// from it in less before those that differ in more. Only what makes a
    /// difference to this plan varies.
    pub fn candidates(plan: &WrittenPlan) -> Vec<Self> {
        let own = plan.documented;
        let (has_cells, has_moves) = uses(plan);
        let mut all = vec![own];
        if has_moves {
            let up = other(own.up, [Up::Lowers, Up::Raises]);
            all.extend(all.clone().into_iter().map(|one| Self { up, ..one }));
        }
        if has_cells {
            let cells = other(own.cells, [CellOrder::RowColumn, CellOrder::ColumnRow]);
            all.extend(all.clone().into_iter().map(|one| Self { cells, ..one }));
            let origin = other(own.origin, [Origin::Zero, Origin::One]);
            all.extend(all.clone().into_iter().map(|one| Self { origin, ..one }));
        }
        all
    }

    /// The conventions that matter to a plan, in words: `row, column` and so on, each with its subject.
    pub fn words(self, plan: &WrittenPlan) -> Vec<(&'static str, String)> {
        let (has_cells, has_moves) = uses(plan);
        let mut words = Vec::new();
        if has_cells {
            let from = match self.origin {
                Origin::Zero => "from 0",
                Origin::One => "from 1",
            };
            words.push(("cells", format!("{}, {from}", self.cells)));
        }
        if has_moves {
            words.push(("up", self.up.to_string()));
        }
        words
    }
}

/// Whether a plan has cells as numbers, and moves as letters.
fn uses(plan: &WrittenPlan) -> (bool, bool) {
    let cells = plan.agents.iter().any(|agent| {
        matches!(agent.walk, Walk::Cells(_)) || agent.start.is_some() || agent.goal.is_some()
    });
    let moves = plan
        .agents
        .iter()
        .any(|agent| matches!(agent.walk, Walk::Moves(_)));
    (cells, moves)
}

/// The other one of two.
fn other<T: PartialEq + Copy>(own: T, [one, two]: [T; 2]) -> T {
    if own == one { two } else { one }
}

impl fmt::Display for CellOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::RowColumn => "row first, then column",
            Self::ColumnRow => "column first, then row",
        })
    }
}

impl fmt::Display for Up {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lowers => "to the row above (y - 1)",
            Self::Raises => "to the row below (y + 1)",
        })
    }
}
