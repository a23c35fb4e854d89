//! The rules that an instance may set.

use std::borrow::Cow;

use serde::{Deserialize, Deserializer, Serialize, de};

use crate::{Agent, object_only};

/// The rule for an agent at its goal.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum AtGoal {
    /// It remains there and blocks the cell.
    #[default]
    Stay,
    /// It holds its goal at its arrival and is gone from the next time on.
    Vanish,
}

impl<'de> Deserialize<'de> for AtGoal {
    /// By hand, since derived code also takes `{"stay": null}`.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Cow::<str>::deserialize(deserializer)?.as_ref() {
            "stay" => Ok(Self::Stay),
            "vanish" => Ok(Self::Vanish),
            other => Err(de::Error::unknown_variant(other, &["stay", "vanish"])),
        }
    }
}

/// The rules of an instance.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(remote = "Self", deny_unknown_fields, default)]
pub struct Rules {
    /// The rule for an agent at its goal.
    #[serde(deserialize_with = "crate::object::null_is_default")]
    pub at_goal: AtGoal,
    /// The level below which no battery may fall before arrival.
    #[serde(deserialize_with = "crate::object::null_is_default")]
    pub battery_floor: u32,
}

object_only!(Rules);

impl Rules {
    /// The rule for an agent where it arrives: one without a goal always stays.
    pub const fn at_end_of(self, agent: &Agent) -> AtGoal {
        match agent.goal {
            Some(_) => self.at_goal,
            None => AtGoal::Stay,
        }
    }
}
