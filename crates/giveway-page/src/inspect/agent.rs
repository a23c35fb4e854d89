//! An agent at the time shown.

use std::collections::BTreeSet;

use giveway_model::Cell;

use crate::timeline::{Lane, Way};
use crate::words::at;
use crate::{Reserve, State};
use giveway_model::sorting::set;

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

/// What the inspector tells of a battery.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BatteryFacts {
    /// The level.
    pub level: u32,
    /// The level after a charge.
    pub capacity: u32,
    /// Whether the agent charges at the time shown.
    pub charges: bool,
    /// How full it is.
    pub reserve: Reserve,
}

impl BatteryFacts {
    /// The most cells of the picture.
    const CELLS: u32 = 12;

    /// How many cells of the picture are full, and how many there are: a cell a
    /// step, if there are not too many.
    pub const fn cells(&self) -> (u32, u32) {
        if self.capacity <= Self::CELLS {
            return (self.level, self.capacity);
        }
        let full = self.level as u64 * Self::CELLS as u64;
        // Only an empty battery is shown as empty.
        (full.div_ceil(self.capacity as u64) as u32, Self::CELLS)
    }
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
        None if state.document.mode.changing().is_some() => format!("Joins at {}", at(who.start)),
        None => format!("From {} to {}", at(who.start), at(who.goal)),
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

/// What an agent does in the step that begins at a time.
fn doing(lane: &Lane, time: u32) -> String {
    if time < lane.begins {
        return format!("Joins at {} on {}", lane.begins, at(lane.entry));
    }
    let Some(step) = lane.step_at(time) else {
        let end = at(lane.end());
        if let Some(until) = lane.removed {
            return if time < until {
                format!("At {end}, gone from time {until} on")
            } else {
                format!("Removed at time {until}")
            };
        }
        if !lane.arrives {
            return format!("At {end}, not led any further");
        }
        return if lane.stays || time == lane.arrival {
            format!("Arrived at {end}")
        } else {
            format!("Arrived at {end}, and gone")
        };
    };
    let (from, to) = (at(step.from), at(step.to));
    let charges = lane.charges.contains(&time);
    match step.way {
        _ if step.begins < time => format!("Half way from {from} to {to}"),
        Way::Move if charges => format!("Charging at {from}, then to {to}"),
        Way::Slow if charges => format!("Charging at {from}, then slowly to {to}"),
        Way::Wait if charges => format!("Charging at {from}, and waiting there"),
        Way::Move => format!("Going from {from} to {to}"),
        Way::Slow => format!("Going slowly from {from} to {to}"),
        Way::Wait => {
            let later = lane.steps.iter().filter(|step| step.begins >= time);
            let waits = later.take_while(|step| step.way == Way::Wait);
            let until = waits.last().map_or(time, |step| step.ends);
            format!("Waiting at {from} until {until}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PlayAction;
    use crate::{Action, reduce, sample};

    fn facts(agent: usize, time: u32) -> AgentFacts {
        let state = reduce(&sample::solved(), Action::Play(PlayAction::Seek(time)));
        super::agent(&state, agent).unwrap()
    }

    #[test]
    fn a_charge() {
        let facts = facts(0, 9);
        assert_eq!(facts.doing, "Charging at (6, 2), then to (6, 1)");
        assert_eq!(facts.waypoints, (2, 3));
        let battery = facts.battery.unwrap();
        assert_eq!((battery.level, battery.charges), (1, true));
        assert_eq!(battery.cells(), (1, 10));
        assert_eq!(battery.reserve, Reserve::Critical);
    }

    #[test]
    fn a_slow_move_and_half_of_it() {
        assert_eq!(facts(1, 9).doing, "Going slowly from (4, 0) to (3, 0)");
        assert_eq!(facts(1, 10).doing, "Half way from (4, 0) to (3, 0)");
    }

    #[test]
    fn the_end() {
        let facts = facts(0, 18);
        assert_eq!(facts.doing, "Arrived at (9, 2)");
        assert_eq!(facts.waypoints, (3, 3));
        assert_eq!(facts.battery.unwrap().level, 3);
    }

    #[test]
    fn without_a_plan() {
        let state = State::new(sample::draft());
        let facts = super::agent(&state, 1).unwrap();
        assert_eq!(facts.doing, "From (9, 2) to (0, 0)");
        assert_eq!(facts.waypoints.0, 0);
        assert_eq!(facts.battery.unwrap().level, 8);
        assert_eq!(super::agent(&state, 2), None);
    }

    #[test]
    fn a_wait_tells_its_end() {
        let lane = |charges| Lane {
            agent: 0,
            name: "A1".to_owned(),
            entry: Cell::new(0, 0),
            begins: 0,
            arrival: 3,
            arrives: true,
            stays: false,
            removed: None,
            steps: [(0, 1, 0), (1, 2, 0), (2, 3, 1)]
                .map(|(begins, ends, x)| crate::timeline::Step {
                    way: if x == 0 { Way::Wait } else { Way::Move },
                    begins,
                    ends,
                    from: Cell::new(0, 0),
                    to: Cell::new(x, 0),
                })
                .to_vec(),
            charges,
            capacity: None,
            levels: Vec::new(),
        };
        assert_eq!(doing(&lane(vec![]), 0), "Waiting at (0, 0) until 2");
        assert_eq!(
            doing(&lane(vec![1]), 1),
            "Charging at (0, 0), and waiting there"
        );
        assert_eq!(doing(&lane(vec![]), 3), "Arrived at (1, 0)");
        assert_eq!(doing(&lane(vec![]), 4), "Arrived at (1, 0), and gone");
    }

    #[test]
    fn a_large_battery_is_drawn_with_a_few_cells() {
        let cells = |level| {
            let reserve = Reserve::Enough;
            let (capacity, charges) = (1_000_000, false);
            BatteryFacts {
                level,
                capacity,
                charges,
                reserve,
            }
            .cells()
        };
        assert_eq!(cells(1_000_000), (12, 12));
        assert_eq!(cells(1), (1, 12));
        assert_eq!(cells(0), (0, 12));
    }
}
