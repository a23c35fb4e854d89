//! A timetable of walks that do not collide: for each vertex the occupied spans of time, in order.
//!
//! Between the spans are the safe intervals of Phillips and Likhachev, "SIPP: Safe interval path planning for
//! dynamic environments" (2011).

mod rules;

use std::collections::BTreeSet;

use super::{
    OtherAgents, Query,
    safe_interval::{Sipp, is_told},
    shared_rules::SharedRules,
};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::Problem,
    rules::Presence,
    single::{Mask, Place},
    terrain::{Arc, Vertex},
    walk::Walk,
};

/// One agent at one vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) from: u32,
    /// The last time; [`u32::MAX`] where it rests there.
    pub(super) to: u32,
    pub(super) agent: u32,
    /// Where it goes from there, one step later or, along a slow arc, two; its
    /// own vertex where it goes nowhere.
    pub(super) next: Vertex,
}

/// The walks of some agents, none of which collide.
pub struct Timetable<'p> {
    pub(super) problem: &'p Problem,
    pub(super) spans: Vec<Vec<Span>>,
    /// What rules between agents look at, where there are some.
    shared: Option<SharedRules<'p>>,
    sipp: Sipp,
}

impl<'p> Timetable<'p> {
    /// Of nobody; `None` where walks may collide by what is asked for, or begin
    /// half way along an arc, which spans do not tell.
    pub fn new(problem: &'p Problem) -> Option<Self> {
        let fits = problem.relaxed.ignored.is_empty()
            && problem.tasks.iter().all(|task| task.transit.is_none());
        fits.then(|| Self {
            problem,
            spans: vec![Vec::new(); problem.terrain.size()],
            shared: SharedRules::new(problem),
            sipp: Sipp::default(),
        })
    }

    /// Whether all agents are planned by safe intervals.
    pub fn is_quick(problem: &Problem) -> bool {
        let mut tasks = problem.tasks.iter();
        tasks.all(|task| {
            task.is_plain() || problem.is_constrained && is_told(task, &problem.terrain)
        })
    }

    /// Of all agents; `None` where that cannot be told, or two of them are at one
    /// vertex at the same time.
    pub fn of(problem: &'p Problem, walks: &[Walk]) -> Option<Self> {
        let mut all = Self::new(problem)?;
        for (agent, walk) in walks.iter().enumerate() {
            all.add(agent, walk);
        }
        let apart = |pair: &[Span]| pair[0].to < pair[1].from;
        let mut spans = all.spans.iter();
        spans
            .all(|spans| spans.windows(2).all(apart))
            .then_some(all)
    }

    /// The number of spans at a vertex that begin no later than a time.
    fn begun(&self, time: u32, v: Vertex) -> usize {
        let spans = self.spans.get(v as usize).map_or(&[][..], Vec::as_slice);
        spans.partition_point(|span| span.from <= time)
    }

    /// The span in which a vertex is occupied at a time.
    pub(super) fn who(&self, time: u32, v: Vertex) -> Option<Span> {
        let last = self.begun(time, v).checked_sub(1)?;
        let span = self.spans[v as usize][last];
        (span.to >= time).then_some(span)
    }

    /// The span of an agent that crosses from `v` to `u` in the step from a time; a slow arc takes two steps.
    #[inline]
    pub(super) fn crosses(&self, time: u32, (v, u): (Vertex, Vertex), slow: bool) -> Option<Span> {
        let begun = self.begun(time, v);
        let spans = self.spans.get(v as usize)?;
        let earliest = time.saturating_sub(u32::from(slow));
        let left = spans[..begun].iter().rev();
        left.take_while(|span| span.to >= earliest)
            .find(|span| span.to <= time && span.next == u)
            .copied()
    }

    /// Whether somebody comes the other way, if an agent leaves `u` at a time.
    #[inline]
    pub(super) fn is_swap(&self, leaving: u32, u: Vertex, arc: Arc) -> bool {
        let opposite = (arc.to, u);
        let against = |time| self.crosses(time, opposite, arc.slow).is_some();
        against(leaving) || arc.slow && against(leaving + 1)
    }

    /// The spans of a walk, each with its vertex.
    fn spans_of(&self, agent: AgentId, walk: &[Place], mut each: impl FnMut(Vertex, Span)) {
        let mut at: Option<(Vertex, u32)> = None;
        let mut last = 0;
        for (time, place) in (0..).zip(walk) {
            let Place::At(v) = *place else { continue };
            match at {
                Some((u, _)) if u == v => {}
                before => {
                    if let Some((u, from)) = before {
                        let agent = agent as u32;
                        let (to, next) = (last, v);
                        each(
                            u,
                            Span {
                                from,
                                to,
                                agent,
                                next,
                            },
                        );
                    }
                    at = Some((v, time));
                }
            }
            last = time;
        }
        if let Some((v, from)) = at {
            let to = if self.problem.rests(agent) {
                u32::MAX
            } else {
                last
            };
            let agent = agent as u32;
            each(
                v,
                Span {
                    from,
                    to,
                    agent,
                    next: v,
                },
            );
        }
    }
}

