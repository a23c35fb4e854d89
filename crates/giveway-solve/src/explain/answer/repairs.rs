//! Repairs: edits of an instance that help.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Costs, Plan};
use serde::{Deserialize, Serialize};

/// A change of the instance that a person may make.
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
#[serde(tag = "edit", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Edit {
    /// Free an obstacle's cell.
    RemoveObstacle {
        /// The cell.
        cell: Cell,
    },
    /// Put a charger on a cell.
    AddCharger {
        /// The cell.
        cell: Cell,
    },
    /// Give an agent a larger and fuller battery.
    Battery {
        /// The agent.
        agent: String,
        /// Its new capacity.
        capacity: u32,
        /// Its new level at time 0, or at the time from which a question is
        /// answered where the world changed before.
        initial: u32,
    },
    /// Lower the level that no battery may fall below.
    BatteryFloor {
        /// The new floor.
        floor: u32,
    },
    /// Allow a later makespan.
    Deadline {
        /// The new horizon.
        within: u32,
    },
    /// Take a cell out of the slow zone.
    MakeNormal {
        /// The cell.
        cell: Cell,
    },
    /// Let an agent leave a waypoint out.
    DropWaypoint {
        /// The agent.
        agent: String,
        /// The waypoint.
        cell: Cell,
    },
    /// Let arrived agents vanish instead of stay.
    Vanish,
    /// Leave an agent out.
    LeaveOut {
        /// The agent.
        agent: String,
    },
    /// Switch a rule of the scene's own off.
    SwitchOff {
        /// Its number in the scene, from 0.
        index: u32,
        /// The rule in words: its name, or else its sentence.
        rule: String,
    },
    /// Allow more agents in the zone of a rule, or more wait steps on end.
    AllowMore {
        /// Its number in the scene, from 0.
        index: u32,
        /// The rule in words: its name, or else its sentence.
        rule: String,
        /// The new number.
        most: u32,
    },
    /// Give the agents of a rule longer: a later end of its times, or a later arrival.
    GiveUntil {
        /// Its number in the scene, from 0.
        index: u32,
        /// The rule in words: its name, or else its sentence.
        rule: String,
        /// The new last time, of a running plan in times of the whole.
        to: u32,
    },
}

/// A repair: edits after which there is a plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Repair {
    /// The edits, all of them needed.
    pub edits: Vec<Edit>,
    /// Whether its battery, floor or deadline is proved to be the least change of
    /// its kind that helps; true where the edits have no such number.
    pub least: bool,
    /// The costs of the plan.
    pub costs: Costs,
    /// When the agent arrives then whose arrival is asked about, in time steps of the whole plan; `None` of other
    /// questions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arrival: Option<u32>,
    /// Whether no plan of the edited instance is better.
    #[serde(default)]
    pub proved: bool,
    /// A best plan of the edited instance, or one found in time.
    pub plan: Plan,
    /// The repair as a sentence.
    pub text: String,
}
