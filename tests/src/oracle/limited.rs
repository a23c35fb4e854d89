//! Whether some plan keeps limits: on what one agent costs, or some of them together.
//!
//! A search over joint states with what was spent of each limit, by breadth. A state
//! reached with no less of anything than before is dropped.

use std::collections::{BTreeMap, VecDeque};

use giveway_model::{Cost, Instance};

use super::joint::{Code, Joint};
use super::price::Price;

/// The most that some agents may have of a cost together: of the makespan, when the
/// last of them arrives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AtMost {
    /// The cost.
    pub cost: Cost,
    /// The agents by name; all of them where nothing is said.
    pub agents: Option<Vec<String>>,
    /// The most.
    pub most: u32,
}

impl AtMost {
    fn has(&self, name: &str) -> bool {
        let agents = self.agents.as_ref();
        agents.is_none_or(|agents| agents.iter().any(|agent| agent == name))
    }
}

/// Whether some plan keeps all limits; `None` where that takes more states than `cap`.
pub fn some_plan_keeps(instance: &Instance, limits: &[AtMost], cap: usize) -> Option<bool> {
    let joint = Joint::new(instance);
    let members: Vec<Vec<bool>> = limits
        .iter()
        .map(|limit| joint.agents.iter().map(|a| limit.has(&a.name)).collect())
        .collect();
    let limited = Limited {
        joint: &joint,
        limits,
        members,
    };
    limited.search(cap)
}

/// The least of a cost that each agent needs alone, in the order of the instance;
/// `None` where one cannot do its task.
pub fn least_alone(instance: &Instance, cost: Cost) -> Option<Vec<u32>> {
    let agents = instance.agents().iter();
    let each = agents.map(|agent| {
        let mut scene = instance.to_scene();
        scene.agents.retain(|other| other.name == agent.name);
        let alone = Instance::new(scene).ok()?;
        let most = |most: u32| AtMost {
            cost,
            agents: None,
            most,
        };
        let any = some_plan_keeps(&alone, &[], usize::MAX)?;
        any.then(|| {
            let mut n = 0;
            while some_plan_keeps(&alone, &[most(n)], usize::MAX) == Some(false) {
                n += 1;
            }
            n
        })
    });
    each.collect()
}

struct Limited<'a> {
    joint: &'a Joint,
    limits: &'a [AtMost],
    /// Of each limit, which agents it is about.
    members: Vec<Vec<bool>>,
}

impl Limited<'_> {
    fn search(&self, cap: usize) -> Option<bool> {
        let mut seen: BTreeMap<Code, Vec<Vec<u32>>> = BTreeMap::new();
        let mut waiting: VecDeque<(Code, Vec<u32>)> = VecDeque::new();
        for code in self.joint.first() {
            waiting.push_back((code, vec![0; self.limits.len()]));
        }
        let mut states_seen = 0;
        while let Some((code, spent)) = waiting.pop_front() {
            let states = self.joint.decode(code);
            if !self.may_be_kept(&states, &spent) {
                continue;
            }
            let before = seen.entry(code).or_default();
            let no_more = |other: &Vec<u32>| other.iter().zip(&spent).all(|(a, b)| a <= b);
            if before.iter().any(no_more) {
                continue;
            }
            before.push(spent.clone());
            if self.joint.is_done(&states) {
                return Some(true);
            }
            states_seen += 1;
            if states_seen > cap {
                return None;
            }
            self.joint.each_of_all(&states, |next, steps| {
                let spent = spent.iter().enumerate().map(|(i, spent)| {
                    let own = steps.iter().zip(&self.members[i]);
                    let price = own
                        .filter(|(_, is_member)| **is_member)
                        .fold(Price::default(), |sum, (step, _)| sum.and(step.price));
                    spent + price.adds_to(self.limits[i].cost)
                });
                waiting.push_back((next, spent.collect()));
            });
        }
        Some(false)
    }

    /// Whether no limit is broken, nor will be for sure: each agent takes the steps at
    /// least that it would need alone.
    fn may_be_kept(&self, states: &[usize], spent: &[u32]) -> bool {
        self.limits.iter().enumerate().all(|(i, limit)| {
            let agents = self.joint.agents.iter().zip(states).zip(&self.members[i]);
            let to_go = agents
                .filter(|(_, is_member)| **is_member)
                .map(|((agent, &state), _)| agent.to_go[state]);
            let more = match limit.cost {
                Cost::Makespan => to_go.max().unwrap_or(0),
                Cost::SumOfCosts => to_go.sum(),
                _ => 0,
            };
            spent[i] + more <= limit.most
        })
    }
}
