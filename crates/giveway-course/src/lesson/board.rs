//! What a step says of the board: the tools at hand, and what is laid over the map.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

/// A tool that a learner may use on the board. To look and to select is always allowed.
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
pub enum Tool {
    /// Moves what stands on the board by hand.
    Move,
    /// Paints obstacles.
    Obstacle,
    /// Paints chargers.
    Charger,
    /// Paints slow zones.
    SlowZone,
    /// Takes away what is on cells.
    Erase,
    /// Places robots with their goals.
    Robot,
    /// Gives a robot another goal.
    Goal,
    /// Gives a robot waypoints.
    Waypoint,
}

impl Tool {
    /// All of them, in the order of the toolbar.
    pub const ALL: [Self; 8] = [
        Self::Move,
        Self::Obstacle,
        Self::Charger,
        Self::SlowZone,
        Self::Erase,
        Self::Robot,
        Self::Goal,
        Self::Waypoint,
    ];
}

/// Something that is shown beside the map, or laid over it.
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
pub enum Layer {
    /// Ways behind and ahead.
    Trails,
    /// Cells shaded by how much they are used.
    Heat,
    /// The timeline, a lane a robot.
    Lanes,
    /// The plan as a table.
    Table,
    /// How the plan was found and proved.
    Inside,
    /// The conflict tree, split by hand.
    ByHand,
    /// What all best plans share.
    Freedom,
    /// The proof that no plan is better, to be checked beside the text.
    Proof,
}
