//! Whom an agent meets: those with whom a presence breaks a rule.

use std::collections::BTreeSet;

use giveway_model::sorting::sort;

use super::{FirstVisit, Presence, RuleTable, later};
use crate::{
    AgentId,
    rules::{Shared, SharedKind, between::near, touched},
    single::{Mask, Place},
    terrain::Vertex,
    walk::arrival,
};

impl RuleTable<'_> {
    /// The agents that an agent must not be there with.
    pub fn met(&self, here: Presence) -> Vec<AgentId> {
        let mut met = Vec::new();
        for (number, rule) in self.problem.between.rules.iter().enumerate() {
            if rule.binds(here.agent) {
                self.met_by_rule(number, rule, here, &mut met);
            }
        }
        self.out_of_order(here, &mut met);
        sort(&mut met);
        met.dedup();
        met
    }

    fn met_by_rule(&self, number: usize, rule: &Shared, here: Presence, met: &mut Vec<AgentId>) {
        let Presence {
            agent,
            time,
            place,
            before,
        } = here;
        let terrain = &self.problem.terrain;
        let is_other = |other: &AgentId| *other != agent && rule.binds(*other);
        match &rule.kind {
            SharedKind::Capacity { area, most, times } => {
                if times.contains(time)
                    && touched(terrain, place).any(|v| area.has(v))
                    && !self.is_uncounted(rule, agent, before)
                {
                    let inside = self.zones[number].at(time).filter(is_other);
                    let inside: Vec<AgentId> = inside.collect();
                    if inside.len() >= *most as usize {
                        met.extend(inside);
                    }
                }
            }
            SharedKind::Gap { steps } => {
                let Place::At(v) = place else { return };
                let (first, last) = (time.saturating_sub(*steps), time.saturating_add(*steps));
                let visits = self.visits.get(&v).into_iter();
                let visits = visits.flat_map(|visits| {
                    visits.range((first, 0, false)..=(last, AgentId::MAX, true))
                });
                let visits = visits.filter(|(_, _, is_at)| *is_at).map(|&(_, it, _)| it);
                met.extend(visits.filter(is_other));
                let rests = self.rests.get(&v).into_iter().flatten();
                let rests = rests.filter(|(from, _)| *from <= last).map(|&(_, it)| it);
                met.extend(rests.filter(is_other));
            }
            SharedKind::Apart { distance, times } => {
                if times.contains(time) {
                    for v in touched(terrain, place) {
                        for u in near(terrain, v, *distance) {
                            met.extend(self.touching(u, time).filter(is_other));
                        }
                    }
                }
            }
        }
    }

    /// The agents at a vertex, or in transit to or from it, at a time.
    fn touching(&self, v: Vertex, time: u32) -> impl Iterator<Item = AgentId> + '_ {
        let visits = self.visits.get(&v).into_iter();
        let passing = visits
            .flat_map(move |visits| visits.range((time, 0, false)..=(time, AgentId::MAX, true)));
        let rests = self.rests.get(&v).into_iter().flatten();
        let resting = rests.filter(move |(from, _)| *from <= time);
        passing
            .map(|&(_, agent, _)| agent)
            .chain(resting.map(|&(_, agent)| agent))
    }

    /// The other agents of precedences that are not kept.
    fn out_of_order(&self, here: Presence, met: &mut Vec<AgentId>) {
        let orders = self.problem.precedences.iter().zip(&self.firsts);
        for (precedence, first) in orders {
            let (one, other) = (precedence.first, precedence.second);
            if other.0 == here.agent && here.place == Place::At(other.1) {
                let is_too_soon = match *first {
                    FirstVisit::Unknown => false,
                    FirstVisit::At(time) => time >= here.time,
                    FirstVisit::Never => true,
                };
                met.extend(is_too_soon.then_some(one.0));
            }
            if one.0 == here.agent {
                let task = &self.problem.tasks[one.0];
                let has_been = here.time > 0 && task.has_been(here.before, one.1);
                let is_there = |agent: &AgentId| *agent == other.0;
                let mut there = self.standing(other.1, here.time);
                if !has_been && there.any(|agent| is_there(&agent)) {
                    met.push(other.0);
                }
            }
        }
    }

    fn standing(&self, v: Vertex, time: u32) -> impl Iterator<Item = AgentId> + '_ {
        let visits = self.visits.get(&v).into_iter();
        let passing = visits
            .flat_map(move |visits| visits.range((time, 0, false)..=(time, AgentId::MAX, true)));
        let passing = passing.filter(|(_, _, is_at)| *is_at);
        let rests = self.rests.get(&v).into_iter().flatten();
        let resting = rests.filter(move |(from, _)| *from <= time);
        passing
            .map(|&(_, agent, _)| agent)
            .chain(resting.map(|&(_, agent)| agent))
    }

    /// The agents with which an agent breaks a rule after its walk has ended at a vertex at a
    /// time: it rests there, or is gone. `mask` is how far it has come.
    pub fn met_after_end(&self, agent: AgentId, v: Vertex, time: u32, mask: Mask) -> Vec<AgentId> {
        let mut met = Vec::new();
        for (number, rule) in self.problem.between.rules.iter().enumerate() {
            if !rule.binds(agent) || !self.problem.rests(agent) {
                continue;
            }
            let is_other = |other: &AgentId| *other != agent && rule.binds(*other);
            match &rule.kind {
                SharedKind::Capacity { area, most, times }
                    if area.has(v) && !self.is_uncounted(rule, agent, mask) =>
                {
                    let zone = &self.zones[number];
                    for at in later(zone.changes_after(time + 1), time + 1, *times) {
                        let inside: Vec<AgentId> = zone.at(at).filter(is_other).collect();
                        if inside.len() >= *most as usize {
                            met.extend(inside);
                        }
                    }
                }
                SharedKind::Apart { distance, times } => {
                    let from = times.first().max(time + 1);
                    for u in near(&self.problem.terrain, v, *distance) {
                        let visits = self.visits.get(&u).into_iter().flatten();
                        let visits = visits.filter(|(at, ..)| from <= *at && times.contains(*at));
                        let rests = self.rests.get(&u).into_iter().flatten();
                        let rests = rests.filter(|(at, _)| from.max(*at) <= times.last());
                        let all = visits.map(|&(_, other, _)| other);
                        met.extend(all.chain(rests.map(|&(_, other)| other)).filter(is_other));
                    }
                }
                // Who comes to where another rests collides with it.
                SharedKind::Capacity { .. } | SharedKind::Gap { .. } => {}
            }
        }
        for precedence in &self.problem.precedences {
            let (one, other) = (precedence.first, precedence.second);
            if one.0 == agent && !self.problem.tasks[agent].has_been(mask, one.1) {
                let visits = self.visits.get(&other.1).into_iter().flatten();
                let later = visits.filter(|&&(at, it, is_at)| at > time && it == other.0 && is_at);
                let rests = self.rests.get(&other.1).into_iter().flatten();
                let rests = rests.filter(|&&(_, it)| it == other.0);
                met.extend(later.map(|&(_, it, _)| it).chain(rests.map(|&(_, it)| it)));
            }
        }
        sort(&mut met);
        met.dedup();
        met
    }

    /// The agents that a walk of an agent breaks a rule with.
    pub fn met_by(&self, agent: AgentId, walk: &[Place]) -> BTreeSet<AgentId> {
        let mut met = BTreeSet::new();
        let masks = self.problem.masks_of(agent, walk);
        let before = std::iter::once(&0).chain(&masks);
        for ((&place, time), &before) in walk.iter().zip(0..).zip(before) {
            met.extend(self.met(Presence {
                agent,
                time,
                place,
                before,
            }));
        }
        if let Some(&Place::At(end)) = walk.last()
            && let Some(&mask) = masks.last()
        {
            met.extend(self.met_after_end(agent, end, arrival(walk), mask));
        }
        met
    }
}
