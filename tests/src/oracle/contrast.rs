//! What a question asks of the other plan, followed step by step.
//!
//! An agent that is asked about remembers, along its way, as much as the
//! question needs: the time as long as it matters, one thing done or not, one
//! number of steps. A way that cannot be what is asked for any more ends there.

use giveway_model::{Cell, Instance, Path, Plan, Question};

/// A question about a plan.
#[derive(Clone, Copy, Debug)]
pub struct Contrast<'a> {
    /// The question.
    pub question: &'a Question,
    /// The plan that it is about.
    pub plan: &'a Plan,
}

/// What an agent remembers for a question.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Memory {
    /// The time, up to the last one that matters and one more.
    time: u32,
    /// Whether it has done what it is asked to do.
    pub(crate) done: bool,
    /// Steps counted so far.
    count: u32,
}

/// A question about one agent.
#[derive(Clone, Debug)]
pub(crate) struct Asked {
    question: Question,
    /// The number that another must be below, where the question is about one.
    below: u32,
    /// The last time that matters; `None` where times do not.
    last: Option<u32>,
    /// Whether arrived agents stay.
    stays: bool,
    goal: Option<Cell>,
    /// Wait steps just before time 0 that count.
    waited: u32,
}

impl Asked {
    /// What is asked of the agent of this name, which stays at its goal or
    /// vanishes there; `None` where nothing is.
    pub(crate) fn of(
        instance: &Instance,
        contrast: Contrast,
        name: &str,
        stays: bool,
    ) -> Option<Self> {
        let question = contrast.question;
        if question.agent() != Some(name) {
            return None;
        }
        let agent = instance.agents().iter().find(|a| a.name == name)?;
        let path = &contrast.plan.paths[name];
        let charges = contrast.plan.charges.get(name).map_or(0, Vec::len) as u32;
        let arrival = path.len() as u32 - 1;
        let below = match question {
            Question::Arrival { .. } => arrival,
            Question::Charges { .. } => charges,
            Question::Waits { .. } => waits(path),
            Question::Length {
                fewer_than: Some(below),
                ..
            } => *below,
            Question::Length { .. } | Question::Moves { .. } => moves(path),
            _ => 0,
        };
        let last = match question {
            Question::Wait { from, to, .. } => to.or(*from),
            Question::Charge { time, .. }
            | Question::Visit { time, .. }
            | Question::Move { time, .. }
            | Question::NoMove { time, .. } => *time,
            Question::Arrival { .. } => Some(arrival),
            _ => None,
        };
        Some(Self {
            question: question.clone(),
            below,
            last,
            stays,
            goal: agent.goal,
            waited: 0,
        })
    }

    /// The same of an agent that has waited for so many steps already.
    pub(crate) fn having_waited(self, waited: u32) -> Self {
        Self { waited, ..self }
    }

    /// What it remembers at time 0.
    pub(super) fn first(&self) -> Memory {
        let is_wait = matches!(self.question, Question::Wait { .. });
        Memory {
            count: if is_wait { self.waited } else { 0 },
            ..Memory::default()
        }
    }

    /// It is at a vertex now.
    pub(super) fn enter(&self, memory: Memory, cell: Cell) -> Option<Memory> {
        let mut memory = memory;
        match &self.question {
            Question::Visit { at, time, .. } => {
                let then = time.is_none_or(|time| time == memory.time);
                if *at == cell && then {
                    return None;
                }
            }
            Question::NoVisit { at, .. } | Question::Yield { at, .. } => {
                memory.done |= *at == cell;
            }
            Question::Order { first, second, .. } => {
                if *first == cell && !memory.done {
                    return None;
                }
                memory.done |= *second == cell;
            }
            _ => {}
        }
        Some(memory)
    }

