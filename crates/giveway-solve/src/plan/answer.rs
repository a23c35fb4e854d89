//! The answer of a planner of the textbook.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Constraint, Cost, Costs, Objective, Plan, Version, message::read_map};
use serde::{Deserialize, Serialize};

use super::{PlanTrace, Planner};
use crate::{Reach, Reason, reach::within_alone};

/// The answer to a request for a plan.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
pub struct PlanAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The planner.
    pub planner: Planner,
    /// The objective.
    pub objective: Objective,
    /// How it ended.
    pub ended: PlanEnd,
    /// All five costs of the plan; `null` without one.
    pub costs: Option<Costs>,
    /// The proved lower bound of the first cost, where the planner proves one. It
    /// holds whatever the makespan.
    #[borsh(deserialize_with = "read_map")]
    pub bounds: BTreeMap<Cost, u32>,
    /// The plan, which the judge passed.
    pub plan: Option<Plan>,
    /// How much work it took.
    pub stats: PlanStats,
    /// How it went, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trace: Option<PlanTrace>,
}

/// How a planner ended. None of them proves that there is no plan, unless an
/// agent has none even alone.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "how", rename_all = "kebab-case")]
pub enum PlanEnd {
    /// No plan has less of the first cost.
    Best {
        /// How far that reaches; in JSON `within` alone.
        #[serde(rename = "within", serialize_with = "within_alone")]
        reach: Reach,
    },
    /// With a plan; there may be better ones.
    Found,
    /// No order that was tried works within a makespan. There may be a plan.
    NoOrderWorks {
        /// How many orders.
        tried: u32,
        /// The makespan, in steps, up to which they were tried.
        within: u32,
        /// The agent that got stuck in the last order.
        stuck: StuckAgent,
    },
    /// Early. There may be a plan.
    Stopped {
        /// Why.
        reason: Reason,
    },
    /// There is nothing up to the horizon. There may be a longer plan.
    Horizon {
        /// The horizon.
        within: u32,
    },
    /// The planner has no method for something in the instance.
    Refused {
        /// For what.
        lack: Lack,
    },
    /// An agent cannot do its task even alone, whatever the horizon.
    Alone {
        /// The agent.
        agent: String,
        /// The rules of the scene's own without which it could: none of them can be left out.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        rules: Vec<Constraint>,
    },
}

/// An agent that has no way around those planned before it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct StuckAgent {
    /// The agent.
    pub agent: String,
    /// Agents on its least-conflict optimal path.
    pub around: Vec<String>,
}

/// Something that a planner has no method for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "what", rename_all = "kebab-case")]
pub enum Lack {
    /// An agent without a goal.
    NoGoal {
        /// Which one.
        agent: String,
    },
    /// Batteries.
    Batteries {
        /// An agent that has one.
        agent: String,
    },
    /// Waypoints.
    Waypoints {
        /// An agent that has some.
        agent: String,
    },
    /// More waypoints than any planner can bear.
    ManyWaypoints {
        /// The agent that has them.
        agent: String,
    },
    /// Slow zones.
    SlowZones,
    /// Two agents with one goal.
    SharedGoals {
        /// The two agents.
        agents: [String; 2],
    },
    /// Rules of the scene's own.
    Rules {
        /// Those that the planner does not keep.
        rules: Vec<Constraint>,
    },
    /// The conditions of a question beside the instance.
    Questions,
    /// This cost as the first of the objective.
    Cost {
        /// The cost.
        cost: Cost,
    },
}

/// How much work a plan took.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct PlanStats {
    /// CPU seconds (wall seconds in the browser).
    pub cpu_seconds: f64,
    /// Steps, whose meaning depends on the planner: orders tried, nodes of the
    /// constraint tree, time steps, configurations, neighbourhoods.
    pub steps: u64,
}
