//! What lies on the floor, in layers, and how fine it is drawn.

use std::collections::BTreeSet;

use giveway_model::{Agent, Cell, Grid};

use crate::{CELL, Detail};

/// The smallest side of a cell that lines part from the next, in pixels.
const LINES_PX: f64 = 8.5;

/// How the floor is drawn, by the size of a cell on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloorLook {
    /// Whether cells are large enough for more than their colour.
    pub is_fine: bool,
    /// Whether lines part all cells.
    pub has_lines: bool,
    /// Whether every fifth of the lines is darker: cells are small, and counted in fives.
    pub has_fifths: bool,
    /// How far shapes that are cut reach into the next tile, in units: at least a
    /// pixel, and less than two.
    pub overlap: u8,
}

impl FloorLook {
    /// The look for cells of this many pixels.
    pub fn of(cell_px: f64) -> Self {
        // Powers of two, so that zooming seldom changes it.
        let reaches = |&overlap: &u8| f64::from(overlap) * cell_px >= CELL;
        let overlaps = [1, 2, 4, 8, 16, 32, 64];
        Self {
            is_fine: Detail::of(cell_px) > Detail::Dots,
            has_lines: cell_px >= LINES_PX,
            has_fifths: Detail::of(cell_px) < Detail::All,
            overlap: overlaps.into_iter().find(reaches).unwrap_or(100),
        }
    }
}

/// What is drawn of the floor, each over all that stand before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// The tint of the slow zone.
    SlowTint,
    /// Its hatch.
    Slow,
    /// The line around it.
    SlowEdge,
    /// Shelves of obstacles.
    Obstacle,
    /// The lines around them.
    ObstacleEdge,
    /// The plates of chargers.
    Charger,
    /// The bolts on them.
    Bolt,
}

impl Layer {
    /// All, from below to above.
    pub const ALL: [Self; Self::COUNT] = [
        Self::SlowTint,
        Self::Slow,
        Self::SlowEdge,
        Self::Obstacle,
        Self::ObstacleEdge,
        Self::Charger,
        Self::Bolt,
    ];

    /// How many there are.
    pub const COUNT: usize = 7;

    /// Its class in the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::SlowTint => "slow-t",
            Self::Slow => "slow",
            Self::SlowEdge => "slow-edge",
            Self::Obstacle => "obst",
            Self::ObstacleEdge => "obst-edge",
            Self::Charger => "chg",
            Self::Bolt => "bolt",
        }
    }
}

/// The chargers that a waypoint lies on.
pub fn starred(grid: &Grid, agents: &[Agent]) -> BTreeSet<Cell> {
    let waypoints = agents.iter().flat_map(|agent| &agent.waypoints);
    let on_charger = waypoints.filter(|&&cell| grid.is_charger(cell));
    on_charger.copied().collect()
}

/// The `d` of the lines between cells, one every so many cells.
pub fn lines(width: u32, height: u32, every: u32) -> String {
    let (right, bottom, every) = (100 * width, 100 * height, every.max(1));
    let places = |side: u32| (every..side).step_by(every as usize);
    let across = places(width).map(|x| format!("M{} 0V{bottom}", 100 * x));
    let down = places(height).map(|y| format!("M0 {}H{right}", 100 * y));
    across.chain(down).collect()
}