impl OtherAgents for Timetable<'_> {
    fn problem(&self) -> &Problem {
        self.problem
    }

    fn add(&mut self, agent: AgentId, walk: &[Place]) {
        if let Some(shared) = &mut self.shared {
            shared.add(agent, walk);
        }
        let mut all = std::mem::take(&mut self.spans);
        self.spans_of(agent, walk, |v, span| {
            let spans = &mut all[v as usize];
            let place = spans.partition_point(|other| other.from < span.from);
            spans.insert(place, span);
        });
        self.spans = all;
    }

    fn remove(&mut self, agent: AgentId, walk: &[Place]) {
        if let Some(shared) = &mut self.shared {
            shared.remove(agent, walk);
        }
        let mut all = std::mem::take(&mut self.spans);
        self.spans_of(agent, walk, |v, span| {
            let spans = &mut all[v as usize];
            let place = spans.partition_point(|other| other.from < span.from);
            if spans.get(place) == Some(&span) {
                spans.remove(place);
            }
        });
        self.spans = all;
    }

    fn at(&self, time: u32, v: Vertex) -> impl Iterator<Item = AgentId> + '_ {
        self.who(time, v)
            .map(|span| span.agent as AgentId)
            .into_iter()
    }

    fn against(&self, time: u32, arc: u32) -> impl Iterator<Item = AgentId> + '_ {
        let (u, v) = self.problem.terrain.ends(arc);
        let arcs = self.problem.terrain.arcs(u).iter();
        let slow = arcs.clone().any(|arc| arc.to == v && arc.slow);
        let span = self.crosses(time, (v, u), slow);
        span.map(|span| span.agent as AgentId).into_iter()
    }

    fn after(&self, time: u32, v: Vertex) -> impl Iterator<Item = AgentId> + '_ {
        let spans = self.spans.get(v as usize).map_or(&[][..], Vec::as_slice);
        let over = spans.partition_point(|span| span.to <= time);
        spans[over..].iter().map(|span| span.agent as AgentId)
    }

    fn last_visit(&self, goal: Vertex) -> Option<u32> {
        let spans = self.spans.get(goal as usize)?;
        let last = spans.iter().rev().find(|span| span.to < u32::MAX)?;
        Some(last.to)
    }

    fn visitors(&self, v: Vertex) -> Vec<AgentId> {
        let spans = self.spans.get(v as usize).into_iter().flatten();
        spans.map(|span| span.agent as AgentId).collect()
    }

    fn kept_away_by(&self, agent: AgentId, time: u32, v: Vertex) -> Vec<AgentId> {
        let shared = self.shared.as_ref();
        shared.map_or_else(Vec::new, |shared| shared.met(agent, time, v))
    }

    fn met_by_rules(&self, here: Presence) -> Vec<AgentId> {
        let table = self.shared.as_ref().and_then(SharedRules::table);
        table.map_or_else(Vec::new, |table| table.met(here))
    }

    fn met_after_end(&self, agent: AgentId, v: Vertex, time: u32, mask: Mask) -> Vec<AgentId> {
        let table = self.shared.as_ref().and_then(SharedRules::table);
        table.map_or_else(Vec::new, |table| table.met_after_end(agent, v, time, mask))
    }

    fn met_by_rules_on(&self, agent: AgentId, walk: &[Place]) -> BTreeSet<AgentId> {
        let table = self.shared.as_ref().and_then(SharedRules::table);
        table.map_or_else(BTreeSet::new, |table| table.met_by(agent, walk))
    }

    fn plan(&mut self, query: Query, budget: &dyn Budget) -> Result<Option<(Walk, u32)>, Stop> {
        let problem = self.problem;
        let task = &problem.tasks[query.agent];
        let is_plain = task.is_plain() && !problem.has_rules_between_with(query.agent);
        let is_ruled = !is_plain && problem.is_constrained && is_told(task, &problem.terrain);
        if query.conflict_penalty.is_some() || !is_plain && !is_ruled {
            return super::plan_one(problem, self, query, budget);
        }
        let mut sipp = std::mem::take(&mut self.sipp);
        let found = if is_plain {
            sipp.plain(self, query, budget)
        } else {
            sipp.ruled(self, query, budget)
        };
        self.sipp = sipp;
        Ok(found?.map(|walk| (walk, 0)))
    }
}
