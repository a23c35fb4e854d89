//! A plan: where each agent is at each time.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::agent::ends_with_rest;
use crate::message::read_map;
use crate::object_only;
use crate::{Cell, Instance, Version, tr};

/// Where an agent is at each time, from its first entry on; `None` is *in
/// transit*, half way along a slow move.
pub type Path = Vec<Option<Cell>>;

/// A plan: paths and charges by the agents' names, times in steps from 0.
///
/// It is plain data and may break any rule: `check` judges it.
///
/// ```
/// use giveway_model::Plan;
/// let plan: Plan = serde_json::from_str(r#"{
///     "giveway": 1,
///     "paths": { "A1": [[0, 0], [1, 0], null, [2, 0]] },
///     "charges": { "A1": [1] }
/// }"#).unwrap();
/// assert_eq!(plan.paths["A1"].len(), 4);
/// ```
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Plan {
    /// The version of the format.
    pub giveway: Version,
    /// The cell of each agent at each time up to its arrival.
    #[serde(deserialize_with = "unique_names")]
    #[borsh(deserialize_with = "read_map")]
    pub paths: BTreeMap<String, Path>,
    /// The times at which each agent charges, ascending.
    #[serde(default, deserialize_with = "unique_names")]
    #[borsh(deserialize_with = "read_map")]
    pub charges: BTreeMap<String, Vec<u32>>,
    /// The time of an agent's first entry, where it is not 0: it joined later.
    #[serde(
        default,
        deserialize_with = "unique_names",
        skip_serializing_if = "BTreeMap::is_empty"
    )]
    #[borsh(deserialize_with = "read_map")]
    pub from: BTreeMap<String, u32>,
    /// The time from which an agent is gone, where it was removed.
    #[serde(
        default,
        deserialize_with = "unique_names",
        skip_serializing_if = "BTreeMap::is_empty"
    )]
    #[borsh(deserialize_with = "read_map")]
    pub until: BTreeMap<String, u32>,
    /// The last time whose changes the plan takes into account; what it lists up
    /// to then is past.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub knows: Option<u32>,
    /// The times that an agent slept through at its goal, arrived, before a
    /// change made it go on: each from its arrival up to that change. It counts as
    /// far as the agent rests there.
    #[serde(
        default,
        deserialize_with = "unique_names",
        skip_serializing_if = "BTreeMap::is_empty"
    )]
    #[borsh(deserialize_with = "read_map")]
    pub slept: BTreeMap<String, Vec<[u32; 2]>>,
}

object_only!(Plan);

impl Plan {
    /// The path of an agent; empty where the plan has none.
    pub fn path(&self, agent: &str) -> &[Option<Cell>] {
        self.paths.get(agent).map_or(&[], Vec::as_slice)
    }

    /// The times at which an agent charges.
    pub fn charges(&self, agent: &str) -> &[u32] {
        self.charges.get(agent).map_or(&[], Vec::as_slice)
    }

    /// The times that an agent slept through before a change made it go on.
    pub fn slept(&self, agent: &str) -> &[[u32; 2]] {
        self.slept.get(agent).map_or(&[], Vec::as_slice)
    }

    /// Cuts repeats of the last cell from the end of each path, so that every path
    /// ends at the arrival.
    pub fn cut_trailing_goals(&mut self, instance: &Instance) {
        for agent in instance.agents() {
            if let Some(path) = self.paths.get_mut(&agent.name) {
                while ends_with_rest(path, agent.goal) {
                    path.pop();
                }
            }
        }
    }
}

/// Reads an object by agents' names, where each may stand once: a map would
/// silently keep the last.
fn unique_names<'de, D, T>(deserializer: D) -> Result<BTreeMap<String, T>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    struct ByName<T>(PhantomData<T>);

    impl<'de, T: Deserialize<'de>> Visitor<'de> for ByName<T> {
        type Value = BTreeMap<String, T>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str(tr!("an object by the names of robots"))
        }

        fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
            let mut map = BTreeMap::new();
            while let Some(name) = entries.next_key::<String>()? {
                let value = entries.next_value()?;
                if map.contains_key(&name) {
                    return Err(de::Error::custom(format!(
                        "found \"{name}\" twice, expected each robot once"
                    )));
                }
                map.insert(name, value);
            }
            Ok(map)
        }
    }

    deserializer.deserialize_map(ByName(PhantomData))
}
