//! An agent at the time shown.

mod battery;
mod doing;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use giveway_model::sorting::set;
use giveway_model::{Cell, tr};

use crate::timeline::Lane;
use crate::words::at;
use crate::{Reserve, State};

pub use battery::BatteryFacts;

use doing::doing;

/// What the inspector tells of an agent.
#[derive(Clone, Debug, PartialEq)]
pub struct AgentFacts {
    /// Its index in the scene.
    pub agent: usize,
    /// Its name.
    pub name: String,
    /// What it does: `Charging at (6, 2), then to (6, 1)`.
    pub doing: String,
    /// Its battery, if it has one.
    pub battery: Option<BatteryFacts>,
    /// How many of its waypoints it has visited, and how many there are.
    pub waypoints: (usize, usize),
    /// Its plan; `None` without one.
    pub lane: Option<Lane>,
}

/// The plan of an agent of the draft. The answer may be of an older draft:
/// agents are found in it by their names.
pub fn planned(state: &State, agent: usize) -> Option<Lane> {
    let answer = state.shown()?;
    Lane::of(answer, answer.agent(state.world(), agent)?)
}

/// What there is to tell of an agent of the draft; `None` if there is none.
pub fn agent(state: &State, agent: usize) -> Option<AgentFacts> {
    let who = state.world().agents().get(agent)?;
    let time = state.view.playback.time;
    let lane = planned(state, agent);
    let battery = who.battery.map(|battery| {
        let level = lane.as_ref().and_then(|lane| lane.level_at(time));
        let level = level.unwrap_or(battery.initial);
        let charges = lane
            .as_ref()
            .is_some_and(|lane| lane.charges.contains(&time));
        BatteryFacts {
            level,
            capacity: battery.capacity,
            charges,
            reserve: Reserve::of(level, battery.capacity),
        }
    });
    let doing = match &lane {
        Some(lane) => doing(lane, time),
        None if state.document.mode.changing().is_some() => {
            tr!("Joins at {cell}", cell = at(who.start))
        }
        None => match who.goal {
            Some(goal) => tr!(
                "From {start} to {goal}",
                start = at(who.start),
                goal = at(goal)
            ),
            None => tr!("From {start}, rests anywhere", start = at(who.start)),
        },
    };
    let visited = lane.as_ref().map(|lane| visited(lane, time));
    let is_visited = |cell: &&Cell| visited.as_ref().is_some_and(|cells| cells.contains(cell));
    Some(AgentFacts {
        agent,
        name: who.name.clone(),
        doing,
        battery,
        waypoints: (
            who.waypoints.iter().filter(is_visited).count(),
            who.waypoints.len(),
        ),
        lane,
    })
}

/// The cells that an agent was on up to a time.
fn visited(lane: &Lane, time: u32) -> BTreeSet<Cell> {
    let reached = lane.steps.iter().filter(|step| step.ends <= time);
    let mut cells = set(reached.map(|step| step.to));
    if lane.begins <= time {
        cells.insert(lane.entry);
    }
    cells
}
