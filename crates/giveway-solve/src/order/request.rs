//! The request for the order of a plan.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Objective, Plan, Scene, change::Changes, format::from_object};
use giveway_order::Lateness;
use serde::{Deserialize, Serialize};

use crate::Limits;

/// Who must begin to leave each cell before who begins to come?
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct OrderRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The plan; without one, the scene is solved first. With changes it has to be there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// What changes while the plan runs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changes: Option<Changes>,
    /// The agents that come late, and where; none of these: nothing is said of lateness.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub late: Vec<Lateness>,
    /// Other formats in which the order is written, too.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub to: Vec<OrderFormat>,
    /// The objective of the search for a plan, where it is not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon of that search, in time steps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// The budget of that search.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

/// A format in which an order is written.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum OrderFormat {
    /// A graph for Graphviz.
    Dot,
    /// Way-points as a table.
    Csv,
    /// Way-points as JSON.
    Waypoints,
    /// Orders of VDA 5050, as JSON.
    Vda5050,
}

impl OrderFormat {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Dot, Self::Csv, Self::Waypoints, Self::Vda5050];

    /// The name in requests and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dot => "dot",
            Self::Csv => "csv",
            Self::Waypoints => "waypoints",
            Self::Vda5050 => "vda5050",
        }
    }
}
