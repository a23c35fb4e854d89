//! What is wrong with a scene, at once and on its cell: what validation finds,
//! and what an agent alone can see without a search of plans.

mod reach;
#[cfg(test)]
mod tests;
mod words;

use std::collections::BTreeMap;

use giveway_model::parts::Parts;
use giveway_model::{Agent, AtGoal, Cell, Fault, Grid, Scene};

pub(crate) use reach::{Reach, reach};
use words::{Part, Task, What};

/// How many steps the tables of batteries may take for one scene: beyond, the
/// page would be slow to paint on, and the solver tells as well.
const STEPS: usize = 60_000;

/// Something for which the scene has no plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where it is; `None` where it is nowhere.
    pub cell: Option<Cell>,
    /// The agent, by its index in the scene.
    pub agent: Option<usize>,
    what: What,
}

impl Problem {
    /// What is wrong, as a sentence.
    pub fn sentence(&self) -> String {
        self.what.sentence()
    }
}

/// What is wrong with a scene, by the order of its agents; `faults` are those
/// that validation found: they are told as they are where nothing else is.
pub(crate) fn problems(scene: &Scene, grid: &Grid, faults: &[Fault]) -> Vec<Problem> {
    let mut told = Told(Vec::new());
    let parts = Parts::of(grid);
    let (mut starts, mut goals, mut names) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
    let mut steps = STEPS;
    for (index, agent) in scene.agents.iter().enumerate() {
        let name = &agent.name;
        if let Some(other) = names.insert(name, index) {
            told.say(agent.start, other, What::SameName(name.clone()));
        }
        if let Some(other) = starts.insert(agent.start, name) {
            let both = What::SameStart([other.clone(), name.clone()], agent.start);
            told.say(agent.start, index, both);
        }
        if let Some(goal) = agent.goal
            && let Some(other) = goals.insert(goal, name)
            && scene.rules.at_goal == AtGoal::Stay
        {
            let both = What::SameGoal([other.clone(), name.clone()], goal);
            told.say(goal, index, both);
        }
        if told.grounds(index, agent, grid) && told.ways(index, agent, &parts) {
            let floor = scene.rules.battery_floor;
            told.battery(index, agent, &reach(grid, agent, floor, &mut steps));
        }
    }
    if told.0.is_empty() {
        told.0.extend(faults.iter().map(|fault| Problem {
            cell: None,
            agent: None,
            what: What::Fault(fault.clone()),
        }));
    }
    told.0
}

struct Told(Vec<Problem>);

impl Told {
    fn say(&mut self, cell: Cell, agent: usize, what: What) {
        self.0.push(Problem {
            cell: Some(cell),
            agent: Some(agent),
            what,
        });
    }

    fn grounds(&mut self, index: usize, agent: &Agent, grid: &Grid) -> bool {
        let before = self.0.len();
        for (cell, part) in cells(agent) {
            let is_off_map = grid.ground(cell).is_none();
            if is_off_map || !grid.is_vertex(cell) {
                let task = Task(agent.name.clone(), part, cell);
                self.say(cell, index, What::Ground { task, is_off_map });
            }
        }
        self.0.len() == before
    }

    /// Which cells no way leads to, however long; whether there are none.
    fn ways(&mut self, index: usize, agent: &Agent, parts: &Parts) -> bool {
        let start = parts.number(agent.start);
        let apart: Vec<_> = cells(agent)
            .filter(|&(cell, _)| parts.number(cell) != start)
            .collect();
        let Some(&(first, part)) = apart.first() else {
            return true;
        };
        let task = |part, cell| Task(agent.name.clone(), part, cell);
        // One of them is walled in: it is the one in the smaller part.
        if parts.size(agent.start) <= parts.size(first) {
            let walled = What::WalledIn(agent.start, task(part, first));
            self.say(agent.start, index, walled);
        } else {
            for (cell, part) in apart {
                self.say(cell, index, What::Closed(task(part, cell)));
            }
        }
        false
    }

    fn battery(&mut self, index: usize, agent: &Agent, reach: &Reach) {
        for (cell, part) in cells(agent).skip(1) {
            let task = Task(agent.name.clone(), part, cell);
            if !reach.arrives(cell) {
                self.say(cell, index, What::Battery(task));
            } else if !reach.goes_on(cell) {
                self.say(cell, index, What::BatteryBehind(task));
            }
        }
    }
}

/// Start, goal, waypoints, each with what it is.
fn cells(agent: &Agent) -> impl Iterator<Item = (Cell, Part)> + '_ {
    let waypoints = agent.waypoints.iter().map(|&cell| (cell, Part::Waypoint));
    let goal = agent.goal.map(|goal| (goal, Part::Goal));
    std::iter::once((agent.start, Part::Start))
        .chain(goal)
        .chain(waypoints)
}
