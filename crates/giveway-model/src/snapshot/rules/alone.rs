//! What an agent has done of what it has to do by itself, and what it has paid.

use super::{RestOfRules, Resumed};
use crate::check::{penalty_until, waits_on_end};
use crate::condition::Times;
use crate::constraint::{ConstraintKind, TimedConstraint, meant};
use crate::{Cell, Constraint};

impl<'a> RestOfRules<'a> {
    /// The agents that have still to stay at a cell, by name.
    pub(super) fn still_to_visit(
        &self,
        index: usize,
        (cell, stay, times): (Cell, u32, Times),
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) -> Vec<String> {
        let mut left = Vec::new();
        for &number in bound {
            let Some(resumed) = agents.get_mut(number) else {
                continue;
            };
            let past = resumed.past;
            let run = past.map_or(Some(0), |past| self.stayed(cell, stay, times, &past));
            let Some(run) = run else { continue };
            left.push(resumed.agent.name.clone());
            if run > 0 {
                resumed.state.begun.insert(index, run);
            }
        }
        left
    }

    /// Notes the agents that a rule about arrivals forbids to stay where they have rested.
    pub(super) fn judge_rests(
        &self,
        (index, timed): (usize, &TimedConstraint),
        times: Times,
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) {
        for &number in bound {
            if let Some(Resumed { state, .. }) = agents.get_mut(number) {
                let arrival = self.at - state.rested;
                let is_judged = timed.since.is_none_or(|since| since <= arrival);
                let is_met = meant(times).contains(arrival);
                if state.rested > 0 && is_judged && !is_met {
                    state.must_go_on.push(index);
                }
            }
        }
    }

    /// Notes the waits that agents have just made, as far as a rule counts them.
    pub(super) fn count_waits(
        &self,
        (index, timed): (usize, &TimedConstraint),
        zone: &str,
        bound: &[usize],
        agents: &mut [Resumed<'a>],
    ) {
        for &number in bound {
            if let Some(resumed) = agents.get_mut(number)
                && let Some(past) = resumed.past
                && self.zone_has(zone, resumed.agent.start)
            {
                let since = timed.since.unwrap_or(0);
                let run = waits_on_end(self.past, &past, (since, self.at));
                resumed.state.begun.insert(index, run);
            }
        }
    }

    /// Where an agent faces, and for how long it has stood.
    pub(super) fn turn(&self, resumed: &mut Resumed<'a>) {
        let Some(past) = &resumed.past else { return };
        let last = self.last_move(past);
        if let Some((_, heading)) = last {
            resumed.agent.heading = heading;
        }
        let since = last.map_or(resumed.timeline.from, |(end, _)| end);
        resumed.state.stood = self.at.saturating_sub(since);
    }

    /// What an agent has paid already, and what it pays if it does not stay where it rested.
    pub(super) fn pay(&self, resumed: &mut Resumed<'a>) {
        let name = resumed.timeline.name();
        if resumed.past.is_none() {
            let rules = self.history.constraints().iter();
            let rules = rules.filter(|it| it.is_there(self.at) && !it.constraint.off);
            let late = rules.filter_map(|timed| {
                let Constraint { kind, agents, .. } = &timed.constraint;
                let ConstraintKind::Late { by, weight } = kind else {
                    return None;
                };
                let is_bound = agents
                    .as_ref()
                    .is_none_or(|names| names.iter().any(|it| it == name));
                let from = timed.since.unwrap_or(0).max(*by);
                let late = self.at.saturating_sub(from).saturating_mul(*weight);
                is_bound.then_some(late)
            });
            resumed.running.spent.penalty = late.fold(0, u32::saturating_add);
            return;
        }
        let until = |time| penalty_until(self.past, self.plan, name, time);
        let spent = until(self.at - resumed.state.rested);
        resumed.running.spent.penalty = spent;
        resumed.state.penalty_if_it_goes_on = until(self.at).saturating_sub(spent);
    }
}
