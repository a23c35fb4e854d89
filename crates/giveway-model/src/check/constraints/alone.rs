//! Rules that each agent keeps by itself.

use super::{Area, Broken, Row, Table};
use crate::Cell;
use crate::check::{Step, steps};
use crate::condition::Times;
use crate::constraint::{Heading, meant};

/// A move: the times at which it begins and ends, from where, to where.
type Move = (u32, u32, Cell, Cell);

impl Table<'_> {
    fn moves(&self, row: &Row<'_>) -> Vec<Move> {
        let steps = steps(self.instance.grid(), row.walk.path);
        let moves = steps.filter_map(|(begin, step)| match step {
            Step::Move { from, to } => Some((begin as u32, begin as u32 + 1, from, to)),
            Step::SlowMove { from, to } => Some((begin as u32, begin as u32 + 2, from, to)),
            Step::Wait | Step::Broken { .. } => None,
        });
        let arriving = row.before.zip(row.at(1)).filter(|_| row.at(0).is_none());
        let arriving = arriving.map(|(from, to)| (0, 1, from, to));
        arriving.into_iter().chain(moves).collect()
    }

    /// Agents in a closed zone.
    pub(super) fn entered(
        &self,
        rows: &[Row<'_>],
        area: &Area<'_>,
        times: Times,
        broken: &mut Broken<'_, '_, '_>,
    ) {
        for row in rows {
            for time in times.first()..=meant(times).last().min(self.last) {
                let cells: Vec<Cell> = row.touches(time).filter(|&cell| area.has(cell)).collect();
                if !cells.is_empty() {
                    broken.at(time, &[row.agent], cells);
                }
                if broken.is_full() {
                    return;
                }
            }
        }
    }

    /// Moves against a lane.
    pub(super) fn against(&self, rows: &[Row<'_>], lane: &[Cell], broken: &mut Broken<'_, '_, '_>) {
        for row in rows {
            for (begin, _, from, to) in self.moves(row) {
                if lane.windows(2).any(|pair| pair == [to, from]) {
                    broken.at(begin, &[row.agent], vec![from, to]);
                }
            }
        }
    }

    /// Moves that begin too early.
    pub(super) fn departed(&self, rows: &[Row<'_>], from: u32, broken: &mut Broken<'_, '_, '_>) {
        for row in rows {
            for (begin, _, u, v) in self.moves(row) {
                if begin < from {
                    broken.at(begin, &[row.agent], vec![u, v]);
                }
            }
        }
    }

    /// Waits that are too long.
    pub(super) fn waited(
        &self,
        rows: &[Row<'_>],
        area: &Area<'_>,
        most: u32,
        broken: &mut Broken<'_, '_, '_>,
    ) {
        for row in rows {
            let mut run = 0;
            for (time, step) in steps(self.instance.grid(), row.walk.path) {
                run = if step == Step::Wait { run + 1 } else { 0 };
                let here = row.at(time as u32).filter(|&cell| area.has(cell));
                if let Some(cell) = here
                    && run > most
                {
                    broken.at(time as u32, &[row.agent], vec![cell]);
                }
            }
        }
    }

    /// Moves that begin before the agent has turned.
    pub(super) fn turned(&self, rows: &[Row<'_>], quarter: u32, broken: &mut Broken<'_, '_, '_>) {
        for row in rows {
            let (mut facing, mut since) = (row.walk.agent.heading, 0);
            for (begin, end, from, to) in self.moves(row) {
                let next = Heading::of(from, to);
                let quarters = facing
                    .zip(next)
                    .map_or(0, |(one, next)| one.quarters_to(next));
                if begin.saturating_sub(since) < quarter.saturating_mul(quarters) {
                    broken.at(begin, &[row.agent], vec![from, to]);
                }
                (facing, since) = (next, end);
            }
        }
    }
}

/// Agents that do not visit cells in their order.
pub(super) fn out_of_order(rows: &[Row<'_>], cells: &[Cell], broken: &mut Broken<'_, '_, '_>) {
    for row in rows {
        let arrival = row.walk.arrival() as u32;
        let mut left = cells;
        for time in 0..=arrival {
            while let [next, rest @ ..] = left
                && row.at(time) == Some(*next)
            {
                left = rest;
            }
        }
        if let Some(&missed) = left.first() {
            broken.at(arrival, &[row.agent], vec![missed]);
        }
    }
}

/// Agents that do not arrive within some times.
pub(super) fn arrived(rows: &[Row<'_>], times: Times, broken: &mut Broken<'_, '_, '_>) {
    for row in rows {
        let arrival = row.walk.arrival() as u32;
        if !meant(times).contains(arrival) {
            broken.at(arrival, &[row.agent], Vec::from_iter(row.walk.end()));
        }
    }
}

/// Agents that never stay at a cell for so long within some times.
pub(super) fn not_visited(
    rows: &[Row<'_>],
    cell: Cell,
    (stay, times): (u32, Times),
    broken: &mut Broken<'_, '_, '_>,
) {
    let times = meant(times);
    for row in rows {
        let arrival = row.walk.arrival() as u32;
        // At rest, it is there at all later times.
        let mut since: Option<u32> = None;
        let mut is_met = false;
        for time in times.first()..=arrival.max(times.first()) {
            let is_there = row.at(time) == Some(cell);
            since = since.or(Some(time)).filter(|_| is_there);
            let rests = time >= arrival && row.stays;
            let needed = since.map(|since| since.saturating_add(stay));
            is_met |= needed.is_some_and(|until| until <= times.last() && (until <= time || rests));
        }
        if !is_met {
            broken.at(arrival, &[row.agent], vec![cell]);
        }
    }
}
