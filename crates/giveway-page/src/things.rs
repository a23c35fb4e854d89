//! What stands and lies on the ground, and how it is moved by hand: starts,
//! goals, waypoints, chargers, obstacles.

use giveway_model::{Agent, Cell, Scene};

use crate::Tool;
use crate::ground::{self, Brush};

/// What a stroke does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hold {
    /// Paints.
    Brush(Brush),
    /// Moves something.
    Thing(Thing),
    /// Moves a waypoint of an agent; where it never left its cell, takes it away.
    Toggle(usize),
}

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
    /// A charger or an obstacle, by the tool that paints it.
    Ground(Tool),
}

impl Thing {
    /// What lies on a cell, the uppermost first; of marks, one of the agent that
    /// is selected goes before.
    pub(crate) fn lying(scene: &Scene, cell: Cell, selected: Option<usize>) -> Option<Self> {
        let goal = |agent: &Agent| agent.goal == cell;
        let waypoint = |agent: &Agent| agent.waypoints.contains(&cell);
        let of = |selected: Option<usize>| selected.filter(|&agent| agent < scene.agents.len());
        let mine = of(selected).and_then(|agent| match &scene.agents[agent] {
            who if goal(who) => Some(Self::Goal(agent)),
            who if waypoint(who) => Some(Self::Waypoint(agent)),
            _ => None,
        });
        let agents = || scene.agents.iter();
        mine.or_else(|| agents().position(goal).map(Self::Goal))
            .or_else(|| agents().position(waypoint).map(Self::Waypoint))
            .or_else(|| ground::movable(scene, cell).map(Self::Ground))
    }

    /// Whose it is.
    pub(crate) const fn agent(self) -> Option<usize> {
        match self {
            Self::Start(agent)
            | Self::Goal(agent)
            | Self::Waypoint(agent)
            | Self::NewWaypoint(agent) => Some(agent),
            Self::Ground(_) => None,
        }
    }

    /// Moves it from one cell of a scene to another.
    pub(crate) fn go(self, scene: &mut Scene, from: Cell, to: Cell) {
        if let Self::Ground(tool) = self {
            return ground::moved(scene, tool, from, to);
        }
        let agent = self.agent().and_then(|agent| scene.agents.get_mut(agent));
        let Some(agent) = agent else { return };
        let is_new = !agent.waypoints.contains(&to);
        match self {
            Self::Start(_) => agent.start = to,
            Self::Goal(_) => agent.goal = to,
            Self::NewWaypoint(_) if is_new => agent.waypoints.push(to),
            Self::Waypoint(_) if is_new => {
                for waypoint in &mut agent.waypoints {
                    if *waypoint == from {
                        *waypoint = to;
                    }
                }
            }
            Self::Waypoint(_) | Self::NewWaypoint(_) | Self::Ground(_) => {}
        }
    }
}

/// Takes away what agents have on a cell: an agent that starts there, waypoints;
/// an agent whose goal was there stays where it starts.
pub(crate) fn erase(scene: &mut Scene, cell: Cell) {
    scene.agents.retain(|agent| agent.start != cell);
    for agent in &mut scene.agents {
        agent.waypoints.retain(|&waypoint| waypoint != cell);
        if agent.goal == cell {
            agent.goal = agent.start;
        }
    }
}

/// A name that no agent has: `A7`, of the least free number.
pub(crate) fn fresh_name(scene: &Scene) -> String {
    let is_free = |name: &String| scene.agents.iter().all(|agent| agent.name != *name);
    let names = (1..=scene.agents.len() + 1).map(|number| format!("A{number}"));
    names.into_iter().find(is_free).unwrap_or_default()
}
