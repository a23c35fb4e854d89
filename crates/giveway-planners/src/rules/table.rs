//! Walks of some agents, indexed by what rules between agents look at.

mod met;

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::condition::Times;

use super::{Shared, SharedKind, touched};
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
