//! Painting the ground: a brush, a stroke.

use giveway_model::{Cell, Ground, Scene};

use crate::Tool;
use crate::things;

impl Tool {
    /// Whether the ground has what the tool paints.
    const fn is_painted(self, ground: Ground) -> bool {
        match self {
            Self::Obstacle => matches!(ground, Ground::Obstacle),
            Self::Charger => matches!(ground, Ground::Charger | Ground::SlowCharger),
            Self::SlowZone => matches!(ground, Ground::Slow | Ground::SlowCharger),
            Self::Erase => matches!(ground, Ground::Free),
            Self::Select | Self::Agent | Self::Goal | Self::Waypoint => false,
        }
    }

    /// The ground with what the tool paints, or without it.
    const fn paint(self, ground: Ground, on: bool) -> Ground {
        let charger = matches!(ground, Ground::Charger | Ground::SlowCharger);
        let slow = matches!(ground, Ground::Slow | Ground::SlowCharger);
        match (self, on) {
            (Self::Erase, _) | (Self::Obstacle, false) => Ground::Free,
            (Self::Obstacle, true) => Ground::Obstacle,
            (Self::Charger, on) => both(on, slow),
            (Self::SlowZone, on) => both(charger, on),
            (Self::Select | Self::Agent | Self::Goal | Self::Waypoint, _) => ground,
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
        let paints = tool != Tool::Select && !tool.is_of_agents();
        paints.then(|| Self {
            tool,
            on: tool == Tool::Erase || !tool.is_painted(ground),
        })
    }

    /// The scene after the brush went from one cell to another, both included;
    /// `None` where that changes nothing.
    ///
    /// What an agent needs is kept: no obstacle on a start, goal or waypoint.
    /// Erasing takes agents and waypoints away, too.
    pub(crate) fn stroke(self, scene: &Scene, from: Cell, to: Cell) -> Option<Scene> {
        let mut after: Option<Scene> = None;
        for cell in line(from, to) {
            let Some(old) = ground(after.as_ref().unwrap_or(scene), cell) else {
                continue;
            };
            if self.tool == Tool::Erase && is_needed(after.as_ref().unwrap_or(scene), cell) {
                things::erase(after.get_or_insert_with(|| scene.clone()), cell);
            }
            let new = self.tool.paint(old, self.on);
            if new == old || (new == Ground::Obstacle && is_needed(scene, cell)) {
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

/// Whether a cell is the start, goal or waypoint of an agent.
fn is_needed(scene: &Scene, cell: Cell) -> bool {
    let needs = |agent: &giveway_model::Agent| {
        agent.start == cell || agent.goal == cell || agent.waypoints.contains(&cell)
    };
    scene.agents.iter().any(needs)
}

/// A charger or an obstacle moved from one cell to another, where no agent
/// needs that; `tool` is the one that paints it.
pub(crate) fn moved(scene: &mut Scene, tool: Tool, from: Cell, to: Cell) {
    let (Some(old), Some(new)) = (ground(scene, from), ground(scene, to)) else {
        return;
    };
    if tool == Tool::Obstacle && is_needed(scene, to) {
        return;
    }
    set_ground(scene, from, tool.paint(old, false));
    set_ground(scene, to, tool.paint(new, true));
}

/// The tool that paints what can be moved from a cell: a charger, an obstacle.
pub(crate) fn movable(scene: &Scene, cell: Cell) -> Option<Tool> {
    let ground = ground(scene, cell)?;
    let tools = [Tool::Charger, Tool::Obstacle];
    tools.into_iter().find(|tool| tool.is_painted(ground))
}

/// The cells on the way of a pointer that jumped from one cell to another: each
/// shares a side with the next, so that a fast stroke leaves no gaps.
pub(crate) fn line(from: Cell, to: Cell) -> Vec<Cell> {
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
