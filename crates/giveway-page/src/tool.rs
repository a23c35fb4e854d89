//! The tools: what the pointer does on the board.

use giveway_model::tr;

use crate::edit::Paint;

/// What the pointer does on the board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Selects agents and cells, and moves what is on them.
    #[default]
    Select,
    /// Paints obstacles.
    Obstacle,
    /// Paints chargers; they stay in a slow zone.
    Charger,
    /// Paints slow zones; chargers stay in them.
    SlowZone,
    /// Takes away what is on cells.
    Erase,
    /// Marks cells as a zone, for rules of the scene's own.
    Zone,
    /// Leads a one-way lane along cells.
    OneWay,
    /// Places agents with their goals.
    Agent,
    /// Gives the selected agent another goal.
    Goal,
    /// Gives the selected agent waypoints, and takes them away.
    Waypoint,
}

impl Tool {
    /// All tools, in the order of the toolbar.
    pub const ALL: [Self; 10] = [
        Self::Select,
        Self::Obstacle,
        Self::Charger,
        Self::SlowZone,
        Self::Erase,
        Self::Zone,
        Self::OneWay,
        Self::Agent,
        Self::Goal,
        Self::Waypoint,
    ];

    /// The accessible name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Select => tr!("Select"),
            Self::Obstacle => tr!("Obstacle"),
            Self::Charger => tr!("Charger"),
            Self::SlowZone => tr!("Slow zone"),
            Self::Erase => tr!("Erase"),
            Self::Zone => tr!("a tool" => "Zone"),
            Self::OneWay => tr!("a tool" => "One-way"),
            Self::Agent => tr!("Robot"),
            Self::Goal => tr!("Goal"),
            Self::Waypoint => tr!("Waypoint"),
        }
    }

    /// The key that picks it.
    pub const fn key(self) -> char {
        match self {
            Self::Select => 'v',
            Self::Obstacle => 'o',
            Self::Charger => 'c',
            Self::SlowZone => 's',
            Self::Erase => 'e',
            Self::Zone => 'z',
            Self::OneWay => 'r',
            Self::Agent => 'a',
            Self::Goal => 'g',
            Self::Waypoint => 'w',
        }
    }

    /// The name of its icon.
    pub const fn icon(self) -> &'static str {
        match self {
            Self::Select => "select",
            Self::Obstacle => "obstacle",
            Self::Charger => "charger",
            Self::SlowZone => "slow",
            Self::Erase => "erase",
            Self::Zone => "zone",
            Self::OneWay => "one-way",
            Self::Agent => "agent",
            Self::Goal => "goal",
            Self::Waypoint => "waypoint",
        }
    }

    /// What it paints, if it does.
    pub(crate) const fn paint(self) -> Option<Paint> {
        match self {
            Self::Obstacle => Some(Paint::Obstacle),
            Self::Charger => Some(Paint::Charger),
            Self::SlowZone => Some(Paint::Slow),
            Self::Select
            | Self::Erase
            | Self::Zone
            | Self::OneWay
            | Self::Agent
            | Self::Goal
            | Self::Waypoint => None,
        }
    }

    /// Whether it paints the ground of cells, or takes it away.
    pub(crate) fn can_paint(self) -> bool {
        self.paint().is_some() || self == Self::Erase
    }

    /// Whether it is about rules of the scene's own.
    pub const fn is_of_rules(self) -> bool {
        matches!(self, Self::Zone | Self::OneWay)
    }

    /// Whether it acts on agents, so that it begins where they begin.
    pub(crate) const fn is_of_agents(self) -> bool {
        matches!(self, Self::Agent | Self::Goal | Self::Waypoint)
    }
}
