//! What a question asks of the other plan, followed step by step.
//!
//! An agent that is asked about remembers, along its way, as much as the
//! question needs: the time as long as it matters, one thing done or not, one
//! number of steps. A way that cannot be what is asked for any more ends there.

use giveway_model::{Cell, Path, Plan, Question};

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

/// What one agent must do, or must not do.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// It is not at the cell at the time, or ever.
    NotAt(Cell, Option<u32>),
    /// It is at the cell some time.
    At(Cell),
    /// It is at the second cell before it is at the first.
    Swapped { first: Cell, second: Cell },
    /// It does not wait so many steps on end.
    ShortWaits {
        at: Option<Cell>,
        from: Option<u32>,
        to: Option<u32>,
        steps: u32,
    },
    /// It does not charge there, or then.
    NoCharge(Option<Cell>, Option<u32>),
    /// It charges there.
    Charge(Cell),
    /// It does not go from one cell to the other at the time, or ever.
    NoMove([Cell; 2], Option<u32>),
    /// It goes from one cell to the other, at the time where one is given.
    Move([Cell; 2], Option<u32>),
    /// It makes no slow move over the edge, or over any.
    NoSlowMove(Option<[Cell; 2]>),
    /// It arrives before the time.
    ArriveBefore(u32),
    /// It has fewer of these.
    Fewer(Counted, u32),
}

/// What an agent has a number of.
#[derive(Clone, Copy, Debug)]
enum Counted {
    Moves,
    Charges,
    Waits,
}

/// A question about one agent.
#[derive(Clone, Debug)]
pub(crate) struct Asked {
    rule: Rule,
    /// The last time that matters; `None` where times do not.
    last: Option<u32>,
    /// Whether arrived agents stay.
    stays: bool,
    /// Wait steps just before time 0 that count.
    waited: u32,
}

impl Asked {
    /// What is asked of the agent of this name, which stays at its goal or
    /// vanishes there; `None` where nothing is.
    pub(crate) fn of(contrast: Contrast, name: &str, stays: bool) -> Option<Self> {
        let question = contrast.question;
        if question.agent() != Some(name) {
            return None;
        }
        let path = &contrast.plan.paths[name];
        let charges = contrast.plan.charges.get(name).map_or(0, Vec::len) as u32;
        let rule = match *question {
            Question::Wait {
                at,
                from,
                to,
                at_least,
                ..
            } => Rule::ShortWaits {
                at,
                from,
                to,
                steps: at_least.unwrap_or(1),
            },
            Question::Charge { at, time, .. } => Rule::NoCharge(at, time),
            Question::NoCharge { at, .. } => Rule::Charge(at),
            Question::Visit { at, time, .. } => Rule::NotAt(at, time),
            Question::NoVisit { at, .. } | Question::Yield { at, .. } => Rule::At(at),
            Question::Move {
                from_cell,
                to_cell,
                time,
                ..
            } => Rule::NoMove([from_cell, to_cell], time),
            Question::NoMove {
                from_cell,
                to_cell,
                time,
                ..
            } => Rule::Move([from_cell, to_cell], time),
            Question::Slow {
                from_cell, to_cell, ..
            } => Rule::NoSlowMove(from_cell.zip(to_cell).map(<[Cell; 2]>::from)),
            Question::Order { first, second, .. } => Rule::Swapped { first, second },
            Question::Arrival { .. } => Rule::ArriveBefore(path.len() as u32 - 1),
            Question::Length { fewer_than, .. } => {
                Rule::Fewer(Counted::Moves, fewer_than.unwrap_or_else(|| moves(path)))
            }
            Question::Moves { .. } => Rule::Fewer(Counted::Moves, moves(path)),
            Question::Charges { .. } => Rule::Fewer(Counted::Charges, charges),
            Question::Waits { .. } => Rule::Fewer(Counted::Waits, waits(path)),
            Question::Makespan
            | Question::SumOfCosts
            | Question::Penalty
            | Question::Rule { .. }
            | Question::Unsolvable
            | Question::Plan => {
                return None;
            }
        };
        let last = match rule {
            Rule::ShortWaits { from, to, .. } => to.or(from),
            Rule::NotAt(_, time)
            | Rule::NoCharge(_, time)
            | Rule::NoMove(_, time)
            | Rule::Move(_, time) => time,
            Rule::ArriveBefore(time) => Some(time),
            Rule::At(_)
            | Rule::Swapped { .. }
            | Rule::Charge(_)
            | Rule::NoSlowMove(_)
            | Rule::Fewer(..) => None,
        };
        Some(Self {
            rule,
            last,
            stays,
            waited: 0,
        })
    }

