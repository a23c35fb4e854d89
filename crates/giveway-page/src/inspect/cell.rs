//! A cell: what it is, whose it is, and who passes when.

use giveway_model::{Cell, Ground, tr};

use crate::changing::broken_down_for_good;
use crate::timeline::Lane;
use crate::{State, table};
use giveway_model::sorting::sort_by_key;

/// What the inspector tells of a cell.
#[derive(Clone, Debug, PartialEq)]
pub struct CellFacts {
    /// Its place: `8, 0`.
    pub title: String,
    /// What it is: `Charger in the slow zone`.
    pub ground: &'static str,
    /// The icon of that, and none for free cells.
    pub icon: Option<&'static str>,
    /// Whose start, goal or waypoint it is, and who has broken down on it for good: the agent's
    /// index, and `Start of A1`.
    pub roles: Vec<(usize, String)>,
    /// The zones that it is part of, by name.
    pub zones: Vec<String>,
    /// Who is on it and when, by time; `None` without a plan.
    pub passes: Option<Vec<Pass>>,
}

/// A stay of an agent on a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pass {
    /// The agent's index in the scene that was solved.
    pub agent: usize,
    /// Its name.
    pub name: String,
    /// The first time.
    pub from: u32,
    /// When: `at 9, charging`, `from 3 to 5`.
    pub when: String,
}

/// What there is to tell of a cell; `None` off the map.
pub fn cell(state: &State, cell: Cell) -> Option<CellFacts> {
    let (ground, icon) = match state.world().grid().ground(cell)? {
        Ground::Free => (tr!("Free cell"), None),
        Ground::Obstacle => (tr!("Obstacle"), Some("obstacle")),
        Ground::Slow => (tr!("Slow zone"), Some("slow")),
        Ground::Charger => (tr!("Charger"), Some("charger")),
        Ground::SlowCharger => (tr!("Charger in the slow zone"), Some("charger")),
    };
    let mut roles = Vec::new();
    for (index, agent) in state.world().agents().iter().enumerate() {
        if !state.is_there(index) {
            continue;
        }
        let name = &agent.name;
        for (is, what) in [
            (agent.start == cell, tr!("Start")),
            (agent.goal == Some(cell), tr!("Goal")),
            (agent.waypoints.contains(&cell), tr!("Waypoint")),
        ] {
            if is {
                roles.push((index, tr!("{what} of {name}", what, name)));
            }
        }
    }
    for stopped in broken_down_for_good(state) {
        if let Some(agent) = stopped.agent.filter(|_| stopped.cell == cell) {
            let name = &stopped.name;
            roles.push((agent, tr!("{name}, broken down for good", name)));
        }
    }
    let answer = state.playing();
    let passes = answer.map(|answer| {
        let mut passes: Vec<Pass> = table::lanes(answer, &state.document.draft)
            .iter()
            .flat_map(|lane| stays(lane, cell))
            .collect();
        sort_by_key(&mut passes, |pass| (pass.from, pass.agent));
        passes
    });
    let zones = state.world().scene().zones.iter();
    let zones = zones.filter(|zone| zone.has(cell));
    Some(CellFacts {
        zones: zones.map(|zone| zone.name.clone()).collect(),
        title: format!("{}, {}", cell.x, cell.y),
        ground,
        icon,
        roles,
        passes,
    })
}

/// The stays of one agent on a cell.
fn stays(lane: &Lane, cell: Cell) -> Vec<Pass> {
    // Entries to cells: the time of each, and the time at which it ends.
    let mut entries = vec![(lane.begins, lane.entry)];
    entries.extend(lane.steps.iter().map(|step| (step.ends, step.to)));
    let mut stays: Vec<(u32, u32)> = Vec::new();
    for (time, _) in entries.into_iter().filter(|&(_, at)| at == cell) {
        match stays.last_mut() {
            Some(stay) if stay.1 + 1 == time => stay.1 = time,
            _ => stays.push((time, time)),
        }
    }
    let pass = |(from, to): (u32, u32)| {
        let charges = lane.charges.iter().any(|&time| (from..=to).contains(&time));
        let mut when = if to == lane.arrival && lane.stays {
            tr!("from {from} on, arrived", from)
        } else if from == to {
            tr!("at {from}", from)
        } else {
            tr!("from {from} to {to}", from, to)
        };
        if charges {
            when += tr!(", charging");
        }
        let (agent, name) = (lane.agent, lane.name.clone());
        Pass {
            agent,
            name,
            from,
            when,
        }
    };
    stays.into_iter().map(pass).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn facts(x: u32, y: u32) -> CellFacts {
        cell(&sample::solved(), Cell::new(x, y)).unwrap()
    }

    fn passes(x: u32, y: u32) -> Vec<String> {
        let passes = facts(x, y).passes.unwrap();
        let text = |pass: &Pass| format!("{} {}", pass.name, pass.when);
        passes.iter().map(text).collect()
    }

    #[test]
    fn a_charger_and_who_passes() {
        let facts = facts(6, 2);
        assert_eq!((facts.title.as_str(), facts.ground), ("6, 2", "Charger"));
        assert_eq!(passes(6, 2), ["A2 at 3, charging", "A1 at 9, charging"]);
    }

    #[test]
    fn a_start_that_is_a_goal() {
        let roles = facts(0, 0).roles;
        assert_eq!(
            roles,
            [(0, "Start of A1".to_owned()), (1, "Goal of A2".to_owned())]
        );
        assert_eq!(passes(0, 0), ["A1 at 0", "A2 from 18 on, arrived"]);
    }

    #[test]
    fn nobody_passes_an_obstacle() {
        let facts = facts(1, 1);
        assert_eq!((facts.ground, facts.icon), ("Obstacle", Some("obstacle")));
        assert_eq!(facts.passes, Some(vec![]));
        assert_eq!(cell(&sample::solved(), Cell::new(10, 0)), None);
    }

    #[test]
    fn without_a_plan_nothing_is_said_of_passes() {
        let state = State::new(sample::draft());
        assert_eq!(cell(&state, Cell::new(2, 0)).unwrap().passes, None);
    }
}
