//! Claims that rest on search: all states of some agents together, exhausted.
//!
//! There are finitely many states, so that what no search reaches is reached at
//! no horizon. The rules are written down here once more, as steps from state to
//! state, and shared with nothing else. Rules of the scene's own are watched
//! (`constraints`), as the condition of a claim is (`watch`).

mod constraints;
mod lone;
mod meet;
mod watch;

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Condition, Cost, Instance};

use crate::condition::with_rule;
use crate::{Budget, Claim};
use constraints::{Past, Rules};
use lone::{Lone, State, Step};
use watch::{Memory, Watch};

/// The result of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exhausted {
    /// There is a plan of the kind; what it costs at least, of the cost that
    /// was searched for.
    Plan(u32),
    /// All states are used up: there is none at any horizon.
    NoPlan,
    /// The budget ran out first.
    Stopped,
}

/// Whether some agents of an instance, alone on the map, have a plan with at
/// most these costs.
pub fn exhaust(
    instance: &Instance,
    agents: &[usize],
    most: &BTreeMap<Cost, u32>,
    budget: &Budget<'_>,
) -> Exhausted {
    limited(instance, agents, most, None, budget)
}

/// Whether there is a plan of the kind that a claim excludes, of any makespan.
/// Nothing is searched where no agent of the instance can be of that kind.
pub fn exhaust_kind(instance: &Instance, claim: &Claim, budget: &Budget<'_>) -> Exhausted {
    let all: Vec<usize> = (0..instance.agents().len()).collect();
    let Ok(instance) = with_rule(instance, claim.condition.as_ref()) else {
        return Exhausted::Stopped;
    };
    let instance = instance.as_ref();
    let watch = match &claim.condition {
        // A rule is one of the instance's own here.
        None | Some(Condition::Keeps(_)) => None,
        Some(condition) => match Watch::of(instance, condition) {
            Some(watch) => Some(watch),
            None => return Exhausted::Stopped,
        },
    };
    limited(instance, &all, &claim.most, watch, budget)
}

fn limited(
    instance: &Instance,
    agents: &[usize],
    most: &BTreeMap<Cost, u32>,
    watch: Option<Watch<'_>>,
    budget: &Budget<'_>,
) -> Exhausted {
    let mut limits: Vec<(Cost, u32)> = most.iter().map(|(&cost, &n)| (cost, n)).collect();
    let (aim, limit) = match limits.pop() {
        Some((cost, limit)) => (Some(cost), limit),
        None => (None, u32::MAX),
    };
    Search {
        aim,
        limit,
        limits,
        watch,
        budget: *budget,
    }
    .run(instance, agents)
}

/// The least that one agent alone costs.
///
/// ```
/// use giveway_model::{Cost, format::native};
/// use giveway_proof::{Budget, exhaust::{Exhausted, least}};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["~~~"],
///     "agents": [{ "name": "a", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let arrival = least(&instance, 0, Cost::Makespan, &Budget::default());
/// assert_eq!(arrival, Exhausted::Plan(4));
/// ```
pub fn least(instance: &Instance, agent: usize, cost: Cost, budget: &Budget<'_>) -> Exhausted {
    Search {
        aim: Some(cost),
        limit: u32::MAX,
        limits: Vec::new(),
        watch: None,
        budget: *budget,
    }
    .run(instance, &[agent])
}

/// Whether the agents, each alone, already cost at least so much: for the
/// makespan the one that takes longest, else all together. `None` where the
/// budget ran out. An agent that cannot do its task costs more than anything.
pub fn alone_at_least(
    instance: &Instance,
    cost: Cost,
    bound: u32,
    budget: &Budget<'_>,
) -> Option<bool> {
    let mut total: u32 = 0;
    for agent in 0..instance.agents().len() {
        match least(instance, agent, cost, budget) {
            Exhausted::Plan(n) if cost == Cost::Makespan => total = n.max(total),
            Exhausted::Plan(n) => total = total.saturating_add(n),
            Exhausted::NoPlan => return Some(true),
            Exhausted::Stopped => return None,
        }
    }
    Some(total >= bound)
}

/// How much of the costs something takes, in the order of [`Cost::ALL`].
type Spent = [u32; Cost::ALL.len()];

/// A search by growing cost.
struct Search<'a> {
    /// The cost by which it grows; none: any plan will do.
    aim: Option<Cost>,
    /// How far.
    limit: u32,
    /// The other limits; what is spent of them is part of a state.
    limits: Vec<(Cost, u32)>,
    /// The condition, where plans of a kind are searched for.
    watch: Option<Watch<'a>>,
    budget: Budget<'a>,
}

