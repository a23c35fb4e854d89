//! Rows of the table: one agent each, over all times.

use super::{Area, Judged};
use crate::check::{Step, Walk, steps};
use crate::constraint::Heading;
use crate::{Cell, Instance, StartState};

/// A move.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Move {
    /// When it begins.
    pub(in super::super) begin: u32,
    /// When it ends.
    pub(in super::super) end: u32,
    /// From where.
    pub(in super::super) from: Cell,
    /// To where.
    pub(in super::super) to: Cell,
    /// Whether it began before time 0: what must be so at its begin is past.
    pub(in super::super) is_under_way: bool,
}

impl Move {
    /// The move of a step, where it is one.
    pub(in super::super) const fn of(begin: u32, step: Step) -> Option<Self> {
        let (steps, from, to) = match step {
            Step::Move { from, to } => (1, from, to),
            Step::SlowMove { from, to } => (2, from, to),
            Step::Wait | Step::Broken { .. } => return None,
        };
        let end = begin.saturating_add(steps);
        Some(Self {
            begin,
            end,
            from,
            to,
            is_under_way: false,
        })
    }
}

/// A wait step.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Wait {
    /// When it begins.
    pub(in super::super) time: u32,
    /// Whether the agent has broken down: rules about waits do not count it.
    pub(in super::super) is_held: bool,
}

/// What a rule has to know of the time before the table begins.
pub(in super::super) type Start = StartState;

/// A row of the table.
pub(in super::super) struct Row<'a> {
    /// The agent's number.
    pub(in super::super) agent: usize,
    /// Its name.
    pub(in super::super) name: &'a str,
    /// The time of the first entry.
    pub(in super::super) from: u32,
    /// Where it is from then on, up to its arrival or removal.
    pub(in super::super) path: &'a [Option<Cell>],
    /// Its arrival; of an agent that is removed the last time at which it is there.
    pub(in super::super) arrival: u32,
    /// Whether it is removed, and never arrives.
    pub(in super::super) is_removed: bool,
    /// The time from which on it is gone; `None` where it stays where it arrives.
    pub(in super::super) gone: Option<u32>,
    /// Its moves, by time.
    pub(in super::super) moves: Vec<Move>,
    /// Its wait steps, by time.
    pub(in super::super) waits: Vec<Wait>,
    /// When it breaks down.
    pub(in super::super) breakdowns: Vec<u32>,
    /// Where it faces at first.
    pub(in super::super) heading: Option<Heading>,
    /// What was before.
    pub(in super::super) start: &'a Start,
}

impl<'a> Row<'a> {
    /// The row of an agent of an instance.
    pub(super) fn of_walk(instance: &'a Instance, walk: &'a Walk<'a>) -> Self {
        let arrival = walk.arrival() as u32;
        let start = instance.start_state(&walk.agent.name);
        let steps: Vec<(usize, Step)> = steps(instance.grid(), walk.path).collect();
        let moves = steps.iter();
        let mut moves: Vec<Move> = moves
            .filter_map(|&(begin, step)| Move::of(begin as u32, step))
            .collect();
        // The end of a slow move that began before.
        if let (Some(from), None, Some(to)) = (start.transit_from, walk.at(0), walk.at(1)) {
            let arriving = Move {
                begin: 0,
                end: 1,
                from,
                to,
                is_under_way: true,
            };
            moves.insert(0, arriving);
        }
        let waits = steps.iter().filter(|(_, step)| *step == Step::Wait);
        let waits = waits.map(|&(time, _)| Wait {
            time: time as u32,
            is_held: (time as u32) < start.not_before(),
        });
        Self {
            agent: walk.index,
            name: &walk.agent.name,
            from: 0,
            path: walk.path,
            arrival,
            is_removed: false,
            gone: (!instance.keeps(walk.agent)).then_some(arrival + 1),
            moves,
            waits: waits.collect(),
            breakdowns: Vec::new(),
            heading: walk.agent.heading,
            start,
        }
    }

    /// The time from which on it does not move any more.
    pub(super) fn settled(&self) -> u32 {
        self.arrival.max(self.gone.unwrap_or(0))
    }

    /// The cell that it is at; `None` in transit, and while it is not there.
    pub(super) fn at(&self, time: u32) -> Option<Cell> {
        let index = time.checked_sub(self.from)? as usize;
        match self.path.get(index) {
            Some(entry) => *entry,
            None if self.is_gone(time) => None,
            None => self.path.last().copied().flatten(),
        }
    }

    fn is_gone(&self, time: u32) -> bool {
        self.gone.is_some_and(|gone| gone <= time)
    }

    /// Whether it stays where it arrives.
    pub(super) const fn stays(&self) -> bool {
        self.gone.is_none()
    }

    /// The cells that count for a zone or a distance: both ends of its edge in transit.
    pub(super) fn touches(&self, time: u32) -> impl Iterator<Item = Cell> + '_ {
        let here = self.at(time);
        let is_along = here.is_none() && time >= self.from && !self.is_gone(time);
        let before = match time.checked_sub(1) {
            Some(before) => self.at(before),
            None => self.start.transit_from,
        };
        let ends = [before, self.at(time.saturating_add(1))];
        here.into_iter()
            .chain(ends.into_iter().flatten().filter(move |_| is_along))
    }

    pub(super) fn is_in(&self, area: &Area<'_>, time: u32) -> bool {
        self.touches(time).any(|cell| area.has(cell))
    }

    /// The times, each up to another one, at which a rule about a zone does not count it
    /// there: it was there when the rule was added, or a breakdown kept it there, and it has
    /// not left since.
    pub(super) fn uncounted(&self, area: &Area<'_>, judged: &Judged<'_>) -> Vec<(u32, u32)> {
        let begun = self.start.uncounted.contains(&judged.rule.index);
        let begins = judged.since.into_iter().chain(begun.then_some(0));
        let begins = begins.chain(self.breakdowns.iter().copied());
        let spans = begins.filter(|&begin| self.is_in(area, begin));
        let span = |begin: u32| {
            let settled = self.settled().saturating_add(1).max(begin);
            let left = (begin..=settled).find(|&time| !self.is_in(area, time));
            (begin, left.unwrap_or(u32::MAX))
        };
        spans.map(span).collect()
    }
}
