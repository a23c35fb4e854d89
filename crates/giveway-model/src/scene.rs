//! A scene: an instance as it is written, before it is checked.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::constraint::{InForce, in_force};
use crate::object::null_is_default;
use crate::object_only;
use crate::{Agent, Assumption, Constraint, Objective, Rules, Units, Version, Zone};

/// An instance as a person writes it: plain data that may be wrong.
///
/// [`crate::Instance::new`] checks it.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Scene {
    /// The version of the format.
    pub giveway: Version,
    /// The name that a person gave it; may be empty.
    #[serde(default, deserialize_with = "crate::object::null_is_default")]
    pub name: String,
    /// The rows of the map, from the top: `.` free, `#` obstacle, `~` slow
    /// zone, `+` charger, `*` charger in the slow zone.
    pub map: Vec<String>,
    /// The rules; by default agents stay at their goals and the floor is 0.
    #[serde(default, deserialize_with = "null_is_default")]
    pub rules: Rules,
    /// The costs to minimise, the most important first.
    #[serde(default, deserialize_with = "null_is_default")]
    pub objective: Objective,
    /// The agents.
    pub agents: Vec<Agent>,
    /// The assumptions of the scene, where it was read from a file of another maker.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub assumptions: Vec<Assumption>,
    /// Named parts of the map.
    #[serde(
        default,
        deserialize_with = "null_is_default",
        skip_serializing_if = "Vec::is_empty"
    )]
    pub zones: Vec<Zone>,
    /// Rules of the scene's own.
    #[serde(
        default,
        deserialize_with = "null_is_default",
        skip_serializing_if = "Vec::is_empty"
    )]
    pub constraints: Vec<Constraint>,
    /// What a cell and a time step are in the world.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub units: Option<Units>,
}

object_only!(Scene);

impl Scene {
    /// The rules of its own that are in force, with the agents that they bind.
    pub fn constraints_in_force(&self) -> impl Iterator<Item = InForce<'_>> {
        in_force(&self.constraints, &self.agents)
    }
}
