//! Of all best plans, how close one comes to a given plan.
//!
//! Dijkstra's algorithm once more, over joint states with the time and with who
//! has done something else so far. What is minimised is the objective, then the
//! number of agents that do something else, then the number of entries that
//! differ, arrived agents padded with their goals.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use giveway_model::{Cell, Cost, Instance, Plan};

use super::contrast::Contrast;
use super::joint::{Code, Joint};
use super::law::Place;
use super::leniency::Leniency;
use super::price::Price;

/// Agents that do something else, and entries that differ.
pub type Distance = (u32, u32);

/// A joint state, the time, and who has done something else.
type Moment = (Code, u32, u32);

/// The least distance of a best plan that is as a question asks, within a
/// makespan; `None` where there is none, or there are too many states.
pub fn least_distance(
    instance: &Instance,
    contrast: Contrast,
    within: u32,
    cap: usize,
) -> Option<Distance> {
    let joint = Joint::asked(instance, Some(contrast), &Leniency::default());
    let near = Near {
        joint: &joint,
        costs: instance.objective().costs(),
        plan: contrast.plan,
    };
    let mut best: BTreeMap<Moment, Vec<u32>> = BTreeMap::new();
    let mut waiting = BinaryHeap::new();
    for code in joint.first() {
        let start = (code, 0, 0);
        let cost = vec![0; near.costs.len() + 2];
        best.insert(start, cost.clone());
        waiting.push(Reverse((cost, start)));
    }
    let longest = near.longest();
    while let Some(Reverse((cost, moment))) = waiting.pop() {
        if best.get(&moment).is_some_and(|better| *better < cost) {
            continue;
        }
        if best.len() > cap {
            return None;
        }
        let (code, time, changed) = moment;
        let states = joint.decode(code);
        if joint.is_done(&states) && time >= longest {
            let [.., agents, entries] = cost[..] else {
                return None;
            };
            return Some((agents, entries));
        }
        if !joint.is_done(&states) && time >= within {
            continue;
        }
        near.each(&states, time, |next, price, recharged| {
            let later = joint.decode(next);
            let steps = (states.as_slice(), later.as_slice());
            let (cost, now) = near.after(&cost, price, steps, time + 1, changed | recharged);
            let cost = near.flipped(cost, changed, now);
            let moment = (next, time + 1, now);
            if best.get(&moment).is_none_or(|other| cost < *other) {
                best.insert(moment, cost.clone());
                waiting.push(Reverse((cost, moment)));
            }
        });
    }
    None
}

struct Near<'a> {
    joint: &'a Joint,
    costs: &'a [Cost],
    plan: &'a Plan,
}

impl Near<'_> {
    /// The makespan of the given plan.
    fn longest(&self) -> u32 {
        let paths = self.plan.paths.values();
        paths.map(|path| path.len() as u32 - 1).max().unwrap_or(0)
    }

    /// Every joint step, with the agents of which the charge at this time is not
    /// what it was.
    fn each(&self, states: &[usize], time: u32, mut take: impl FnMut(Code, Price, u32)) {
        self.joint.each_step(states, |next, price, charges| {
            let mut recharged = 0;
            for (i, agent) in self.joint.agents.iter().enumerate() {
                let listed = self.plan.charges.get(&agent.name);
                let before = listed.is_some_and(|times| times.contains(&time));
                if before != (charges >> i & 1 == 1) {
                    recharged |= 1 << i;
                }
            }
            take(next, price, recharged);
        });
    }

    /// The cost after a step, and who has done something else by then.
    fn after(
        &self,
        cost: &[u32],
        price: Price,
        (before, states): (&[usize], &[usize]),
        time: u32,
        changed: u32,
    ) -> (Vec<u32>, u32) {
        let mut cost = cost.to_vec();
        for (value, &kind) in cost.iter_mut().zip(self.costs) {
            *value += price.adds_to(kind);
        }
        let mut changed = changed;
        for (i, agent) in self.joint.agents.iter().enumerate() {
            let path = &self.plan.paths[&agent.name];
            let place = agent.states[states[i]].place;
            let here: Option<Cell> = match place {
                Place::Arrived(cell) | Place::At(cell) => Some(cell),
                // It left from where every plan of it ends.
                Place::Gone => path.last().copied().unwrap_or_default(),
                Place::Between(..) => None,
            };
            let there = path.get(time as usize).or(path.last());
            let there = there.copied().unwrap_or_default();
            // Where both are over, there is no entry to compare.
            let is_over = time as usize >= path.len() && agent.is_done(before[i]);
            if here != there && !is_over {
                changed |= 1 << i;
                if let Some(entries) = cost.last_mut() {
                    *entries += 1;
                }
            }
        }
        (cost, changed)
    }

    /// Counts the agents that do something else for the first time.
    fn flipped(&self, mut cost: Vec<u32>, before: u32, now: u32) -> Vec<u32> {
        let flips = (now & !before).count_ones();
        if let Some(agents) = cost.get_mut(self.costs.len()) {
            *agents += flips;
        }
        cost
    }
}