/// A state of each agent, and what was spent of the other limited costs.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Joint {
    states: Vec<State>,
    spent: Vec<u32>,
    /// The memory of the condition.
    memory: Memory,
    /// The past that the rules of the scene's own ask for.
    past: Past,
}

impl Search<'_> {
    fn run(&self, instance: &Instance, agents: &[usize]) -> Exhausted {
        if !(self.budget.go_on)() {
            return Exhausted::Stopped;
        }
        let limited = |cost| self.aim == Some(cost) || self.limits.iter().any(|l| l.0 == cost);
        // A condition may be about charges.
        let thrifty = limited(Cost::Charges) || self.watch.is_some();
        let lones: Vec<Lone<'_>> = agents
            .iter()
            .filter_map(|&agent| Lone::new(instance, agent, thrifty))
            .collect();
        if lones.len() < agents.len() {
            return Exhausted::Stopped; // more waypoints than a state can hold
        }
        let rules = Rules::of(instance, agents);
        // With many rules a state is large, and its steps take long.
        let most = self.budget.states / (1 + rules.recorded() / 16);
        let pause = (256 / (1 + rules.count() / 16)).max(1);
        let mut open: BTreeMap<u32, Vec<Joint>> = BTreeMap::new();
        let begins: Vec<Vec<Step>> = lones.iter().map(Lone::begin).collect();
        for steps in meet::joint_steps(&begins) {
            let memory = match &self.watch {
                None => Some(Memory::default()),
                Some(watch) => watch.begin(&lones, &steps),
            };
            let (Some(memory), Some(past)) = (memory, rules.begin(&steps)) else {
                continue;
            };
            let begin = Joint {
                states: steps.iter().map(|step| step.to).collect(),
                spent: vec![0; self.limits.len()],
                memory,
                past,
            };
            open.entry(0).or_default().push(begin);
        }
        let mut closed = BTreeSet::new();
        while let Some(mut entry) = open.first_entry() {
            let spent = *entry.key();
            let Some(joint) = entry.get_mut().pop() else {
                entry.remove();
                continue;
            };
            let met = |watch: &Watch<'_>| watch.is_met(joint.memory);
            if joint.states.iter().all(|state| state.has_arrived())
                && self.watch.as_ref().is_none_or(met)
                && rules.are_kept(&joint.past)
            {
                return Exhausted::Plan(spent);
            }
            if !closed.insert(joint.clone()) {
                continue;
            }
            if closed.len() > most || (closed.len().is_multiple_of(pause) && !(self.budget.go_on)())
            {
                return Exhausted::Stopped;
            }
            for (next, more) in self.next(&lones, &rules, &joint) {
                let spent = spent.saturating_add(more);
                if spent <= self.limit {
                    open.entry(spent).or_default().push(next);
                }
            }
        }
        Exhausted::NoPlan
    }

    /// All that can come next within the limits, and what it takes of the cost
    /// that is aimed at.
    fn next(&self, lones: &[Lone<'_>], rules: &Rules<'_>, joint: &Joint) -> Vec<(Joint, u32)> {
        let steps = lones.iter().zip(&joint.states);
        let steps: Vec<Vec<Step>> = steps.map(|(lone, state)| lone.steps(*state)).collect();
        let mut next = Vec::new();
        for chosen in meet::joint_steps(&steps) {
            let memory = match &self.watch {
                None => Some(Memory::default()),
                Some(watch) => watch.step(lones, &joint.states, &chosen, joint.memory),
            };
            let stepped = rules.step(&joint.states, &chosen, &joint.past);
            let (Some(memory), Some((past, penalty))) = (memory, stepped) else {
                continue;
            };
            let mut taken = Spent::default();
            for (sum, cost) in taken.iter_mut().zip(Cost::ALL) {
                let each = chosen.iter().map(|step| step.spent[cost as usize]);
                *sum = match cost {
                    Cost::Makespan => each.max().unwrap_or(0),
                    Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits => each.sum(),
                    Cost::Penalty => penalty,
                };
            }
            let spent = self.limits.iter().zip(&joint.spent);
            let spent: Vec<u32> = spent
                .map(|((cost, _), before)| before.saturating_add(taken[*cost as usize]))
                .collect();
            let within = spent
                .iter()
                .zip(&self.limits)
                .all(|(n, (_, most))| n <= most);
            if within {
                let states = chosen.iter().map(|step| step.to).collect();
                let more = self.aim.map_or(0, |cost| taken[cost as usize]);
                next.push((
                    Joint {
                        states,
                        spent,
                        memory,
                        past,
                    },
                    more,
                ));
            }
        }
        next
    }
}
