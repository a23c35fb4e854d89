//! What agents have done, as far as rules keep others from something for it; and zones that
//! do not count an agent.

use std::collections::BTreeMap;

use super::{RestOfRules, Resumed};
use crate::condition::Visit;
use crate::constraint::{ConstraintKind, TimedConstraint};
use crate::{Cell, ClosedCell};

impl<'a> RestOfRules<'a> {
    /// A precedence whose first agent has vanished: where it never was at its cell, that of
    /// the second is closed for ever.
    pub(super) fn without_first(
        &self,
        index: usize,
        timed: &TimedConstraint,
        agents: &mut [Resumed<'a>],
    ) -> Option<(ConstraintKind, Option<Vec<String>>)> {
        let ConstraintKind::Before { first, second } = &timed.constraint.kind else {
            return None;
        };
        let since = timed.since.unwrap_or(0);
        let mut gone = self.gone.iter();
        let gone = gone.find(|it| it.timeline.name() == first.agent)?;
        let is_bound = timed.is_there(self.at)
            && !timed.constraint.off
            && !gone.is_removed()
            && gone.end() >= since;
        if is_bound && !self.has_been(first.cell, gone) {
            let Visit { agent, cell } = second;
            let mut agents = agents.iter_mut();
            let second = agents.find(|it| it.agent.name == *agent)?;
            second.state.closed_cells.push(ClosedCell {
                cell: *cell,
                until: u32::MAX,
                rule: index,
            });
        }
        None
    }

    /// Closes the cells that agents have just left to the others.
    pub(super) fn close_behind(
        &self,
        (index, timed): (usize, &TimedConstraint),
        steps: u32,
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) {
        let since = timed.since.unwrap_or(0);
        let is_named = |name: &str| {
            let names = timed.constraint.agents.as_ref();
            names.is_none_or(|names| names.iter().any(|it| it == name))
        };
        let there = bound.iter().filter_map(|&number| agents.get(number)?.past);
        let gone = self.gone.iter().copied();
        let gone = gone.filter(|it| is_named(it.timeline.name()) && it.end() >= since);
        // Each cell with those who were there, each with the last time.
        let mut left: BTreeMap<Cell, BTreeMap<String, u32>> = BTreeMap::new();
        for past in there.chain(gone) {
            for time in self.at.saturating_sub(steps)..self.at {
                if let Some(cell) = past.at(time) {
                    let visitors = left.entry(cell).or_default();
                    visitors.insert(past.timeline.name().to_owned(), time);
                }
            }
        }
        for &number in bound {
            let Some(resumed) = agents.get_mut(number) else {
                continue;
            };
            for (&cell, visitors) in &left {
                let others = visitors
                    .iter()
                    .filter(|(name, _)| **name != resumed.agent.name);
                let last = others.map(|(_, &time)| time).max();
                if let Some(until) = last.and_then(|last| (last + steps).checked_sub(self.at)) {
                    resumed.state.closed_cells.push(ClosedCell {
                        cell,
                        until,
                        rule: index,
                    });
                }
            }
        }
    }

    /// Notes the agents that a rule about a zone does not count until they have left it.
    pub(super) fn do_not_count(
        &self,
        (index, timed): (usize, &TimedConstraint),
        zone: &str,
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) {
        for &number in bound {
            let Some(resumed) = agents.get_mut(number) else {
                continue;
            };
            let breakdowns = self.breakdowns(resumed);
            let mut begins = timed.since.into_iter().chain(breakdowns);
            if begins.any(|begin| self.is_kept_in(zone, begin, resumed)) {
                resumed.state.uncounted.push(index);
            }
        }
    }
}
