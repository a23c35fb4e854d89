//! The formats, each with its name and its makers.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

/// A format of files.
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
pub enum Format {
    /// The project's own JSON.
    #[serde(rename = "giveway")]
    Giveway,
    /// A map and a scenario of the standard benchmark.
    #[serde(rename = "movingai")]
    MovingAi,
    /// A plan of the MAPF tracker: a string of letters for each agent.
    #[serde(rename = "tracker")]
    Tracker,
    /// A line for each agent, `Agent 0: (r,c)->(r,c)->`.
    #[serde(rename = "paths.txt")]
    Paths,
    /// A line for each time step, after `solution=`.
    #[serde(rename = "result.txt")]
    Result,
    /// Scenarios and schedules of libMultiRobotPlanning.
    #[serde(rename = "multi-robot")]
    MultiRobot,
    /// Results of the League of Robot Runners.
    #[serde(rename = "lorr")]
    League,
    /// Facts of asprilo.
    #[serde(rename = "asprilo")]
    Asprilo,
    /// Benchmarks and solutions of mapfw.nl.
    #[serde(rename = "mapfw")]
    Mapfw,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Giveway,
        Self::MovingAi,
        Self::Tracker,
        Self::Paths,
        Self::Result,
        Self::MultiRobot,
        Self::League,
        Self::Asprilo,
        Self::Mapfw,
    ];

    /// The name that programs use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Giveway => "giveway",
            Self::MovingAi => "movingai",
            Self::Tracker => "tracker",
            Self::Paths => "paths.txt",
            Self::Result => "result.txt",
            Self::MultiRobot => "multi-robot",
            Self::League => "lorr",
            Self::Asprilo => "asprilo",
            Self::Mapfw => "mapfw",
        }
    }

    /// What such a file looks like, as a heading: `One line for each robot`.
    pub const fn looks(self) -> &'static str {
        match self {
            Self::Giveway => "Giveway's own JSON",
            Self::MovingAi => "Map and scenario",
            Self::Tracker => "A string of letters for each robot",
            Self::Paths => "One line for each robot",
            Self::Result => "One line for each time step",
            Self::MultiRobot => "YAML, a list of states for each robot",
            Self::League => "JSON, a string of actions for each robot",
            Self::Asprilo => "Facts of a logic program",
            Self::Mapfw => "JSON with waypoints",
        }
    }

    /// Who writes it: `EECBS and CBSH2 write it`, after *as*.
    pub const fn makers(self) -> &'static str {
        match self {
            Self::Giveway => "Giveway writes it",
            Self::MovingAi => "the standard benchmark has it",
            Self::Tracker => "the MAPF tracker has it",
            Self::Paths => "EECBS and CBSH2 write it",
            Self::Result => "LaCAM and pibt2 write it",
            Self::MultiRobot => "libMultiRobotPlanning writes it",
            Self::League => "the League of Robot Runners writes it",
            Self::Asprilo => "asprilo and clingo write it",
            Self::Mapfw => "mapfw.nl has it",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
