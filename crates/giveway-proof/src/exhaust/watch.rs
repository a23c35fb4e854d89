//! A condition on a plan, watched step by step: what has to be remembered of the
//! way so far, and when it can be met no more.

use giveway_model::condition::{Act, Times};
use giveway_model::{Cell, Condition, Cost, Instance};

use super::lone::{Lone, State, Step};
use crate::condition::fits;

/// The part of a condition that has happened so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Memory {
    /// The time, up to the last one that matters and one more.
    time: u32,
    /// Steps, or waits on end, counted so far.
    count: u32,
    /// The required act has happened.
    done: bool,
    /// The agent that has to come later has been there.
    late: bool,
}

/// Watches a condition. All agents of the instance are searched, in its order.
pub(super) struct Watch<'a> {
    condition: &'a Condition,
    /// The agent of the condition; `None` where it is about any agent.
    agent: Option<usize>,
    /// The agent that has to come later.
    other: Option<usize>,
    /// The last time that matters; `None` where times do not.
    last: Option<u32>,
    /// The time at which the agent must not be at a cell where it may rest.
    not_resting: Option<u32>,
}

impl<'a> Watch<'a> {
    /// `None` where the condition is about no agent, or nothing that agents do.
    pub(super) fn of(instance: &Instance, condition: &'a Condition) -> Option<Self> {
        if !fits(condition, instance) {
            return None;
        }
        let number = |name: &str| instance.agents().iter().position(|a| a.name == name);
        let other = match condition {
            Condition::Before { second, .. } => number(&second.agent),
            // A limit on the costs of all is one of the claim.
            Condition::Below { agent: None, .. } | Condition::Keeps(_) => return None,
            Condition::Never { .. }
            | Condition::Visit { .. }
            | Condition::Move { .. }
            | Condition::Charge { .. }
            | Condition::Below { agent: Some(_), .. } => None,
        };
        let agent = condition.agent().and_then(number);
        let last = match condition {
            Condition::Never { times, .. } | Condition::Move { times, .. } => {
                times.to.or(times.from)
            }
            Condition::Visit { .. }
            | Condition::Charge { .. }
            | Condition::Before { .. }
            | Condition::Below { .. }
            | Condition::Keeps(_) => None,
        };
        let not_resting = match condition {
            Condition::Never {
                act: Act::Visit(at),
                ..
            } => {
                let agent = agent.and_then(|index| instance.agents().get(index));
                let may_rest = agent.is_some_and(|agent| {
                    instance.keeps(agent) && agent.goal.is_none_or(|goal| goal == *at)
                });
                last.filter(|_| may_rest)
            }
            Condition::Never {
                act: Act::Move(..) | Act::SlowMove(_) | Act::Wait { .. } | Act::Charge(_),
                ..
            }
            | Condition::Visit { .. }
            | Condition::Move { .. }
            | Condition::Charge { .. }
            | Condition::Before { .. }
            | Condition::Below { .. }
            | Condition::Keeps(_) => None,
        };
        Some(Self {
            condition,
            agent,
            other,
            last,
            not_resting,
        })
    }

