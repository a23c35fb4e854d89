//! What an automaton remembers of the way so far beside the set of things done: counters, each
//! a digit of the mask above the bits of that set.
//!
//! Tables do not know counters and take the best case; searches and MDDs follow them step
//! by step.

use giveway_model::{condition::Times, constraint::Heading};

use super::{Area, Entry, Left, Place};
use crate::terrain::Vertex;

/// Something to be counted on the way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Counter {
    /// Wait steps on end, of which there must not be so many.
    LongWait(LongWait),
    /// How many of these vertices it has been at, in this order; it has to be at all.
    Sequence(Vec<Vertex>),
    /// How long it has been at a vertex on end.
    Stay(Stay),
    /// Where it faces, and how long it has stood.
    Turns(Turns),
    /// Whether it has waited where it is: it arrives by entering, and not before a time.
    Entry(Entry),
    /// Whether it has been at a vertex.
    Visited(Vertex),
    /// Whether it has been at the first vertex; it must not be at the second up to then.
    Order(Vertex, Vertex),
    /// Whether it has left an area that it is in at time 0.
    Left(Left),
}

/// So many wait steps on end at a vertex, or anywhere, that begin within some times.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LongWait {
    /// The vertices; anywhere where it is `None`.
    pub at: Option<Area>,
    /// When the steps begin.
    pub times: Times,
    /// The number of steps, at least 1.
    pub steps: u32,
    /// How many of them were made before time 0 already, fewer than that number.
    pub begun: u32,
    /// Wait steps that begin before this time are those of a breakdown: they do not count.
    pub held: u32,
}

/// A stay at a vertex for some steps, within some times.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stay {
    /// The vertex.
    pub at: Vertex,
    /// The number of steps; 0 to pass.
    pub steps: u32,
    /// When.
    pub times: Times,
    /// Whether the agent stays where it arrives, so that resting there counts.
    pub rests: bool,
    /// For how many time steps on end it was there just before time 0, no more than `steps`.
    pub begun: u32,
}

/// Turns that take time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turns {
    /// The steps of a quarter turn, at least 1.
    pub quarter: u32,
    /// Where it faces at time 0; anywhere where it is `None`.
    pub heading: Option<Heading>,
    /// For how long it has stood before time 0.
    pub begun: u32,
}

/// A time step of an agent, as counters see it.
#[derive(Clone, Copy, Debug)]
pub struct Passage {
    /// Where it is.
    pub from: Place,
    /// Where it is one time step later.
    pub to: Place,
    /// The direction of the move that it begins, if it begins one.
    pub heading: Option<Heading>,
    /// When the step begins.
    pub now: u32,
}

impl LongWait {
    /// Whether a wait step is one of those that count.
    pub fn counts(&self, at: Vertex, now: u32) -> bool {
        self.at.as_ref().is_none_or(|area| area.has(at)) && self.times.contains(now)
    }

    fn next(&self, run: u32, passage: Passage) -> Option<u32> {
        let run = match passage.from {
            Place::At(_) if passage.from == passage.to && passage.now < self.held => run,
            Place::At(v) if passage.from == passage.to && self.counts(v, passage.now) => run + 1,
            Place::At(_) | Place::Along(_) => 0,
        };
        (run < self.steps).then_some(run)
    }
}

impl Stay {
    /// The digit of a stay that was made.
    pub(crate) const fn done(&self) -> u32 {
        self.steps.saturating_add(1)
    }

    /// Whether a digit is that of a stay that was made.
    pub(crate) const fn is_done(&self, run: u32) -> bool {
        run == self.done()
    }

    fn next(&self, run: u32, to: Place, now: u32) -> u32 {
        match to {
            _ if run == self.done() => run,
            Place::At(v) if v == self.at && self.times.contains(now) => run + 1,
            Place::At(_) | Place::Along(_) => 0,
        }
    }

    /// Whether it is made by resting at a vertex from a time on, if not before.
    fn is_made_at(&self, run: u32, v: Vertex, now: u32) -> bool {
        if run == self.done() {
            return true;
        }
        let until = match run {
            0 if now >= self.times.first() => return false, // it is not there, or too late
            0 => self.times.first().saturating_add(self.steps),
            // (It may have begun before time 0.)
            run => now.saturating_add(self.steps + 1).saturating_sub(run),
        };
        self.rests && v == self.at && until <= self.times.last()
    }

    /// The steps that it still has to stand there, if not at rest.
    fn left(&self, run: u32) -> u32 {
        self.steps.saturating_sub(run.saturating_sub(1))
    }
}

impl Turns {
    /// The number of counts of how long it has stood.
    const fn most(self) -> u32 {
        self.quarter.saturating_mul(2).saturating_add(1)
    }

    fn digit(self, heading: Option<Heading>, stood: u32) -> u32 {
        let facing = heading.map_or(4, |heading| heading as u32);
        facing * self.most() + stood
    }

    pub(super) fn facing(self, digit: u32) -> (Option<Heading>, u32) {
        let facing = Heading::ALL.get((digit / self.most()) as usize);
        (facing.copied(), digit % self.most())
    }

    fn next(self, digit: u32, passage: Passage) -> Option<u32> {
        let (facing, stood) = self.facing(digit);
        let Some(heading) = passage.heading else {
            let waits = passage.from == passage.to;
            let stood = (stood + u32::from(waits)).min(self.most() - 1);
            return Some(self.digit(facing, stood));
        };
        let has_turned = stood >= self.turning(facing, heading);
        has_turned.then(|| self.digit(Some(heading), 0))
    }