    /// The same of an agent that has waited for so many steps already.
    pub(crate) fn having_waited(self, waited: u32) -> Self {
        Self { waited, ..self }
    }

    /// What it remembers at time 0.
    pub(super) fn first(&self) -> Memory {
        let is_wait = matches!(self.rule, Rule::ShortWaits { .. });
        Memory {
            count: if is_wait { self.waited } else { 0 },
            ..Memory::default()
        }
    }

    /// It is at a vertex now.
    pub(super) fn enter(&self, memory: Memory, cell: Cell) -> Option<Memory> {
        let mut memory = memory;
        let allowed = match self.rule {
            Rule::NotAt(at, time) => at != cell || time.is_some_and(|time| time != memory.time),
            Rule::At(at) => {
                memory.done |= at == cell;
                true
            }
            Rule::Swapped { first, second } => {
                let too_early = first == cell && !memory.done;
                memory.done |= second == cell;
                !too_early
            }
            Rule::ShortWaits { .. }
            | Rule::NoCharge(..)
            | Rule::Charge(_)
            | Rule::NoMove(..)
            | Rule::Move(..)
            | Rule::NoSlowMove(_)
            | Rule::ArriveBefore(_)
            | Rule::Fewer(..) => true,
        };
        allowed.then_some(memory)
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
        let at_time = |time: Option<u32>| time.is_none_or(|time| time == now);
        let goes = |u: Cell, v: Cell| from == u && to == Some(v);
        let allowed = match self.rule {
            Rule::ShortWaits {
                at,
                from: begin,
                to: end,
                steps,
            } => {
                let there = at.is_none_or(|at| at == from);
                let then = begin.is_none_or(|t| t <= now) && end.is_none_or(|t| now < t);
                let counts = to.is_none() && there && then;
                memory.count = if counts { memory.count + 1 } else { 0 };
                !counts || memory.count < steps
            }
            Rule::NoCharge(at, time) => {
                !(charges && at.is_none_or(|at| at == from) && at_time(time))
            }
            Rule::Charge(at) => {
                memory.done |= charges && at == from;
                true
            }
            Rule::NoMove([u, v], time) => !(goes(u, v) && at_time(time)),
            Rule::Move([u, v], time) => {
                memory.done |= goes(u, v) && at_time(time);
                true
            }
            Rule::NoSlowMove(edge) => !(slow && edge.is_none_or(|[u, v]| goes(u, v) || goes(v, u))),
            Rule::Fewer(counted, below) => {
                memory.count += u32::from(match counted {
                    Counted::Moves => to.is_some(),
                    Counted::Charges => charges,
                    Counted::Waits => to.is_none(),
                });
                memory.count < below
            }
            Rule::NotAt(..) | Rule::At(_) | Rule::Swapped { .. } | Rule::ArriveBefore(_) => true,
        };
        allowed.then(|| self.later(memory))
    }

    /// One step later.
    pub(super) fn later(&self, memory: Memory) -> Memory {
        let time = self.last.map_or(0, |last| (memory.time + 1).min(last + 1));
        Memory { time, ..memory }
    }

    /// Whether it may arrive for good at this cell now.
    pub(super) fn may_arrive(&self, memory: Memory, cell: Cell) -> bool {
        match self.rule {
            Rule::At(_) | Rule::Swapped { .. } | Rule::Charge(_) | Rule::Move(..) => memory.done,
            Rule::ArriveBefore(time) => memory.time < time,
            // To rest there is to be there.
            Rule::NotAt(at, Some(time)) => at != cell || !self.stays || memory.time > time,
            // Not even none is fewer than none.
            Rule::Fewer(_, below) => memory.count < below,
            Rule::NotAt(_, None)
            | Rule::ShortWaits { .. }
            | Rule::NoCharge(..)
            | Rule::NoMove(..)
            | Rule::NoSlowMove(_) => true,
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
