//! Walks that keep rules between agents, as safe intervals ask about them.

use std::cell::OnceCell;

use giveway_model::condition::Times;

use crate::{
    AgentId,
    problem::Problem,
    rules::{RuleTable, SharedKind, near, touched},
    single::Place,
    terrain::Vertex,
    walk::{Walk, arrival},
};

/// The walks of some agents, with how many of them are in zones that have a limit.
pub(super) struct SharedRules<'p> {
    problem: &'p Problem,
    /// By rule; empty where it has no limit.
    zones: Vec<Headcount>,
    /// By agent; empty where it has none.
    walks: Vec<Walk>,
    /// The walks as space-time A* asks about them, from its first question on.
    table: OnceCell<Option<RuleTable<'p>>>,
}

/// How many agents are in a zone.
#[derive(Default)]
struct Headcount {
    /// On their way, by time.
    passing: Vec<u32>,
    /// The times from which on agents rest there, in order.
    resting: Vec<u32>,
}

impl<'p> SharedRules<'p> {
    /// Of nobody; `None` where no rule is between agents.
    pub(super) fn new(problem: &'p Problem) -> Option<Self> {
        let zones = problem.between.rules.iter().map(|_| Headcount::default());
        problem.has_rules_between().then(|| Self {
            problem,
            zones: zones.collect(),
            walks: vec![Walk::new(); problem.agents()],
            table: OnceCell::new(),
        })
    }

    /// Adds the walk of an agent.
    pub(super) fn add(&mut self, agent: AgentId, walk: &[Place]) {
        self.change(agent, walk, true);
        if let Some(known) = self.walks.get_mut(agent) {
            known.extend_from_slice(walk);
        }
        if let Some(Some(table)) = self.table.get_mut() {
            table.add(agent, walk);
        }
    }

    /// Takes away the walk of an agent, as it was added.
    pub(super) fn remove(&mut self, agent: AgentId, walk: &[Place]) {
        self.change(agent, walk, false);
        if let Some(known) = self.walks.get_mut(agent) {
            known.clear();
        }
        if let Some(Some(table)) = self.table.get_mut() {
            table.remove(agent, walk);
        }
    }

    fn change(&mut self, agent: AgentId, walk: &[Place], adds: bool) {
        let problem = self.problem;
        for (rule, zone) in problem.between.rules.iter().zip(&mut self.zones) {
            let area = match &rule.kind {
                SharedKind::Capacity { area, .. } if rule.binds(agent) => area,
                SharedKind::Capacity { .. } | SharedKind::Gap { .. } | SharedKind::Apart { .. } => {
                    continue;
                }
            };
            if zone.passing.len() < walk.len() {
                zone.passing.resize(walk.len(), 0);
            }
            for (&place, count) in walk.iter().zip(&mut zone.passing) {
                if touched(&problem.terrain, place).any(|v| area.has(v)) {
                    *count = if adds {
                        *count + 1
                    } else {
                        count.saturating_sub(1)
                    };
                }
            }
            let end = walk.last().filter(|_| problem.rests(agent));
            if let Some(Place::At(end)) = end
                && area.has(*end)
            {
                let from = arrival(walk) + 1;
                let place = zone.resting.partition_point(|&time| time < from);
                if adds {
                    zone.resting.insert(place, from);
                } else if zone.resting.get(place) == Some(&from) {
                    zone.resting.remove(place);
                }
            }
        }
    }

    /// The spans of time at which so many agents are in the zone of a rule, as far as they
    /// are among some times.
    pub(super) fn full(&self, rule: usize, most: u32, times: Times) -> Vec<(u32, u32)> {
        let Some(zone) = self.zones.get(rule) else {
            return Vec::new();
        };
        let mut spans: Vec<(u32, u32)> = Vec::new();
        let last_change = zone.resting.last().copied().unwrap_or(0) as usize;
        let mut resting = 0;
        // After the last of these times nothing changes.
        for time in 0..=last_change.max(zone.passing.len()) {
            let begun = |&from: &u32| from <= time as u32;
            while zone.resting.get(resting as usize).is_some_and(begun) {
                resting += 1;
            }
            let passing = zone.passing.get(time).copied().unwrap_or(0);
            if passing + resting < most || !times.contains(time as u32) {
                continue;
            }
            match spans.last_mut() {
                Some((_, to)) if *to + 1 == time as u32 => *to += 1,
                _ => spans.push((time as u32, time as u32)),
            }
        }
        let end = last_change.max(zone.passing.len()) as u32;
        if resting >= most && times.last() > end {
            // It stays full, as far as the times go on.
            let from = times.first().max(end);
            match spans.last_mut() {
                Some((_, to)) if *to == end => *to = times.last(),
                _ => spans.push((from, times.last())),
            }
        }
        spans
    }

