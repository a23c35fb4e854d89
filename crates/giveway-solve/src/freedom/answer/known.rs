//! Proved or open, as types: nothing open can be read as proved.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

/// Whether all best plans share something.
///
/// As JSON it is `true`, `false` or, where it is open, `null`.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(into = "Option<bool>", from = "Option<bool>")]
pub enum Known {
    /// It is proved.
    Yes,
    /// A best plan that the judge passed shows that it is not so.
    No,
    /// Neither: the budget ran out.
    Open,
}

impl Known {
    /// Whether it is proved.
    pub const fn is_proved(self) -> bool {
        matches!(self, Self::Yes)
    }
}

impl From<Known> for Option<bool> {
    fn from(known: Known) -> Self {
        match known {
            Known::Yes => Some(true),
            Known::No => Some(false),
            Known::Open => None,
        }
    }
}

impl From<Option<bool>> for Known {
    fn from(known: Option<bool>) -> Self {
        match known {
            Some(true) => Self::Yes,
            Some(false) => Self::No,
            None => Self::Open,
        }
    }
}

/// How many there are.
///
/// As JSON: `{ "count": 15, "complete": true, "known": "exactly" }`.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(into = "WrittenCount", from = "WrittenCount")]
pub enum PlanCount {
    /// So many, and it is proved that there are no others.
    Exactly(u32),
    /// More than were asked to be counted.
    MoreThan(u32),
    /// So many were found before the budget ran out.
    AtLeast(u32),
}

impl PlanCount {
    /// The number.
    pub const fn number(self) -> u32 {
        match self {
            Self::Exactly(number) | Self::MoreThan(number) | Self::AtLeast(number) => number,
        }
    }

    /// Whether all of them were counted.
    pub const fn is_exact(self) -> bool {
        matches!(self, Self::Exactly(_))
    }
}

/// Whether a count is exact.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum NumberKind {
    Exactly,
    MoreThan,
    AtLeast,
}

/// A number as it is written.
#[derive(Clone, Serialize, Deserialize)]
struct WrittenCount {
    count: u32,
    complete: bool,
    known: NumberKind,
}

impl From<PlanCount> for WrittenCount {
    fn from(number: PlanCount) -> Self {
        Self {
            count: number.number(),
            complete: number.is_exact(),
            known: match number {
                PlanCount::Exactly(_) => NumberKind::Exactly,
                PlanCount::MoreThan(_) => NumberKind::MoreThan,
                PlanCount::AtLeast(_) => NumberKind::AtLeast,
            },
        }
    }
}

impl From<WrittenCount> for PlanCount {
    fn from(written: WrittenCount) -> Self {
        match written.known {
            NumberKind::Exactly => Self::Exactly(written.count),
            NumberKind::MoreThan => Self::MoreThan(written.count),
            NumberKind::AtLeast => Self::AtLeast(written.count),
        }
    }
}
