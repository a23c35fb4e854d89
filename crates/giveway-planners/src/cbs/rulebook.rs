//! All that the constraints of a node ask of one agent, ready to be looked up step by step.

use std::collections::{BTreeMap, BTreeSet};

use super::constraint::{Own, Rule};
use crate::{
    AgentId,
    problem::Problem,
    single::{Onward, Place, State},
    terrain::Vertex,
};

/// The rules of one agent in one node of the constraint tree.
#[derive(Default)]
pub(super) struct Rulebook {
    not_at: BTreeSet<(Vertex, u32)>,
    at: BTreeMap<u32, Vertex>,
    not_cross: BTreeSet<(u32, u32)>,
    cross: BTreeMap<u32, u32>,
    closed: BTreeMap<Vertex, u32>,
    after: Option<u32>,
    by: Option<u32>,
    /// Two rules contradict each other.
    contradicts: bool,
}

impl Rulebook {
    pub(super) fn add(&mut self, own: Own) {
        match own {
            Own::Rule(Rule::NotAt { v, time }) => {
                self.not_at.insert((v, time));
            }
            Own::Rule(Rule::At { v, time }) => {
                let before = self.at.insert(time, v);
                self.contradicts |= before.is_some_and(|before| before != v);
            }
            Own::Rule(Rule::NotCross { arc, time }) => {
                self.not_cross.insert((arc, time));
            }
            Own::Rule(Rule::Cross { arc, time }) => {
                let before = self.cross.insert(time, arc);
                self.contradicts |= before.is_some_and(|before| before != arc);
            }
            Own::Rule(Rule::ArriveAfter(time)) => self.after = self.after.max(Some(time)),
            Own::Rule(Rule::ArriveBy(time)) => {
                self.by = Some(self.by.map_or(time, |by| by.min(time)));
            }
            Own::Closed { v, from } => {
                let since = self.closed.entry(v).or_insert(from);
                *since = from.min(*since);
            }
        }
    }

    /// No walk arrives sooner.
    pub(super) fn earliest(&self) -> u32 {
        self.after.map_or(0, |after| after + 1)
    }

    /// No walk may arrive later; `None` where nothing can be kept.
    pub(super) fn latest(&self, horizon: u32) -> Option<u32> {
        let latest = self.by.map_or(horizon, |by| by.min(horizon));
        (!self.contradicts).then_some(latest)
    }

    /// Whether the agent may be at a place at a time.
    pub(super) fn may_be(&self, place: Place, time: u32) -> bool {
        if self.at.get(&time).is_some_and(|&v| place != Place::At(v)) {
            return false;
        }
        match place {
            Place::At(v) => {
                let closed = self.closed.get(&v).is_some_and(|&from| from <= time);
                !closed && !self.not_at.contains(&(v, time))
            }
            Place::Along(_) => true,
        }
    }

    /// Whether it may make a step that begins at a time.
    pub(super) fn may_go(&self, step: &Onward, time: u32) -> bool {
        let demanded = self.cross.get(&time);
        demanded.is_none_or(|&arc| step.arc == Some(arc))
            && step
                .arc
                .is_none_or(|arc| !self.not_cross.contains(&(arc, time)))
            && self.may_be(step.to.place, time + 1)
    }

    /// Whether an agent in a state may end its walk there: its task is done,
    /// and what is asked of later times holds while it rests, or is gone.
    pub(super) fn may_end(
        &self,
        problem: &Problem,
        agent: AgentId,
        state: State,
        time: u32,
    ) -> bool {
        let task = &problem.tasks[agent];
        let Place::At(v) = state.place else {
            return false;
        };
        if !task.may_end(v, state.mask, time) || time < self.earliest() {
            return false;
        }
        let (rests, later) = (problem.rests(agent), time + 1);
        let is_left_alone = || {
            let forbidden = self.not_at.range((v, later)..=(v, u32::MAX));
            forbidden.count() == 0 && !self.closed.contains_key(&v)
        };
        let demanded_there = |(_, &u): (&u32, &Vertex)| rests && u == v;
        (!rests || is_left_alone())
            && self.at.range(later..).all(demanded_there)
            && self.cross.range(time..).next().is_none()
    }
}
