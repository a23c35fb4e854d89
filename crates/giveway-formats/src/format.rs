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
    /// Instances of the class project, rows first.
    #[serde(rename = "class-project")]
    ClassProject,
    /// A grid of marks without a header.
    #[serde(rename = "grid")]
    Grid,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Giveway,
        Self::MovingAi,
        Self::Tracker,
        Self::Paths,
        Self::Result,
        Self::MultiRobot,
        Self::League,
        Self::Asprilo,
        Self::Mapfw,
        Self::ClassProject,
        Self::Grid,
    ];

    /// The name that programs use.
    pub const fn name(self) -> &'static str {
        self.about().0
    }

    /// The look of such a file, as a heading: `One line for each robot`.
    pub const fn looks(self) -> &'static str {
        self.about().1
    }

    /// The programs that write it: `EECBS and CBSH2 write it`, after *as*.
    pub const fn makers(self) -> &'static str {
        self.about().2
    }

    /// The name, what a file looks like, and who writes it.
    const fn about(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Giveway => ("giveway", "Giveway's own JSON", "Giveway writes it"),
            Self::MovingAi => (
                "movingai",
                "Map and scenario",
                "the standard benchmark has it",
            ),
            Self::Tracker => (
                "tracker",
                "A string of letters for each robot",
                "the MAPF tracker has it",
            ),
            Self::Paths => (
                "paths.txt",
                "One line for each robot",
                "EECBS and CBSH2 write it",
            ),
            Self::Result => (
                "result.txt",
                "One line for each time step",
                "LaCAM and pibt2 write it",
            ),
            Self::MultiRobot => (
                "multi-robot",
                "YAML, a list of states for each robot",
                "libMultiRobotPlanning writes it",
            ),
            Self::League => (
                "lorr",
                "JSON, a string of actions for each robot",
                "the League of Robot Runners writes it",
            ),
            Self::Asprilo => (
                "asprilo",
                "Facts of a logic program",
                "asprilo and clingo write it",
            ),
            Self::Mapfw => ("mapfw", "JSON with waypoints", "mapfw.nl has it"),
            Self::ClassProject => (
                "class-project",
                "Rows, then a line for each robot",
                "the class project on path finding has it",
            ),
            Self::Grid => ("grid", "A grid with letters for robots", "people type it"),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