    /// It leaves a vertex for another now, or waits there; it may charge first.
    pub(super) fn leave(
        &self,
        memory: Memory,
        from: Cell,
        to: Option<Cell>,
        charges: bool,
        slow: bool,
    ) -> Option<Memory> {
        let mut memory = memory;
        let now = memory.time;
        let at_time = |time: &Option<u32>| time.is_none_or(|time| time == now);
        let counted = match &self.question {
            Question::Wait {
                at,
                from: begin,
                to: end,
                at_least,
                ..
            } => {
                let there = at.is_none_or(|at| at == from);
                let then = begin.is_none_or(|t| t <= now) && end.is_none_or(|t| now < t);
                if !(to.is_none() && there && then) {
                    memory.count = 0;
                    return Some(self.later(memory));
                }
                memory.count += 1;
                (memory.count < at_least.unwrap_or(1)).then_some(false)
            }
            Question::Charge { at, time, .. } => {
                let there = at.is_none_or(|at| at == from);
                (!(charges && there && at_time(time))).then_some(false)
            }
            Question::NoCharge { at, .. } => {
                memory.done |= charges && *at == from;
                Some(false)
            }
            Question::Move {
                from_cell,
                to_cell,
                time,
                ..
            } => {
                let goes = from == *from_cell && to == Some(*to_cell) && at_time(time);
                (!goes).then_some(false)
            }
            Question::NoMove {
                from_cell,
                to_cell,
                time,
                ..
            } => {
                memory.done |= from == *from_cell && to == Some(*to_cell) && at_time(time);
                Some(false)
            }
            Question::Slow {
                from_cell, to_cell, ..
            } => {
                let ends = [Some(from), to];
                let over = from_cell.is_none()
                    || ends == [*from_cell, *to_cell]
                    || ends == [*to_cell, *from_cell];
                (!(slow && over)).then_some(false)
            }
            Question::Length { .. } | Question::Moves { .. } => Some(to.is_some()),
            Question::Charges { .. } => Some(charges),
            Question::Waits { .. } => Some(to.is_none()),
            _ => Some(false),
        }?;
        memory.count += u32::from(counted);
        let limited = matches!(
            self.question,
            Question::Length { .. }
                | Question::Moves { .. }
                | Question::Charges { .. }
                | Question::Waits { .. }
        );
        (!limited || memory.count < self.below).then(|| self.later(memory))
    }

    /// One step later.
    pub(super) fn later(&self, memory: Memory) -> Memory {
        let time = self.last.map_or(0, |last| (memory.time + 1).min(last + 1));
        Memory { time, ..memory }
    }

    /// Whether it may arrive for good now.
    pub(super) fn may_arrive(&self, memory: Memory) -> bool {
        match &self.question {
            Question::NoCharge { .. }
            | Question::NoVisit { .. }
            | Question::NoMove { .. }
            | Question::Yield { .. }
            | Question::Order { .. } => memory.done,
            Question::Arrival { .. } => memory.time < self.below,
            // To rest there is to be there.
            Question::Visit {
                at,
                time: Some(time),
                ..
            } if Some(*at) == self.goal && self.stays => memory.time > *time,
            // Not even none is fewer than none.
            Question::Length { .. }
            | Question::Moves { .. }
            | Question::Charges { .. }
            | Question::Waits { .. } => memory.count < self.below,
            _ => true,
        }
    }

    /// Whether it may rest at this cell for good from now on, where it has no goal.
    pub(super) fn may_rest(&self, memory: Memory, cell: Cell) -> bool {
        match &self.question {
            Question::Visit {
                at,
                time: Some(time),
                ..
            } if *at == cell && self.stays => memory.time > *time,
            _ => true,
        }
    }
}

fn waits(path: &Path) -> u32 {
    let pairs = path.windows(2);
    pairs.filter(|p| p[0].is_some() && p[0] == p[1]).count() as u32
}

fn moves(path: &Path) -> u32 {
    let stops: Vec<Cell> = path.iter().copied().flatten().collect();
    stops.windows(2).filter(|pair| pair[0] != pair[1]).count() as u32
}
