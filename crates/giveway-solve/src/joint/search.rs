//! A* (Hart, Nilsson and Raphael 1968) over joint states, each agent's state being its place,
//! its waypoints and its battery. Costs are those of an objective in their order: each is a sum
//! over steps, so that comparing them in order loses no best plan. The estimate is what agents
//! still pay alone, from exact tables, as in Standley (2010); it never overestimates a cost, so
//! it does not overestimate the costs in their order, either.
//!
//! A joint state is a row of numbers, one for each agent's own state, what rules between agents
//! have to remember ([`memory`](super::memory)), and what is used of costs that are limited.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::rc::Rc;

use giveway_model::Cost;

use super::{
    Ended, Joint,
    agent::Single,
    memory::Memory,
    states::{AgentStep, StateId, States, Table, to_go},
    tally::Tally,
};
use crate::{
    budget::{Budget, MemoryUse, Stop},
    single::Task,
};

/// A joint state that was reached, in the order in which they were.
type NodeId = u32;

/// The memory of a node's number, and of its key beside its values, about.
const BYTES_OF_ENTRY: usize = 48;

/// A joint state that was reached.
struct Node {
    /// Each agent's state, then what is remembered, then what is used of limited costs.
    key: Rc<[u32]>,
    /// The least paid for it so far.
    paid: Tally,
    before: Option<NodeId>,
}

/// An entry of the open list: the least costs of a plan through the node, the steps that agents need from
/// there, the node, and its costs so far at that time.
type Open = Reverse<(Tally, u32, NodeId, Tally)>;

/// A search that is under way.
struct Search<'a> {
    joint: &'a Joint<'a>,
    memory: Memory,
    /// Whether rules between agents have something to look at.
    remembers: bool,
    states: Vec<States<'a>>,
    nodes: Vec<Node>,
    numbers: Table<Rc<[u32]>>,
    open: BinaryHeap<Open>,
    budget: &'a Budget<'a>,
    held: MemoryUse,
}

impl Joint<'_> {
    /// Looks at up to `most` joint steps, and counts them.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn run(
        &self,
        most: usize,
        steps: &mut usize,
        budget: &Budget,
    ) -> Result<Ended, Stop> {
        let Some(memory) = Memory::new(self) else {
            return Ok(Ended::TooMany);
        };
        let states = (0..self.agents.len()).map(|i| States::new(self, i, budget));
        let mut search = Search {
            joint: self,
            memory,
            remembers: self.problem.has_rules_between(),
            states: states.collect::<Result<_, Stop>>()?,
            nodes: Vec::new(),
            numbers: Table::default(),
            open: BinaryHeap::new(),
            budget,
            held: MemoryUse::default(),
        };
        for (start, paid) in self.starts() {
            if !search.memory.may_begin(self, &start) {
                continue;
            }
            let remembered = search.memory.first(self, &start);
            let numbers = search.states.iter_mut().zip(start);
            let numbers: Option<Vec<StateId>> = numbers
                .map(|(states, start)| states.number(start))
                .collect();
            if let Some(numbers) = numbers {
                search.reach((&numbers, &remembered), paid, None);
            }
        }
        while let Some(Reverse((_, _, id, paid))) = search.open.pop() {
            budget.tick()?;
            if search.nodes[id as usize].paid != paid {
                continue; // reached for less since
            }
            if search.has_arrived(id) {
                return Ok(Ended::Best(self.counted.vector(paid), search.way(id)));
            }
            let looked_at = search.expand(id, paid);
            *steps += looked_at;
            budget.spend(looked_at as u64)?;
            if *steps > most {
                return Ok(Ended::TooMany);
            }
        }
        Ok(Ended::None)
    }

    pub(super) fn task(&self, i: usize) -> &Task {
        &self.problem.tasks[self.agents[i]]
    }

    /// Calls `take` with each way to go on at once without a collision.
    fn combine(
        &self,
        steps: &[Rc<[AgentStep]>],
        chosen: &mut Vec<AgentStep>,
        take: &mut dyn FnMut(&[AgentStep]),
    ) {
        let i = chosen.len();
        let Some(choices) = steps.get(i) else {
            return take(chosen);
        };
        for &step in choices.iter() {
            let is_free = chosen.iter().enumerate().all(|(j, other)| {
                let meet = step.stands.is_some() && step.stands == other.stands;
                let swap = step.arc.is_some() && step.arc == other.arc.map(|arc| arc ^ 1);
                !(meet || swap) || !self.problem.collide(self.agents[i], self.agents[j])
            });
            if is_free {
                chosen.push(step);
                self.combine(steps, chosen, take);
                chosen.pop();
            }
        }
    }
}