    /// The memory at time 0; `None` where the condition cannot be met any more.
    pub(super) fn begin(&self, lones: &[Lone<'_>], steps: &[Step]) -> Option<Memory> {
        self.come(lones, steps, Memory::default())
    }

    /// The memory a step later; `None` where the condition cannot be met any more.
    pub(super) fn step(
        &self,
        lones: &[Lone<'_>],
        before: &[State],
        steps: &[Step],
        memory: Memory,
    ) -> Option<Memory> {
        let mut memory = memory;
        if let Some((from, step)) = self.agent.and_then(|i| before.get(i).zip(steps.get(i))) {
            // To arrive where it waited is to have arrived before.
            let waits = step.crosses.is_none() && !from.has_arrived();
            if waits && step.to.has_arrived() {
                return None;
            }
            memory = self.leave(*from, step, memory)?;
        }
        memory.time = self.last.map_or(0, |last| {
            memory.time.saturating_add(1).min(last.saturating_add(1))
        });
        self.come(lones, steps, memory)
    }

    /// Whether the condition is met once all agents have arrived.
    pub(super) fn is_met(&self, memory: Memory) -> bool {
        match self.condition {
            Condition::Visit { .. }
            | Condition::Move { .. }
            | Condition::Charge { .. }
            | Condition::Before { .. } => memory.done,
            Condition::Never { .. } | Condition::Below { .. } | Condition::Keeps(_) => {
                self.not_resting.is_none_or(|time| memory.time > time)
            }
        }
    }

    /// The memory after an agent's step from one time to the next.
    fn leave(&self, from: State, step: &Step, memory: Memory) -> Option<Memory> {
        let mut memory = memory;
        let takes = |cost: Cost| step.spent[cost as usize];
        let here = Lone::cell(from);
        let now = |times: &Times| times.contains(memory.time);
        let there = |at: &Option<Cell>| at.is_none_or(|at| here == Some(at));
        let begins = |u: Cell, v: Cell| takes(Cost::Moves) > 0 && step.crosses == Some((u, v));
        let excluded = match self.condition {
            Condition::Below { cost, limit, .. } => {
                memory.count = memory.count.saturating_add(takes(*cost));
                memory.count >= *limit
            }
            Condition::Charge { cell, .. } => {
                memory.done |= takes(Cost::Charges) > 0 && here == Some(*cell);
                false
            }
            Condition::Move {
                from, to, times, ..
            } => {
                let happens = begins(*from, *to) && now(times);
                memory.done |= happens;
                false
            }
            Condition::Never { act, times, .. } => match act {
                Act::Wait { cell, steps } => {
                    let then = times.first() <= memory.time && memory.time < times.last();
                    let waits = takes(Cost::Waits) > 0 && there(cell) && then;
                    // As many as are too many are enough to know.
                    memory.count = if waits {
                        memory.count.saturating_add(1)
                    } else {
                        0
                    };
                    memory.count >= (*steps).max(1)
                }
                Act::Charge(cell) => takes(Cost::Charges) > 0 && there(cell) && now(times),
                Act::Move(from, to) => begins(*from, *to) && now(times),
                Act::SlowMove(edge) => {
                    let slow = Lone::cell(step.to).is_none() && !step.to.has_arrived();
                    let asked = edge.is_none_or(|(u, v)| begins(u, v) || begins(v, u));
                    slow && asked && now(times)
                }
                Act::Visit(_) => false,
            },
            Condition::Visit { .. } | Condition::Before { .. } | Condition::Keeps(_) => false,
        };
        (!excluded).then_some(memory)
    }

    /// Where the agents are at the next time.
    fn come(&self, lones: &[Lone<'_>], steps: &[Step], memory: Memory) -> Option<Memory> {
        let mut memory = memory;
        let at = |i: usize| {
            lones
                .get(i)
                .zip(steps.get(i))
                .and_then(|(_, s)| Lone::cell(s.to))
        };
        let here = self.agent.and_then(at);
        let excluded = match self.condition {
            Condition::Never {
                act: Act::Visit(cell),
                times,
                ..
            } => here == Some(*cell) && times.contains(memory.time),
            Condition::Visit { agent, cell } => {
                memory.done |= match agent {
                    Some(_) => here == Some(*cell),
                    None => (0..steps.len()).any(|i| at(i) == Some(*cell)),
                };
                false
            }
            Condition::Before { first, second } => {
                let other = self.other.and_then(at);
                memory.late |= other == Some(second.cell);
                memory.done |= here == Some(first.cell) && !memory.late;
                memory.late && !memory.done
            }
            // No number is below 0.
            Condition::Below { limit, .. } => *limit == 0,
            Condition::Never {
                act: Act::Move(..) | Act::SlowMove(_) | Act::Wait { .. } | Act::Charge(_),
                ..
            }
            | Condition::Move { .. }
            | Condition::Charge { .. }
            | Condition::Keeps(_) => false,
        };
        // Once it is done, it does not matter any more.
        memory.late &= !memory.done;
        (!excluded).then_some(memory)
    }
}
