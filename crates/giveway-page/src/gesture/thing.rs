//! Something on a cell that can be moved by hand.

use giveway_model::{Agent, Cell, Scene};

use crate::Draft;
use crate::edit::Paint;

/// Something that can be moved from its cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Thing {
    /// The start of an agent.
    Start(usize),
    /// The goal of an agent.
    Goal(usize),
    /// A waypoint of an agent.
    Waypoint(usize),
    /// A waypoint of an agent that is not there yet.
    NewWaypoint(usize),
    /// A charger or an obstacle.
    Paint(Paint),
}

impl Thing {
    /// What lies on a cell, the uppermost first; of marks, one of the agent that
    /// is selected goes before.
    pub(crate) fn lying(draft: &Draft, cell: Cell, selected: Option<usize>) -> Option<Self> {
        let scene: &Scene = draft.scene();
        let goal = |agent: &Agent| agent.goal == Some(cell);
        let waypoint = |agent: &Agent| agent.waypoints.contains(&cell);
        let mine = selected.and_then(|index| match scene.agents.get(index)? {
            who if goal(who) => Some(Self::Goal(index)),
            who if waypoint(who) => Some(Self::Waypoint(index)),
            _ => None,
        });
        let agents = || scene.agents.iter();
        mine.or_else(|| agents().position(goal).map(Self::Goal))
            .or_else(|| agents().position(waypoint).map(Self::Waypoint))
            .or_else(|| Self::painted(draft, cell))
    }

    /// The charger or the obstacle that can be moved from a cell.
    pub(crate) fn painted(draft: &Draft, cell: Cell) -> Option<Self> {
        let ground = draft.grid().ground(cell)?;
        let paints = [Paint::Charger, Paint::Obstacle];
        let paint = paints.into_iter().find(|paint| paint.is_on(ground))?;
        Some(Self::Paint(paint))
    }
}
