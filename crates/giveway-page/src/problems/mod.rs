//! What is wrong with a scene, at once and on its cell: what validation finds,
//! and what an agent alone can see without a search of plans.

mod parts;
mod reach;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use giveway_model::{Agent, AtGoal, Cell, Fault, Grid, Scene, tr};

use crate::words::at;
pub(crate) use parts::Parts;
use reach::{Reach, reach};

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
    /// What is wrong, as a sentence.
    pub sentence: String,
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
            told.say(
                agent.start,
                other,
                tr!("Two robots are called {name}.", name),
            );
        }
        if let Some(other) = starts.insert(agent.start, name) {
            let both = tr!(
                "{other} and {name} both start at {cell}.",
                other,
                name,
                cell = at(agent.start)
            );
            told.say(agent.start, index, both);
        }
        if let Some(other) = goals.insert(agent.goal, name)
            && scene.rules.at_goal == AtGoal::Stay
        {
            let goal = at(agent.goal);
            let both = tr!(
                "{other} and {name} both end at {goal}, where only one can stay.",
                other,
                name,
                goal
            );
            told.say(agent.goal, index, both);
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
            sentence: format!("{fault}."),
        }));
    }
    told.0
}

struct Told(Vec<Problem>);

impl Told {
    fn say(&mut self, cell: Cell, agent: usize, sentence: String) {
        self.0.push(Problem {
            cell: Some(cell),
            agent: Some(agent),
            sentence,
        });
    }

    /// Whether all cells of an agent can be stood on.
    fn grounds(&mut self, index: usize, agent: &Agent, grid: &Grid) -> bool {
        let before = self.0.len();
        for (cell, what) in cells(agent) {
            let is = if grid.ground(cell).is_none() {
                tr!("a cell" => "off the map")
            } else if grid.is_vertex(cell) {
                continue;
            } else {
                tr!("a cell" => "on an obstacle")
            };
            let sentence = tr!(
                "The {what} of {agent} is {is}, at {cell}.",
                what,
                agent = agent.name,
                is,
                cell = at(cell)
            );
            self.say(cell, index, sentence);
        }
        self.0.len() == before
    }

    /// Whether there is a way from the start to all cells of an agent.
    fn ways(&mut self, index: usize, agent: &Agent, parts: &Parts) -> bool {
        let name = &agent.name;
        let start = parts.number(agent.start);
        let apart: Vec<_> = cells(agent)
            .filter(|&(cell, _)| parts.number(cell) != start)
            .collect();
        let Some(&(first, what)) = apart.first() else {
            return true;
        };
        // The smaller part is the one that was closed off.
        if parts.size(agent.start) <= parts.size(first) {
            let (here, there) = (at(agent.start), at(first));
            let sentence = tr!(
                "{name} is walled in at {here}: no way leads to its {what} {there}.",
                name,
                here,
                what,
                there
            );
            self.say(agent.start, index, sentence);
        } else {
            for (cell, what) in apart {
                let sentence = tr!(
                    "{name} cannot reach its {what} {cell}: every way is closed.",
                    name,
                    what,
                    cell = at(cell)
                );
                self.say(cell, index, sentence);
            }
        }
        false
    }

    fn battery(&mut self, index: usize, agent: &Agent, reach: &Reach) {
        let name = &agent.name;
        for (cell, what) in cells(agent).skip(1) {
            let place = at(cell);
            let sentence = if !reach.arrives(cell) {
                tr!(
                    "The battery of {name} does not last to its {what} {place}.",
                    name,
                    what,
                    place
                )
            } else if !reach.goes_on(cell) {
                tr!(
                    "The battery of {name} lasts to its {what} {place}, but not on to its goal.",
                    name,
                    what,
                    place
                )
            } else {
                continue;
            };
            self.say(cell, index, sentence);
        }
    }
}

/// Start, goal, waypoints, each with its name.
fn cells(agent: &Agent) -> impl Iterator<Item = (Cell, &'static str)> + '_ {
    let waypoint = tr!("of a robot" => "waypoint");
    let waypoints = agent.waypoints.iter().map(move |&cell| (cell, waypoint));
    let start = (agent.start, tr!("of a robot" => "start"));
    let goal = (agent.goal, tr!("of a robot" => "goal"));
    [start, goal].into_iter().chain(waypoints)
}
