//! How late agents could be.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

/// How late one agent could be, in two ways.
///
/// As JSON: `{ "arrival": 3, "arrival-at-least": 3, "hold": [3, 3, 4], "late": 3 }`,
/// `arrival` being `null` where it is open, and `late` the least of `hold`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(into = "WrittenSlack", from = "WrittenSlack")]
pub struct Slack {
    /// How many steps later than in this plan it arrives in some best plan, the
    /// others planned anew.
    pub arrival: Later,
    /// At each time before its arrival: for how many steps it could stand still
    /// there, whatever it does later being that much later, and nobody else doing
    /// anything else.
    pub hold: Vec<Hold>,
}

/// How many steps later.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub enum Later {
    /// So many, and it is proved that it can be no more.
    Exactly(u32),
    /// A plan shows that it can be so many; more may be possible.
    AtLeast(u32),
}

impl Later {
    /// The number.
    pub const fn number(self) -> u32 {
        match self {
            Self::Exactly(steps) | Self::AtLeast(steps) => steps,
        }
    }
}

/// For how many steps an agent could stand still.
///
/// As JSON a number, `"unlimited"`, or `null` in transit.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(into = "WrittenHold", from = "WrittenHold")]
pub enum Hold {
    /// For any number up to this, and not for one more.
    Steps(u32),
    /// For any number: everybody else has come to rest, and time costs nothing.
    Unlimited,
    /// It is in transit, where nobody can stand still.
    InTransit,
}

/// The same as it is written.
#[derive(Clone, Serialize, Deserialize)]
#[serde(untagged)]
enum WrittenHold {
    Steps(u32),
    Word(HoldWord),
    InTransit,
}

#[derive(Clone, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum HoldWord {
    Unlimited,
}

impl From<Hold> for WrittenHold {
    fn from(hold: Hold) -> Self {
        match hold {
            Hold::Steps(steps) => Self::Steps(steps),
            Hold::Unlimited => Self::Word(HoldWord::Unlimited),
            Hold::InTransit => Self::InTransit,
        }
    }
}

impl From<WrittenHold> for Hold {
    fn from(written: WrittenHold) -> Self {
        match written {
            WrittenHold::Steps(steps) => Self::Steps(steps),
            WrittenHold::Word(HoldWord::Unlimited) => Self::Unlimited,
            WrittenHold::InTransit => Self::InTransit,
        }
    }
}

impl Slack {
    /// How late it could be without harm, wherever it is held up: the least of
    /// `hold`; `None` where it has nothing left to do.
    pub fn late(&self) -> Option<Hold> {
        let least = |a: Hold, b: Hold| match (a, b) {
            (Hold::Steps(a), Hold::Steps(b)) => Hold::Steps(a.min(b)),
            (Hold::Steps(_), _) => a,
            _ => b,
        };
        let holds = self.hold.iter().copied();
        holds.filter(|hold| *hold != Hold::InTransit).reduce(least)
    }
}

/// The slack of an agent as it is written.
#[derive(Clone, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
struct WrittenSlack {
    arrival: Option<u32>,
    arrival_at_least: u32,
    hold: Vec<Hold>,
    #[serde(skip_deserializing)]
    late: Option<Hold>,
}

impl From<Slack> for WrittenSlack {
    fn from(slack: Slack) -> Self {
        Self {
            arrival: match slack.arrival {
                Later::Exactly(steps) => Some(steps),
                Later::AtLeast(_) => None,
            },
            arrival_at_least: slack.arrival.number(),
            late: slack.late(),
            hold: slack.hold,
        }
    }
}

impl From<WrittenSlack> for Slack {
    fn from(written: WrittenSlack) -> Self {
        Self {
            arrival: written
                .arrival
                .map_or(Later::AtLeast(written.arrival_at_least), Later::Exactly),
            hold: written.hold,
        }
    }
}
