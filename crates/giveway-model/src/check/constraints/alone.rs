//! Rules that each agent keeps by itself.

use super::row::Wait;
use super::{Area, Broken, Row, Table};
use crate::Cell;
use crate::condition::Times;
use crate::constraint::{Heading, meant};

impl Table<'_> {
    /// Agents in a closed zone.
    pub(super) fn entered(
        &self,
        rows: &[&Row<'_>],
        area: &Area<'_>,
        times: Times,
        broken: &mut Broken<'_, '_, '_>,
    ) {
        for row in rows {
            let uncounted = row.uncounted(area, broken.judged);
            for time in times.first()..=meant(times).last().min(self.last) {
                if uncounted
                    .iter()
                    .any(|&(from, to)| (from..to).contains(&time))
                {
                    continue;
                }
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
}

/// Moves against a lane.
pub(super) fn against(rows: &[&Row<'_>], lane: &[Cell], broken: &mut Broken<'_, '_, '_>) {
    for row in rows {
        for it in row.moves.iter().filter(|it| !it.is_under_way) {
            if lane.windows(2).any(|pair| pair == [it.to, it.from]) {
                broken.at(it.begin, &[row.agent], vec![it.from, it.to]);
            }
        }
    }
}

/// Moves that begin too early.
pub(super) fn departed(rows: &[&Row<'_>], from: u32, broken: &mut Broken<'_, '_, '_>) {
    for row in rows {
        for it in row
            .moves
            .iter()
            .filter(|it| it.begin < from && !it.is_under_way)
        {
            broken.at(it.begin, &[row.agent], vec![it.from, it.to]);
        }
    }
}

/// Waits that are too long. Those of a breakdown do not count, nor those before the rule
/// was added; what an agent sleeps through is no wait, and ends a row of them.
pub(super) fn waited(
    rows: &[&Row<'_>],
    area: &Area<'_>,
    most: u32,
    broken: &mut Broken<'_, '_, '_>,
) {
    let since = broken.judged.since.unwrap_or(0);
    let index = broken.judged.rule.index;
    for row in rows {
        let (mut run, mut next) = (row.start.begun(index), 0);
        for &Wait { time, is_held } in &row.waits {
            if time != next {
                run = 0;
            }
            next = time + 1;
            if is_held || time < since {
                continue;
            }
            run += 1;
            let here = row.at(time).filter(|&cell| area.has(cell));
            if let Some(cell) = here
                && run > most
            {
                broken.at(time, &[row.agent], vec![cell]);
            }
        }
    }
}

/// Moves that begin before the agent has turned.
pub(super) fn turned(rows: &[&Row<'_>], quarter: u32, broken: &mut Broken<'_, '_, '_>) {
    for row in rows {
        // For how long it has stood at the time of its first entry.
        let (mut facing, mut since) = (row.heading, row.from);
        let mut stood = row.start.stood;
        for it in &row.moves {
            let next = Heading::of(it.from, it.to);
            let quarters = facing
                .zip(next)
                .map_or(0, |(one, next)| one.quarters_to(next));
            let stands = it.begin.saturating_sub(since).saturating_add(stood);
            if stands < quarter.saturating_mul(quarters) {
                broken.at(it.begin, &[row.agent], vec![it.from, it.to]);
            }
            (facing, since, stood) = (next, it.end, 0);
        }
    }
}

/// Agents that do not visit cells in their order.
pub(super) fn out_of_order(rows: &[&Row<'_>], cells: &[Cell], broken: &mut Broken<'_, '_, '_>) {
    for row in rows.iter().filter(|row| !row.is_removed) {
        let mut left = cells;
        for time in row.from..=row.arrival {
            while let [next, rest @ ..] = left
                && row.at(time) == Some(*next)
            {
                left = rest;
            }
        }
        if let Some(&missed) = left.first() {
            broken.never_done(row, missed);
        }
    }
}

/// Agents that do not arrive within some times.
pub(super) fn arrived(rows: &[&Row<'_>], times: Times, broken: &mut Broken<'_, '_, '_>) {
    for row in rows.iter().filter(|row| !row.is_removed) {
        // One that stays where it rested arrived before the table begins.
        let is_met = if row.arrival == 0 && row.start.rested > 0 {
            !row.start.must_go_on.contains(&broken.judged.rule.index)
        } else {
            // One that came too early may go on once the rule is gone.
            let times = meant(times);
            let is_early = row.arrival < times.first() && row.arrival <= times.last();
            times.contains(row.arrival) || is_early && !broken.is_settled(row)
        };
        if !is_met {
            let end = row.at(row.arrival);
            broken.at(row.arrival, &[row.agent], Vec::from_iter(end));
        }
    }
}

/// Agents that never stay at a cell for so long within some times.
pub(super) fn not_visited(
    rows: &[&Row<'_>],
    cell: Cell,
    (stay, times): (u32, Times),
    broken: &mut Broken<'_, '_, '_>,
) {
    let times = meant(times);
    let index = broken.judged.rule.index;
    for row in rows.iter().filter(|row| !row.is_removed) {
        // The times on end at the cell; at rest, it is there at all later times.
        let mut run = row.start.begun(index);
        let mut is_met = false;
        for time in times.first()..=row.arrival.max(times.first()) {
            run = if row.at(time) == Some(cell) {
                run + 1
            } else {
                0
            };
            let rests = time >= row.arrival && row.stays();
            let needed = stay.saturating_add(1).saturating_sub(run);
            let until = time.saturating_add(needed);
            is_met |= run > 0 && until <= times.last() && (needed == 0 || rests);
        }
        if !is_met {
            broken.never_done(row, cell);
        }
    }
}
