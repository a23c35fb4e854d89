//! Painting the ground: a tool, a stroke, a new map.

use giveway_model::{Cell, Ground, Scene};

/// What the pointer does on the board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Selects agents and cells.
    #[default]
    Select,
    /// Paints obstacles.
    Obstacle,
    /// Paints chargers; they stay in a slow zone.
    Charger,
    /// Paints slow zones; chargers stay in them.
    SlowZone,
    /// Frees cells.
    Erase,
}

impl Tool {
    /// All tools, in the order of the toolbar.
    pub const ALL: [Self; 5] = [
        Self::Select,
        Self::Obstacle,
        Self::Charger,
        Self::SlowZone,
        Self::Erase,
    ];

    /// The accessible name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Select => "Select",
            Self::Obstacle => "Obstacle",
            Self::Charger => "Charger",
            Self::SlowZone => "Slow zone",
            Self::Erase => "Erase",
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
        }
    }

    /// Whether the ground has what the tool paints.
    const fn is_painted(self, ground: Ground) -> bool {
        match self {
            Self::Select => false,
            Self::Obstacle => matches!(ground, Ground::Obstacle),
            Self::Charger => matches!(ground, Ground::Charger | Ground::SlowCharger),
            Self::SlowZone => matches!(ground, Ground::Slow | Ground::SlowCharger),
            Self::Erase => matches!(ground, Ground::Free),
        }
    }

    /// The ground with what the tool paints, or without it.
    const fn paint(self, ground: Ground, on: bool) -> Ground {
        let charger = matches!(ground, Ground::Charger | Ground::SlowCharger);
        let slow = matches!(ground, Ground::Slow | Ground::SlowCharger);
        match (self, on) {
            (Self::Select, _) => ground,
            (Self::Erase, _) | (Self::Obstacle, false) => Ground::Free,
            (Self::Obstacle, true) => Ground::Obstacle,
            (Self::Charger, on) => both(on, slow),
            (Self::SlowZone, on) => both(charger, on),
        }
    }
}

const fn both(charger: bool, slow: bool) -> Ground {
    match (charger, slow) {
        (true, true) => Ground::SlowCharger,
        (true, false) => Ground::Charger,
        (false, true) => Ground::Slow,
        (false, false) => Ground::Free,
    }
}

/// A stroke of the brush: whether it paints or takes away is settled where it
/// begins, so that a stroke over mixed ground leaves it even.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Brush {
    tool: Tool,
    on: bool,
}

impl Brush {
    /// A stroke that begins on a cell; `None` where the tool paints nothing.
    pub(crate) fn begin(scene: &Scene, tool: Tool, cell: Cell) -> Option<Self> {
        let ground = ground(scene, cell)?;
        let paints = tool != Tool::Select;
        paints.then(|| Self {
            tool,
            on: tool == Tool::Erase || !tool.is_painted(ground),
        })
    }

    /// The scene after the brush went from one cell to another, both included;
    /// `None` where that changes nothing.
    ///
    /// What an agent needs is kept: no obstacle on a start, goal or waypoint.
    pub(crate) fn stroke(self, scene: &Scene, from: Cell, to: Cell) -> Option<Scene> {
        let mut after: Option<Scene> = None;
        for cell in line(from, to) {
            let Some(old) = ground(after.as_ref().unwrap_or(scene), cell) else {
                continue;
            };
            let new = self.tool.paint(old, self.on);
            if new == old || (new == Ground::Obstacle && needed_by(scene, cell).is_some()) {
                continue;
            }
            let scene = after.get_or_insert_with(|| scene.clone());
            set_ground(scene, cell, new);
        }
        after
    }
}

/// The ground of a cell; `None` off the map.
fn ground(scene: &Scene, cell: Cell) -> Option<Ground> {
    let row = scene.map.get(cell.y as usize)?;
    let letter = row.chars().nth(cell.x as usize)?;
    Ground::from_char(letter)
}

fn set_ground(scene: &mut Scene, cell: Cell, ground: Ground) {
    if let Some(row) = scene.map.get_mut(cell.y as usize) {
        let mut letters: Vec<char> = row.chars().collect();
        if let Some(letter) = letters.get_mut(cell.x as usize) {
            *letter = ground.to_char();
        }
        *row = letters.into_iter().collect();
    }
}

/// The agent whose start, goal or waypoint a cell is.
fn needed_by(scene: &Scene, cell: Cell) -> Option<&str> {
    let needs = |agent: &&giveway_model::Agent| {
        agent.start == cell || agent.goal == cell || agent.waypoints.contains(&cell)
    };
    scene
        .agents
        .iter()
        .find(needs)
        .map(|agent| agent.name.as_str())
}

/// The cells on the way of a pointer that jumped from one cell to another: each
/// shares a side with the next, so that a fast stroke leaves no gaps.
fn line(from: Cell, to: Cell) -> Vec<Cell> {
    let (width, height) = (from.x.abs_diff(to.x), from.y.abs_diff(to.y));
    let (mut at, mut across, mut down) = (from, 0, 0);
    let mut cells = vec![from];
    while at != to {
        // The direction of which the smaller share is done.
        let (done_across, done_down) = ((2 * across + 1) * height, (2 * down + 1) * width);
        if down == height || (across < width && done_across <= done_down) {
            across += 1;
            at.x = towards(at.x, to.x);
        } else {
            down += 1;
            at.y = towards(at.y, to.y);
        }
        cells.push(at);
    }
    cells
}

const fn towards(at: u32, to: u32) -> u32 {
    if to > at {
        at + 1
    } else {
        at.saturating_sub(1)
    }
}