    /// When an agent must not be at a vertex, because another has not been at one before.
    pub(super) fn before_first_visit(
        &self,
        agent: AgentId,
        v: Vertex,
    ) -> impl Iterator<Item = (u32, u32)> + '_ {
        let orders = self.problem.precedences.iter();
        let orders = orders.filter(move |order| order.second == (agent, v));
        orders.filter_map(|order| {
            let walk = self.walks.get(order.first.0)?;
            let last = first_visit(walk, order.first.1).unwrap_or(u32::MAX);
            (!walk.is_empty()).then_some((0, last))
        })
    }

    /// For each vertex at which an agent has to be before another is somewhere: that
    /// vertex, and when the other is there.
    pub(super) fn visits_due(&self, agent: AgentId) -> impl Iterator<Item = (Vertex, u32)> + '_ {
        let orders = self.problem.precedences.iter();
        let orders = orders.filter(move |order| order.first.0 == agent);
        orders.filter_map(|order| {
            let walk = self.walks.get(order.second.0)?;
            first_visit(walk, order.second.1).map(|time| (order.first.1, time))
        })
    }

    /// The agents with which an agent would break a rule at a vertex at a time; it may have a
    /// walk itself.
    pub(super) fn met(&self, agent: AgentId, time: u32, v: Vertex) -> Vec<AgentId> {
        let mut met = Vec::new();
        let terrain = &self.problem.terrain;
        let rules = self.problem.between.rules.iter();
        for rule in rules.filter(|rule| rule.binds(agent)) {
            let is_other = |other: &AgentId| *other != agent && rule.binds(*other);
            let others = (0..self.walks.len()).filter(is_other);
            match &rule.kind {
                SharedKind::Capacity { area, most, times } => {
                    if times.contains(time) && area.has(v) {
                        let is_inside = |&other: &AgentId| {
                            let place = self.place(other, time);
                            place.is_some_and(|it| touched(terrain, it).any(|v| area.has(v)))
                        };
                        let inside: Vec<AgentId> = others.filter(is_inside).collect();
                        if inside.len() >= *most as usize {
                            met.extend(inside);
                        }
                    }
                }
                SharedKind::Gap { steps } => {
                    let times = time.saturating_sub(*steps)..=time.saturating_add(*steps);
                    met.extend(others.filter(|&other| {
                        times
                            .clone()
                            .any(|time| self.place(other, time) == Some(Place::At(v)))
                    }));
                }
                SharedKind::Apart { distance, times } => {
                    if times.contains(time) {
                        let near: Vec<Vertex> = near(terrain, v, *distance).collect();
                        let is_near = |&other: &AgentId| {
                            let place = self.place(other, time);
                            place.is_some_and(|it| touched(terrain, it).any(|u| near.contains(&u)))
                        };
                        met.extend(others.filter(is_near));
                    }
                }
            }
        }
        met
    }

    /// Where an agent is at a time.
    fn place(&self, agent: AgentId, time: u32) -> Option<Place> {
        let walk = self.walks.get(agent)?;
        let last = walk.last().filter(|_| self.problem.rests(agent));
        walk.get(time as usize).or(last).copied()
    }

    /// The walks as space-time A* asks about them.
    pub(super) fn table(&self) -> Option<&RuleTable<'p>> {
        let table = self.table.get_or_init(|| {
            let mut table = RuleTable::new(self.problem)?;
            for (agent, walk) in self.walks.iter().enumerate() {
                table.add(agent, walk);
            }
            Some(table)
        });
        table.as_ref()
    }
}

/// The first time at which a walk is at a vertex.
fn first_visit(walk: &[Place], v: Vertex) -> Option<u32> {
    let visit = walk.iter().position(|&place| place == Place::At(v));
    visit.map(|time| time as u32)
}
