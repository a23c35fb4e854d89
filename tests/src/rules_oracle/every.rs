//! All best plans of a scene with rules, by the same search over joint states.
//!
//! Costs are sums over steps, and the time is a part of a joint state here, so that each
//! part of a best plan is a best way to the joint state at its end. All ways of such parts are
//! kept; those that end in a best plan are all best plans, each once.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Cell;

use super::agent::{Mind, Where as Here};
use super::scene::{RuleScene, Spot};
use super::search::{Joint, Search};
use crate::oracle::{Course, Where};

/// All best plans.
pub struct AllBest {
    search: Vec<Vec<Mind>>,
    /// By joint state: the best ways into it, each with who charges.
    into: BTreeMap<Joint, BTreeSet<(Joint, Vec<bool>)>>,
    ends: Vec<Joint>,
    goals: Vec<Spot>,
    vanish: bool,
}

/// All plans of these costs, in the order of the objective, of a makespan of at most `latest`;
/// `None` where there are more joint states than are looked at.
pub fn all_best(scene: &RuleScene, best: &[i64], latest: i64, most: usize) -> Option<AllBest> {
    let mut search = Search::begun(scene);
    let mut into: BTreeMap<Joint, BTreeSet<(Joint, Vec<bool>)>> = BTreeMap::new();
    let mut layer: BTreeMap<Joint, Vec<i64>> = search.best.clone();
    let mut ends = Vec::new();
    let mut states = 0;
    for time in 0..=latest {
        let mut next: BTreeMap<Joint, Vec<i64>> = BTreeMap::new();
        for (joint, costs) in &layer {
            states += 1;
            if states > most {
                return None;
            }
            let minds = search.minds(&joint.0);
            if costs == best && scene.is_over(&minds, time) {
                ends.push(joint.clone());
            }
            if time == latest {
                continue;
            }
            for (to, after, charges) in search.steps(joint, &minds, (costs, time), |time| time) {
                if after.as_slice() > best {
                    continue;
                }
                let known = next.get(&to);
                if known.is_some_and(|known| *known < after) {
                    continue;
                }
                let ways = into.entry(to.clone()).or_default();
                if known != Some(&after) {
                    ways.clear();
                    next.insert(to, after);
                }
                ways.insert((joint.clone(), charges));
            }
        }
        layer = next;
    }
    let minds = search.minds.iter().map(|minds| minds.all.clone());
    Some(AllBest {
        search: minds.collect(),
        into,
        ends,
        goals: scene.agents.iter().map(|agent| agent.goal).collect(),
        vanish: scene.vanish,
    })
}

impl AllBest {
    /// The plans, each of one length: where each agent is, and who charges; `None` where there
    /// are more than a number.
    pub fn courses(&self, most: usize) -> Option<Vec<Course>> {
        let mut found = Vec::new();
        for end in &self.ends {
            let charges = vec![false; self.goals.len()];
            let mut behind = vec![(self.places(end), charges)];
            if !self.follow(end, &mut behind, (&mut found, most)) {
                return None;
            }
        }
        let longest = found.iter().map(Vec::len).max().unwrap_or(0);
        // Where they vanish, all are gone one step later.
        for course in &mut found {
            let Some((mut places, charges)) = course.last().cloned() else {
                continue;
            };
            if self.vanish {
                places = vec![Where::Gone; places.len()];
            }
            let charges = vec![false; charges.len()];
            course.resize(longest + 1, (places, charges));
        }
        Some(found)
    }

    fn follow(
        &self,
        joint: &Joint,
        behind: &mut Course,
        (found, most): (&mut Vec<Course>, usize),
    ) -> bool {
        if joint.2 == 0 {
            found.push(behind.iter().rev().cloned().collect());
            return found.len() <= most;
        }
        for (from, charges) in self.into.get(joint).into_iter().flatten() {
            behind.push((self.places(from), charges.clone()));
            let is_few = self.follow(from, behind, (found, most));
            behind.pop();
            if !is_few {
                return false;
            }
        }
        true
    }

    fn places(&self, joint: &Joint) -> Vec<Where> {
        let cell = |(x, y): Spot| Cell::new(x.try_into().unwrap(), y.try_into().unwrap());
        let each = joint.0.iter().zip(&self.search).zip(&self.goals);
        let places = each.map(
            |((&number, minds), &goal)| match minds[number as usize].place {
                Here::At(spot) => Where::At(cell(spot)),
                Here::On(from, to) => Where::Between(cell(from), cell(to)),
                Here::Home => Where::At(cell(goal)),
                Here::Gone => Where::Gone,
            },
        );
        places.collect()
    }
}