impl Search<'_> {
    /// The numbers of the agents' own states in a joint state.
    fn numbers(&self, id: NodeId) -> &[StateId] {
        &self.nodes[id as usize].key[..self.states.len()]
    }

    /// The agents' own states in a joint state.
    fn singles(&self, numbers: &[StateId]) -> Vec<Single> {
        let numbers = self.states.iter().zip(numbers);
        numbers.map(|(states, &id)| states.state(id)).collect()
    }

    /// What is remembered in a joint state.
    fn remembered(&self, id: NodeId) -> &[u32] {
        let limited = self.joint.counted.limits();
        let key = &self.nodes[id as usize].key;
        &key[self.states.len()..key.len() - limited]
    }

    fn has_arrived(&self, id: NodeId) -> bool {
        let mut singles = self.states.iter().zip(self.numbers(id));
        let have = singles.all(|(states, &id)| states.state(id).has_arrived());
        let may_end = || {
            let singles = self.singles(self.numbers(id));
            self.memory
                .may_end(self.joint, self.remembered(id), &singles)
        };
        have && (!self.remembers || may_end())
    }

    /// Reaches all joint states that follow one; the number of steps that lead there.
    fn expand(&mut self, id: NodeId, paid: Tally) -> usize {
        let numbers: Vec<StateId> = self.numbers(id).to_vec();
        let own = self.states.iter_mut().zip(&numbers);
        let steps: Vec<Rc<[AgentStep]>> = own.map(|(states, &id)| states.steps(id)).collect();
        let joint = self.joint;
        let before = self.remembers.then(|| self.singles(&numbers));
        let remembered = self.remembered(id).to_vec();
        // An agent has not arrived yet.
        let time = joint
            .counted
            .tally(|cost| u32::from(cost == Cost::Makespan));
        let (mut next, mut looked_at) = (Vec::new(), 0);
        joint.combine(&steps, &mut Vec::new(), &mut |chosen| {
            looked_at += 1;
            next.clear();
            next.extend(chosen.iter().map(|step| step.to));
            let mut next_remembered = Vec::new();
            if let Some(before) = &before {
                let after = self.singles(&next);
                let both = (before.as_slice(), after.as_slice());
                if !self.memory.may_follow(joint, &remembered, both) {
                    return;
                }
                next_remembered = self.memory.next(joint, &remembered, both);
            }
            let paid = chosen
                .iter()
                .fold(paid.and(time), |paid, step| paid.and(step.cost));
            self.reach((&next, &next_remembered), paid, Some(id));
        });
        looked_at
    }

    /// Notes that a joint state is reached, where it was not for as little.
    fn reach(
        &mut self,
        (numbers, remembered): (&[StateId], &[u32]),
        paid: Tally,
        before: Option<NodeId>,
    ) {
        let counted = &self.joint.counted;
        let least = paid.and(to_go(counted, &self.states, numbers));
        if !counted.keeps_limits(least) {
            return;
        }
        let key: Rc<[u32]> = numbers
            .iter()
            .chain(remembered)
            .chain(counted.limited(&paid))
            .copied()
            .collect();
        let id = if let Some(&id) = self.numbers.get(&key) {
            let node = &mut self.nodes[id as usize];
            if paid >= node.paid {
                return;
            }
            (node.paid, node.before) = (paid, before);
            id
        } else {
            let bytes = size_of::<Node>() + size_of_val(&*key) + BYTES_OF_ENTRY;
            self.budget.hold_more(&mut self.held, bytes);
            let id = self.nodes.len() as NodeId;
            self.numbers.insert(Rc::clone(&key), id);
            self.nodes.push(Node { key, paid, before });
            id
        };
        let own = self.states.iter().zip(numbers);
        let steps_to_go = own.map(|(states, &id)| states.steps_to_go(id)).sum();
        self.budget.hold_more(&mut self.held, size_of::<Open>());
        self.open.push(Reverse((least, steps_to_go, id, paid)));
    }

    /// The joint states up to a last one, from the first on.
    fn way(&self, last: NodeId) -> Vec<Vec<Single>> {
        let mut way = Vec::new();
        let mut next = Some(last);
        while let Some(id) = next {
            way.push(self.singles(self.numbers(id)));
            next = self.nodes[id as usize].before;
        }
        way.reverse();
        way
    }
}
