//! Rules between agents.

use std::collections::BTreeMap;

use super::{Area, Broken, Row, Table};
use crate::Cell;
use crate::condition::Times;
use crate::constraint::meant;
use crate::sorting::sort_by_key;

impl Table<'_> {
    /// The times of a rule that are judged. Once all have settled, times are alike, so the rest
    /// is left out where nothing is broken just after it.
    fn each_time(&self, times: Times, mut is_broken: impl FnMut(u32) -> bool) {
        for time in times.first()..=meant(times).last().min(self.last) {
            if !is_broken(time) && time > self.settled {
                return;
            }
        }
    }

    /// Zones with too many agents.
    pub(super) fn crowded(
        &self,
        rows: &[&Row<'_>],
        area: &Area<'_>,
        (most, times): (u32, Times),
        broken: &mut Broken<'_, '_, '_>,
    ) {
        let uncounted = rows.iter().map(|row| row.uncounted(area, broken.judged));
        let uncounted: Vec<Vec<(u32, u32)>> = uncounted.collect();
        self.each_time(times, |time| {
            let (mut agents, mut cells) = (Vec::new(), Vec::new());
            for (row, uncounted) in rows.iter().zip(&uncounted) {
                if uncounted
                    .iter()
                    .any(|&(from, to)| (from..to).contains(&time))
                {
                    continue;
                }
                let before = cells.len();
                cells.extend(row.touches(time).filter(|&cell| area.has(cell)));
                if cells.len() > before {
                    agents.push(row.agent);
                }
            }
            let is_broken = agents.len() > most as usize;
            if is_broken {
                broken.at(time, &agents, cells);
            }
            is_broken && !broken.is_full()
        });
    }

    /// Agents that come to a cell too soon after others.
    pub(super) fn too_soon(&self, rows: &[&Row<'_>], steps: u32, broken: &mut Broken<'_, '_, '_>) {
        // Each cell with those who were there, each with the last time.
        let mut visitors: BTreeMap<Cell, BTreeMap<usize, u32>> = BTreeMap::new();
        for time in 0..=self.last.min(self.settled.saturating_add(steps)) {
            let here = rows
                .iter()
                .filter_map(|row| Some((row.agent, row.at(time)?)));
            let here: Vec<(usize, Cell)> = here.collect();
            for &(agent, cell) in &here {
                for (&other, &last) in visitors.get(&cell).into_iter().flatten() {
                    if other != agent && last.saturating_add(steps) >= time {
                        broken.at(time, &[other, agent], vec![cell]);
                    }
                }
            }
            if broken.is_full() {
                return;
            }
            for (agent, cell) in here {
                visitors.entry(cell).or_default().insert(agent, time);
            }
        }
    }

    /// Agents that are too near to each other.
    pub(super) fn too_near(
        &self,
        rows: &[&Row<'_>],
        (distance, times): (u32, Times),
        broken: &mut Broken<'_, '_, '_>,
    ) {
        self.each_time(times, |time| {
            let touched = rows
                .iter()
                .flat_map(|row| row.touches(time).map(|cell| (cell, row.agent)));
            let mut touched: Vec<(Cell, usize)> = touched.collect();
            sort_by_key(&mut touched, |&(cell, agent)| (cell.x, cell.y, agent));
            let mut near: BTreeMap<(usize, usize), [Cell; 2]> = BTreeMap::new();
            for (i, &(one, a)) in touched.iter().enumerate() {
                let others = touched.get(i + 1..).unwrap_or_default().iter();
                for &(other, b) in others.take_while(|(other, _)| other.x - one.x < distance) {
                    if a != b && (other.x - one.x) + other.y.abs_diff(one.y) < distance {
                        let (pair, cells) = if a < b {
                            ((a, b), [one, other])
                        } else {
                            ((b, a), [other, one])
                        };
                        near.entry(pair).or_insert(cells);
                    }
                }
            }
            for (&(a, b), &cells) in &near {
                broken.at(time, &[a, b], cells.to_vec());
            }
            !near.is_empty() && !broken.is_full()
        });
    }

    /// An agent that is at its cell before another was at its own.
    pub(super) fn not_before(
        &self,
        (first, at): (&Row<'_>, Cell),
        (second, there): (&Row<'_>, Cell),
        broken: &mut Broken<'_, '_, '_>,
    ) {
        let mut agents = vec![first.agent, second.agent];
        agents.dedup();
        for time in 0..=self.last {
            if second.at(time) == Some(there) {
                broken.at(time, &agents, vec![there]);
            }
            // From the next time on it was there.
            if first.at(time) == Some(at) || broken.is_full() {
                return;
            }
        }
    }
}
