//! Walks of some agents, indexed by what rules between agents look at.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{condition::Times, sorting::sort};

use super::{Shared, SharedKind, between::near, touched};
use crate::{
    AgentId,
    problem::Problem,
    single::{Area, Mask, Place},
    terrain::Vertex,
    walk::arrival,
};

/// Walks as rules between agents see them.
pub struct RuleTable<'p> {
    problem: &'p Problem,
    /// By vertex: when agents are at it, or in transit over an edge that ends there
    /// (false).
    visits: BTreeMap<Vertex, BTreeSet<(u32, AgentId, bool)>>,
    /// By vertex: the agents that rest there, and from which time on.
    rests: BTreeMap<Vertex, Vec<(u32, AgentId)>>,
    /// By rule with a limit: the agents in its area, by time and at rest.
    zones: Vec<Zone>,
    /// By precedence: when the first agent is at its vertex for the first time.
    firsts: Vec<FirstVisit>,
}

/// When the first agent of a precedence is at its vertex.
#[derive(Clone, Copy)]
enum FirstVisit {
    /// The agent is not in the table.
    Unknown,
    /// At this time.
    At(u32),
    /// At no time.
    Never,
}

/// The agents in an area.
#[derive(Default)]
struct Zone {
    passing: BTreeMap<u32, BTreeSet<AgentId>>,
    resting: BTreeSet<(u32, AgentId)>,
}

impl Zone {
    /// The agents in it at a time.
    fn at(&self, time: u32) -> impl Iterator<Item = AgentId> + '_ {
        let passing = self.passing.get(&time).into_iter().flatten().copied();
        let resting = self.resting.range(..=(time, AgentId::MAX));
        passing.chain(resting.map(|&(_, agent)| agent))
    }

    /// The times from one on at which somebody comes to it.
    fn changes_after(&self, time: u32) -> impl Iterator<Item = u32> + '_ {
        let passing = self.passing.range(time..).map(|(&at, _)| at);
        let resting = self.resting.range((time, 0)..).map(|&(from, _)| from);
        passing.chain(resting)
    }
}

/// Where an agent is at a time, as rules see it.
#[derive(Clone, Copy, Debug)]
pub struct Presence {
    /// The agent.
    pub agent: AgentId,
    /// When.
    pub time: u32,
    /// Where.
    pub place: Place,
    /// How far it had come the time before; 0 at time 0.
    pub before: Mask,
}

impl<'p> RuleTable<'p> {
    /// Of nobody; `None` where no rule is between agents.
    pub fn new(problem: &'p Problem) -> Option<Self> {
        let rules = &problem.between.rules;
        let any = !rules.is_empty() || !problem.precedences.is_empty();
        any.then(|| Self {
            problem,
            visits: BTreeMap::new(),
            rests: BTreeMap::new(),
            zones: rules.iter().map(|_| Zone::default()).collect(),
            firsts: vec![FirstVisit::Unknown; problem.precedences.len()],
        })
    }

    /// Adds the walk of an agent.
    pub fn add(&mut self, agent: AgentId, walk: &[Place]) {
        self.change(agent, walk, true);
    }

    /// Takes away the walk of an agent, as it was added.
    pub fn remove(&mut self, agent: AgentId, walk: &[Place]) {
        self.change(agent, walk, false);
    }

    fn change(&mut self, agent: AgentId, walk: &[Place], adds: bool) {
        let problem = self.problem;
        let rules = problem.between.rules.iter();
        let counted: Vec<usize> = rules
            .map(|rule| self.counted_from(rule, agent, walk))
            .collect();
        for (&place, time) in walk.iter().zip(0..) {
            let is_at = matches!(place, Place::At(_));
            for v in touched(&problem.terrain, place) {
                put(
                    self.visits.entry(v).or_default(),
                    (time, agent, is_at),
                    adds,
                );
            }
            let rules = problem.between.rules.iter().zip(&counted);
            for ((rule, &counted), zone) in rules.zip(&mut self.zones) {
                if let Some(area) = limited(rule, agent)
                    && counted <= time as usize
                    && touched(&problem.terrain, place).any(|v| area.has(v))
                {
                    let passing = zone.passing.entry(time).or_default();
                    put(passing, agent, adds);
                    if passing.is_empty() {
                        zone.passing.remove(&time);
                    }
                }
            }
        }
        let resting = walk.last().filter(|_| problem.rests(agent));
        if let Some(&Place::At(end)) = resting {
            let from = arrival(walk) + 1;
            let rests = self.rests.entry(end).or_default();
            if adds {
                rests.push((from, agent));
            } else {
                rests.retain(|&(_, other)| other != agent);
            }
            let rules = problem.between.rules.iter().zip(&counted);
            for ((rule, &counted), zone) in rules.zip(&mut self.zones) {
                let has_left = counted < walk.len();
                if has_left && limited(rule, agent).is_some_and(|area| area.has(end)) {
                    put(&mut zone.resting, (from, agent), adds);
                }
            }
        }
        for (precedence, first) in problem.precedences.iter().zip(&mut self.firsts) {
            if precedence.first.0 == agent && !walk.is_empty() {
                let at = Place::At(precedence.first.1);
                let visit = walk.iter().zip(0..).find(|&(&place, _)| place == at);
                *first = match visit {
                    _ if !adds => FirstVisit::Unknown,
                    Some((_, time)) => FirstVisit::At(time),
                    None => FirstVisit::Never,
                };
            }
        }
    }

    /// The time from which on a rule with a limit counts an agent: before, it has not left
    /// the area in which it was at first.
    fn counted_from(&self, rule: &Shared, agent: AgentId, walk: &[Place]) -> usize {
        match limited(rule, agent) {
            Some(area) if rule.begins_uncounted(agent) => {
                let is_outside = |&place: &Place| {
                    let mut touched = touched(&self.problem.terrain, place);
                    !touched.any(|v| area.has(v))
                };
                walk.iter().position(is_outside).unwrap_or(walk.len())
            }
            _ => 0,
        }
    }

    /// Whether a rule does not count an agent that has been in its area at all times up to
    /// one, when its mask was this.
    fn is_uncounted(&self, rule: &Shared, agent: AgentId, mask: Mask) -> bool {
        let task = &self.problem.tasks[agent];
        rule.begins_uncounted(agent) && task.is_uncounted(mask, rule.index)
    }

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

/// The area that a rule limits the number of agents in, if it binds the agent.
fn limited(rule: &Shared, agent: AgentId) -> Option<&Area> {
    match &rule.kind {
        SharedKind::Capacity { area, .. } if rule.binds(agent) => Some(area),
        SharedKind::Capacity { .. } | SharedKind::Gap { .. } | SharedKind::Apart { .. } => None,
    }
}

/// Some times, and the first one from a time on, as far as they are those of a rule.
fn later(changes: impl Iterator<Item = u32>, time: u32, times: Times) -> impl Iterator<Item = u32> {
    let first = times.first().max(time);
    std::iter::once(first)
        .chain(changes)
        .filter(move |&at| at >= first && times.contains(at))
}

/// Puts something into a set, or takes it out.
fn put<T: Ord>(set: &mut BTreeSet<T>, one: T, adds: bool) {
    if adds {
        set.insert(one);
    } else {
        set.remove(&one);
    }
}
