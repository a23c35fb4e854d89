//! A condition on a plan, watched step by step: what has to be remembered of the
//! way so far, and when it can be met no more.

use giveway_model::{Cell, Cost, Instance, Question};

use super::lone::{Lone, State, Step};
use crate::Condition;

/// What has been seen so far of what a condition is about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Memory {
    /// The time, up to the last one that matters and one more.
    time: u32,
    /// Steps, or waits on end, counted so far.
    count: u32,
    /// What has to happen has happened.
    done: bool,
    /// The agent that has to come later has been there.
    late: bool,
}

/// Watches a condition. All agents of the instance are searched, in its order.
pub(super) struct Watch<'a> {
    condition: &'a Condition,
    /// Whom it is about; nobody in particular where it is about anybody.
    agent: Option<usize>,
    /// The agent that has to come later.
    other: Option<usize>,
    /// The last time that matters; `None` where times do not.
    last: Option<u32>,
    /// The time at which the agent must not be at the goal where it rests.
    not_resting: Option<u32>,
}

impl<'a> Watch<'a> {
    /// `None` where the condition is about no agent, or nothing that agents do.
    pub(super) fn of(instance: &Instance, condition: &'a Condition) -> Option<Self> {
        if !condition.fits(instance) {
            return None;
        }
        let number = |name: &str| instance.agents().iter().position(|a| a.name == name);
        let (agent, other) = match condition {
            Condition::Arrival { agent, .. } | Condition::AtMost { agent, .. } => {
                (number(agent), None)
            }
            Condition::Contrast(Question::Yield { agent, to, .. }) => (number(agent), number(to)),
            Condition::Contrast(question) => (question.agent().and_then(number), None),
        };
        let last = match condition {
            Condition::Contrast(Question::Wait { from, to, .. }) => to.or(*from),
            Condition::Contrast(
                Question::Charge { time, .. }
                | Question::Visit { time, .. }
                | Question::Move { time, .. }
                | Question::NoMove { time, .. },
            ) => *time,
            _ => None,
        };
        let not_resting = match condition {
            Condition::Contrast(Question::Visit { at, time, .. }) => {
                let goal = agent
                    .and_then(|index| instance.agents().get(index))
                    .map(|a| a.goal);
                time.filter(|_| instance.stays() && goal == Some(*at))
            }
            _ => None,
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
        if matches!(self.condition, Condition::Arrival { before: 0, .. }) {
            return None;
        }
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
        if let Some(((lone, from), step)) = self
            .agent
            .and_then(|i| lones.get(i).zip(before.get(i)).zip(steps.get(i)))
        {
            // To arrive where it waited is to have arrived before.
            let waits = step.crosses.is_none() && !from.has_arrived();
            if waits && step.to.has_arrived() {
                return None;
            }
            memory = self.leave(lone, *from, step, memory)?;
        }
        memory.time = self.last.map_or(0, |last| {
            memory.time.saturating_add(1).min(last.saturating_add(1))
        });
        self.come(lones, steps, memory)
    }

    /// Whether the condition is met once all agents have arrived.
    pub(super) fn is_met(&self, memory: Memory) -> bool {
        match self.condition {
            Condition::Contrast(
                Question::NoCharge { .. }
                | Question::NoVisit { .. }
                | Question::NoMove { .. }
                | Question::Order { .. }
                | Question::Yield { .. },
            ) => memory.done,
            _ => self.not_resting.is_none_or(|time| memory.time > time),
        }
    }

    /// What the agent does from one time to the next.
    fn leave(&self, lone: &Lone<'_>, from: State, step: &Step, memory: Memory) -> Option<Memory> {
        let mut memory = memory;
        let takes = |cost: Cost| step.spent[cost as usize];
        let here = lone.cell(from);
        let now = |time: &Option<u32>| time.is_none_or(|time| time == memory.time);
        let there = |at: &Option<Cell>| at.is_none_or(|at| here == Some(at));
        let begins = |u: &Cell, v: &Cell| takes(Cost::Moves) > 0 && step.crosses == Some((*u, *v));
        let excluded = match self.condition {
            Condition::Arrival { before, .. } => {
                memory.count = memory.count.saturating_add(takes(Cost::Makespan));
                memory.count >= *before
            }
            Condition::AtMost { cost, most, .. } => {
                memory.count = memory.count.saturating_add(takes(*cost));
                memory.count > *most
            }
            Condition::Contrast(Question::Wait {
                at,
                from,
                to,
                at_least,
                ..
            }) => {
                let begun = from.is_none_or(|from| from <= memory.time);
                let then = begun && to.is_none_or(|to| memory.time < to);
                let waits = takes(Cost::Waits) > 0 && there(at) && then;
                // As many as are too many are enough to know.
                memory.count = if waits {
                    memory.count.saturating_add(1)
                } else {
                    0
                };
                memory.count >= at_least.unwrap_or(1).max(1)
            }
            Condition::Contrast(Question::Charge { at, time, .. }) => {
                takes(Cost::Charges) > 0 && there(at) && now(time)
            }
            Condition::Contrast(Question::NoCharge { at, .. }) => {
                memory.done |= takes(Cost::Charges) > 0 && here == Some(*at);
                false
            }
            Condition::Contrast(Question::Move {
                from_cell,
                to_cell,
                time,
                ..
            }) => begins(from_cell, to_cell) && now(time),
            Condition::Contrast(Question::NoMove {
                from_cell,
                to_cell,
                time,
                ..
            }) => {
                let happens = begins(from_cell, to_cell) && now(time);
                memory.done |= happens;
                false
            }
            Condition::Contrast(Question::Slow {
                from_cell, to_cell, ..
            }) => {
                let edge = from_cell.zip(*to_cell);
                let slow = lone.cell(step.to).is_none() && !step.to.has_arrived();
                slow && edge.is_none_or(|(u, v)| begins(&u, &v) || begins(&v, &u))
            }
            Condition::Contrast(_) => false,
        };
        (!excluded).then_some(memory)
    }

    /// Where the agents are at the next time.
    fn come(&self, lones: &[Lone<'_>], steps: &[Step], memory: Memory) -> Option<Memory> {
        let mut memory = memory;
        let cell = |i: usize| {
            lones
                .get(i)
                .zip(steps.get(i))
                .and_then(|(a, s)| a.cell(s.to))
        };
        let here = self.agent.and_then(cell);
        let Condition::Contrast(question) = self.condition else {
            return Some(memory);
        };
        let excluded = match question {
            Question::Visit { at, time, .. } => {
                here == Some(*at) && time.is_none_or(|time| time == memory.time)
            }
            Question::NoVisit { agent: None, at } => {
                memory.done |= (0..steps.len()).any(|i| cell(i) == Some(*at));
                false
            }
            Question::NoVisit { at, .. } => {
                memory.done |= here == Some(*at);
                false
            }
            Question::Order { first, second, .. } => {
                memory.late |= here == Some(*first);
                memory.done |= here == Some(*second) && !memory.late;
                memory.late && !memory.done
            }
            Question::Yield { at, .. } => {
                memory.late |= self.other.and_then(cell) == Some(*at);
                memory.done |= here == Some(*at) && !memory.late;
                memory.late && !memory.done
            }
            _ => false,
        };
        // Once it is done, it does not matter any more.
        memory.late &= !memory.done;
        (!excluded).then_some(memory)
    }
}