    /// The steps of a turn from one direction to another.
    fn turning(self, facing: Option<Heading>, heading: Heading) -> u32 {
        let quarters = facing.map_or(0, |facing| facing.quarters_to(heading));
        self.quarter.saturating_mul(quarters)
    }

    /// The steps for which an agent still stands before it moves into a direction.
    pub(crate) fn stands_before(self, digit: u32, heading: Option<Heading>) -> u32 {
        let (facing, stood) = self.facing(digit);
        let turning = heading.map_or(0, |heading| self.turning(facing, heading));
        turning.saturating_sub(stood)
    }

    /// The digit after a move into a direction.
    pub(crate) fn after_move(self, heading: Option<Heading>) -> u32 {
        self.digit(heading, 0)
    }

    /// The digit after so many more steps of standing.
    pub(crate) fn after_standing(self, digit: u32, steps: u32) -> u32 {
        let (facing, stood) = self.facing(digit);
        self.digit(facing, stood.saturating_add(steps).min(self.most() - 1))
    }
}

impl Counter {
    /// The number of counts.
    pub fn size(&self) -> u32 {
        match self {
            Self::LongWait(wait) => wait.steps,
            Self::Sequence(stops) => stops.len() as u32 + 1,
            Self::Stay(stay) => stay.steps.saturating_add(2),
            Self::Turns(turns) => turns.most().saturating_mul(5),
            Self::Entry(_) | Self::Visited(_) | Self::Order(..) | Self::Left(_) => 2,
        }
    }

    /// The count at time 0 of an agent that is at a vertex then, `None` where it is in
    /// transit; `None` where that is forbidden.
    pub fn first(&self, at: Option<Vertex>) -> Option<u32> {
        match self {
            Self::LongWait(wait) => Some(wait.begun),
            Self::Sequence(_) => Some(at.map_or(0, |at| self.after(0, at))),
            Self::Stay(stay) => Some(at.map_or(0, |at| stay.next(stay.begun, Place::At(at), 0))),
            Self::Turns(turns) => {
                Some(turns.digit(turns.heading, turns.begun.min(turns.most() - 1)))
            }
            Self::Entry(entry) => Some(u32::from(entry.stood)),
            Self::Left(_) => Some(0),
            Self::Visited(v) => Some(u32::from(at == Some(*v))),
            Self::Order(first, second) => {
                (at != Some(*second)).then_some(u32::from(at == Some(*first)))
            }
        }
    }

    /// The stops of a sequence made once it is at a vertex.
    fn after(&self, mut made: u32, at: Vertex) -> u32 {
        if let Self::Sequence(stops) = self {
            while stops.get(made as usize) == Some(&at) {
                made += 1;
            }
        }
        made
    }

    /// The count after a time step; `None` where that is forbidden.
    pub fn next(&self, count: u32, passage: Passage) -> Option<u32> {
        let Passage { from, to, now, .. } = passage;
        match self {
            Self::LongWait(wait) => wait.next(count, passage),
            Self::Sequence(_) => Some(match to {
                Place::At(v) => self.after(count, v),
                Place::Along(_) => count,
            }),
            Self::Stay(stay) => Some(stay.next(count, to, now + 1)),
            Self::Turns(turns) => turns.next(count, passage),
            Self::Entry(_) => Some(u32::from(from == to)),
            Self::Left(left) => left.next(count, to, now + 1),
            Self::Visited(v) => Some(count.max(u32::from(to == Place::At(*v)))),
            Self::Order(first, second) => {
                let is_allowed = count == 1 || to != Place::At(*second);
                is_allowed.then(|| count.max(u32::from(to == Place::At(*first))))
            }
        }
    }

    /// Whether an agent may arrive at a vertex at a time with this count.
    pub fn may_end(&self, count: u32, v: Vertex, now: u32) -> bool {
        match self {
            Self::LongWait(_) | Self::Turns(_) | Self::Visited(_) | Self::Order(..) => true,
            Self::Sequence(stops) => count as usize == stops.len(),
            Self::Stay(stay) => stay.is_made_at(count, v, now),
            Self::Entry(entry) => count == 0 && now >= entry.from || now == 0 && entry.may_stay,
            Self::Left(left) => left.may_end(count, v, now),
        }
    }

    /// The steps that an agent still has to stand at its goal's side of the way, by this
    /// counter alone.
    pub fn still_to_stand(&self, count: u32) -> u32 {
        match self {
            Self::Stay(stay) if !stay.rests => stay.left(count),
            Self::Stay(_)
            | Self::LongWait(_)
            | Self::Sequence(_)
            | Self::Turns(_)
            | Self::Entry(_)
            | Self::Visited(_)
            | Self::Order(..)
            | Self::Left(_) => 0,
        }
    }

    /// The last time that it is about, where it is about some.
    pub fn last_time(&self) -> Option<u32> {
        match self {
            Self::LongWait(wait) => last_of(wait.times).max((wait.held > 0).then_some(wait.held)),
            Self::Stay(stay) => last_of(stay.times),
            // An arrival at time 0 may be one of before.
            Self::Entry(entry) => (entry.from > 0 || entry.may_stay).then_some(entry.from),
            Self::Left(left) => left.closed.and_then(last_of),
            Self::Sequence(_) | Self::Turns(_) | Self::Visited(_) | Self::Order(..) => None,
        }
    }
}

/// The last time at which it matters whether times have it.
pub(super) fn last_of(times: Times) -> Option<u32> {
    (!times.are_all()).then(|| times.to.unwrap_or_else(|| times.first()))
}
