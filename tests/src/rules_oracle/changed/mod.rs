//! A plan that goes on under rules when the world changes: the states of its agents at the
//! time of the change, read off the plan, and the best way on from there.
//!
//! Times stay those of the whole plan. An agent that is gone is a state, too: a gap looks at
//! where it was.

mod edited;
mod follow;
mod past;

use giveway_model::Plan;
use serde_json::Value;

use super::agent::{Mind, Where};
use super::scene::{RuleScene, Spot};
use super::search::{Answer, Start, best_from};
use edited::{Edited, edited};

/// A plan and the changes of one time.
pub struct ChangedRules {
    at: i64,
    before: RuleScene,
    after: RuleScene,
    /// The numbers of the rules that are new, among those after the change.
    is_new: Vec<bool>,
    agents: Vec<Running>,
    been: Vec<bool>,
    /// What each cost of the objective has of the past, however the plan goes on.
    past: Vec<i64>,
    latest: i64,
}

/// An agent at the time of the change.
struct Running {
    name: String,
    is_old: bool,
    /// Its states, each with what it pays for them.
    states: Vec<(Mind, Vec<i64>)>,
    /// The rest of its old path, waits taken out.
    rest: Vec<Spot>,
}

/// The time of the last entry of a path.
fn ends_at(path: &[Option<Spot>]) -> i64 {
    i64::try_from(path.len()).unwrap() - 1
}

/// Where a path has an agent at a time; `None` in transit, and once it is gone.
fn on(path: &[Option<Spot>], time: i64, stays: bool) -> Option<Spot> {
    let time = usize::try_from(time).ok()?;
    match path.get(time) {
        Some(entry) => *entry,
        None if stays => path.last().copied().flatten(),
        None => None,
    }
}

impl ChangedRules {
    /// The world of a plan at a time: the scene as it was, and the changes as JSON.
    ///
    /// # Panics
    /// When the scene is none, or a change is of a kind that is not known here.
    pub fn new(scene: &Value, plan: &Plan, at: u32, changes: &[Value]) -> Self {
        let old = scene["constraints"].as_array().unwrap().len();
        let Edited {
            json,
            mut removed,
            gone,
            added,
            delays,
        } = edited(scene, changes);
        let names: Vec<String> = {
            let agents = json["agents"].as_array().unwrap().iter();
            agents
                .map(|a| a["name"].as_str().unwrap().to_owned())
                .collect()
        };
        // A precedence goes with either of its agents.
        let rules = json["constraints"].as_array().unwrap().clone();
        for (number, rule) in rules.iter().enumerate() {
            let ends = [&rule["first"]["agent"], &rule["second"]["agent"]];
            if ends
                .iter()
                .any(|end| gone.iter().any(|name| **end == **name))
            {
                removed.push(number);
            }
        }
        let mut after = RuleScene::read(&json.to_string(), &removed);
        let numbers = (0..rules.len()).filter(|number| !removed.contains(number));
        let is_new: Vec<bool> = numbers.map(|number| number >= old).collect();
        // In the world before, agents that join are not there.
        let before = RuleScene::read(&scene.to_string(), &[]);
        let at = i64::from(at);
        for (rule, is_new) in after.rules.iter_mut().zip(&is_new) {
            rule.agents.retain(|&agent| {
                let arrival = i64::try_from(plan.path(&names[agent]).len()).unwrap() - 1;
                let has_left = gone.contains(&names[agent])
                    || before.vanish && !added.contains(&names[agent]) && arrival < at;
                !(has_left && *is_new)
            });
        }
        let mut changed = Self {
            at,
            before,
            is_new,
            agents: Vec::new(),
            been: Vec::new(),
            past: vec![0; after.objective.len()],
            latest: 0,
            after,
        };
        let mut paths: Vec<Vec<Option<Spot>>> = Vec::new();
        for (number, name) in names.iter().enumerate() {
            let path = plan.path(name).iter();
            let path = path.map(|entry| entry.map(|it| (i64::from(it.x), i64::from(it.y))));
            let path: Vec<Option<Spot>> = path.collect();
            let held = delays.iter().filter(|(who, _)| who == name);
            let held = held.map(|&(_, steps)| steps).max().unwrap_or(0);
            let running = if added.contains(name) {
                changed.join(number, name)
            } else {
                let charges: Vec<i64> = plan
                    .charges(name)
                    .iter()
                    .map(|&time| i64::from(time))
                    .collect();
                let is_removed = gone.contains(name);
                changed.go_on(number, name, (&path, &charges), (held, is_removed))
            };
            changed.agents.push(running);
            paths.push(path);
        }
        let stays = !changed.before.vanish;
        changed.been = changed
            .after
            .orders()
            .map(|((first, cell), _)| {
                let path = &paths[first];
                !path.is_empty() && (0..at).any(|time| on(path, time, stays) == Some(cell))
            })
            .collect();
        changed
    }

    /// The names of the agents that were there before.
    pub fn old(&self) -> Vec<&str> {
        let old = self.agents.iter().filter(|agent| agent.is_old);
        old.map(|agent| agent.name.as_str()).collect()
    }

    /// The best way to go on, where the agents of these names are held to the rest of their
    /// paths.
    pub fn best(&mut self, held: &[&str], most: usize) -> Answer {
        for (agent, running) in self.after.agents.iter_mut().zip(&self.agents) {
            let is_held = held.contains(&running.name.as_str());
            agent.path = is_held.then(|| running.rest.clone());
        }
        let nothing = vec![0; self.past.len()];
        let mut starts = vec![(Vec::new(), nothing)];
        for (number, running) in self.agents.iter().enumerate() {
            let is_held = held.contains(&running.name.as_str());
            let states = running.states.iter().filter(|(mind, _)| {
                // One that is held to a path that leads on goes on.
                !is_held || running.rest.len() < 2 || mind.place != Where::Home
            });
            let states: Vec<&(Mind, Vec<i64>)> = states.collect();
            let ends_here = is_held && {
                let path = running.rest.last();
                path != Some(&self.after.agents[number].goal)
            };
            let longer = |(head, paid): &Start| -> Vec<Start> {
                let with = |(mind, costs): &&(Mind, Vec<i64>)| {
                    let costs = paid.iter().zip(costs).map(|(a, b)| a + b).collect();
                    ([head.clone(), vec![mind.clone()]].concat(), costs)
                };
                if ends_here {
                    return Vec::new();
                }
                states.iter().map(with).collect()
            };
            starts = starts.iter().flat_map(longer).collect();
        }
        let been = self.been.clone();
        match best_from(&self.after, (self.at, starts, &been), None, most) {
            Answer::Best(mut costs) => {
                let objective = self.after.objective.iter();
                for ((cost, past), name) in costs.iter_mut().zip(&self.past).zip(objective) {
                    *cost += if name == "makespan" {
                        if *cost == 0 { self.latest } else { self.at }
                    } else {
                        *past
                    };
                }
                Answer::Best(costs)
            }
            answer => answer,
        }
    }

    /// The costs in their order.
    pub fn objective(&self) -> &[String] {
        &self.after.objective
    }
}
