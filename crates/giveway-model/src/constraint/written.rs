//! A constraint as it is written: one object whose keys depend on its kind.

mod kind;
mod read;
mod write;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::Constraint;
use crate::condition::Visit;
use crate::{Cell, object_only};
use kind::Kind;
pub(super) use kind::kind_name;

/// All keys that a constraint may have.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
struct Written {
    kind: Kind,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    zone: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    lane: Option<Vec<Cell>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    agent: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    first: Option<At>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    second: Option<At>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cells: Option<Vec<Cell>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cell: Option<Cell>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    most: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    steps: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    distance: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    stay: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    by: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    from: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    to: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    quarter: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    weight: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    agents: Option<Vec<String>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    off: bool,
}

object_only!(Written);

/// An agent at a cell, as it is written.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
struct At {
    agent: String,
    cell: Cell,
}

object_only!(At);

impl From<At> for Visit {
    fn from(At { agent, cell }: At) -> Self {
        Self { agent, cell }
    }
}

impl From<Visit> for At {
    fn from(Visit { agent, cell }: Visit) -> Self {
        Self { agent, cell }
    }
}

impl Serialize for Constraint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Serialize::serialize(&Written::from(self.clone()), serializer)
    }
}

impl<'de> Deserialize<'de> for Constraint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written: Written = Deserialize::deserialize(deserializer)?;
        Self::try_from(written).map_err(de::Error::custom)
    }
}
