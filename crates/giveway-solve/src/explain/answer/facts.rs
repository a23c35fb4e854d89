//! Facts of an instance that can be left out, and sets of them that make something impossible.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Cell;
use serde::{Deserialize, Serialize};

use crate::{
    Reach,
    explain::fact_groups::{FactGroup, FactPrice},
};

/// The kind of a fact, which tells how it is left out.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum FactKind {
    /// The agent is there at all.
    Task,
    /// A waypoint must be visited.
    Waypoint,
    /// A battery is limited.
    Battery,
    /// A cell is an obstacle.
    Obstacle,
    /// Slow zones are slow.
    Slow,
    /// Two agents must not collide.
    Collision,
    /// An arrived agent blocks its goal.
    Stay,
    /// The horizon that a person set.
    Deadline,
    /// No battery may fall below the floor.
    Floor,
    /// An agent has broken down, and may not go on before a time.
    Breakdown,
    /// An agent without a goal is there at all.
    Presence,
    /// An arrived agent without a goal blocks the cell where it rests.
    Rest,
    /// A rule of the scene's own is in force.
    Constraint,
}

/// Whether leaving out one fact alone, all others of the instance kept, gives a
/// plan. In JSON `true`, `false`, or `null` where it is not known.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(from = "Option<bool>", into = "Option<bool>")]
pub enum Helps {
    /// There is a plan without it: for a costly question one that costs no more
    /// than the plan that is asked about.
    Yes,
    /// There is still none without it: as far as the claim of its set reaches.
    No,
    /// The budget ran out before this was known, or it was not tried yet.
    #[default]
    Unknown,
}

impl From<Option<bool>> for Helps {
    fn from(known: Option<bool>) -> Self {
        match known {
            Some(true) => Self::Yes,
            Some(false) => Self::No,
            None => Self::Unknown,
        }
    }
}

impl From<Helps> for Option<bool> {
    fn from(helps: Helps) -> Self {
        match helps {
            Helps::Yes => Some(true),
            Helps::No => Some(false),
            Helps::Unknown => None,
        }
    }
}

/// A fact of an instance that can be left out.
#[derive(
    Clone,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
pub struct Fact {
    /// The kind of fact.
    pub kind: FactKind,
    /// Its agents: none, one, or the two of a pair, in the instance's order.
    pub agents: Vec<String>,
    /// Where, for a waypoint or an obstacle.
    pub cell: Option<Cell>,
    /// The number in the scene, from 0, of a rule of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub index: Option<u32>,
    /// When it began, in steps of the whole plan, for a breakdown; when a change added it, for
    /// a rule.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<u32>,
    /// The time from which the agent may go on, for a breakdown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until: Option<u32>,
    /// The fact as a clause for people: `A1 must visit (2, 1)`.
    pub text: String,
    /// Whether leaving out this fact alone helps.
    #[serde(default)]
    pub helps: Helps,
}

/// Facts that alone make it impossible: with these, and without all other facts
/// of the instance, there is no plan. The facts that are not in the set may make
/// it impossible, too: what would help says [`Fact::helps`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Core {
    /// The facts.
    pub facts: Vec<Fact>,
    /// The facts in groups, the deciding one first, where there are more than three facts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub groups: Vec<FactGroup>,
    /// What the whole instance costs without one of the facts, as far as was tried.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub prices: Vec<FactPrice>,
    /// Whether each fact was shown to be needed in the set: with only the others
    /// of the set there is a plan.
    pub minimal: bool,
    /// How far "no plan" reaches.
    #[serde(flatten)]
    pub reach: Reach,
    /// Further sets that make it impossible, too, where leaving out one fact of
    /// this one does not help (leaving a whole robot out apart). They share no
    /// fact with this set and with each other, or as few as was found. There may
    /// be more sets; these have no further ones themselves.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub further: Vec<Self>,
}

impl Core {
    /// This set and the further ones.
    pub fn sets(&self) -> impl Iterator<Item = &Self> {
        std::iter::once(self).chain(&self.further)
    }
}
