//! Rules that an agent keeps by itself, as parts of its task.

use giveway_model::{
    Cell,
    condition::Times,
    constraint::{ConstraintKind, InForce, meant},
    sorting::sort,
};

use super::{OwnRules, past::left};
use crate::{
    AgentId,
    single::{
        Act, Area, Counter, Entry, Forbidden, LongWait, MAX_WAYPOINTS, NoPlanAlone, Penalty, Stay,
        Task, Turns, has_to_be_at,
    },
    terrain::{Arc, Terrain, Vertex},
};

impl OwnRules<'_> {
    pub(super) fn impose_one(
        &self,
        rule: &InForce<'_>,
        agent: AgentId,
        task: &mut Task,
        terrain: &Terrain,
    ) -> Result<(), NoPlanAlone> {
        let rests = self.rests(agent);
        let state = self.state(agent);
        match &rule.constraint.kind {
            ConstraintKind::Capacity {
                zone,
                most: 0,
                times,
            }
            | ConstraintKind::Closed { zone, times } => {
                let (area, times) = (self.area(zone), meant(*times));
                if state.uncounted.contains(&rule.index) {
                    let closed = Some(times);
                    task.conditions
                        .counters
                        .push(left(rule, area, (closed, rests), terrain));
                } else {
                    close(task, terrain, &area, (times, rests));
                }
            }
            ConstraintKind::OneWay { lane } => {
                let back = lane.windows(2).filter_map(|pair| match *pair {
                    [to, from] => Some(arc(terrain, from, to)?.id),
                    _ => None,
                });
                forbid(task, Act::Cross(sorted(back)), Times::default());
            }
            ConstraintKind::Sequence { cells, .. } => {
                let stops = cells.iter().map(|&cell| has_to_be_at(cell, terrain));
                let stops: Vec<Vertex> = stops.collect::<Result<_, _>>()?;
                for &stop in &stops {
                    visit(task, stop);
                }
                task.conditions.counters.push(Counter::Sequence(stops));
            }
            ConstraintKind::Visit { cell, stay, times } => {
                let at = has_to_be_at(*cell, terrain)?;
                visit(task, at);
                task.conditions.counters.push(Counter::Stay(Stay {
                    at,
                    steps: *stay,
                    times: meant(*times),
                    rests: rests && task.may_rest_at(at),
                    begun: state.begun(rule.index).min(*stay),
                }));
            }
            ConstraintKind::Arrive { times } => self.arrive(rule.index, agent, meant(*times), task),
            ConstraintKind::Depart { from } => {
                task.earliest_move = task.earliest_move.max(*from);
            }
            ConstraintKind::Before { first, second } => {
                let (one, other) = (self.number(&first.agent), self.number(&second.agent));
                let at = terrain.vertex(first.cell);
                match (at, terrain.vertex(second.cell)) {
                    (Some(at), Some(there)) if one == other => {
                        task.conditions.counters.push(Counter::Order(at, there));
                    }
                    (Some(at), _) if one == Some(agent) => {
                        task.conditions.counters.push(Counter::Visited(at));
                    }
                    // The first is never there, so the second must not be.
                    (None, Some(there)) if other == Some(agent) => {
                        close(task, terrain, &Area::One(there), (Times::default(), rests));
                    }
                    _ => {}
                }
            }
            ConstraintKind::NoWaiting { zone, most } => {
                task.conditions.counters.push(Counter::LongWait(LongWait {
                    at: Some(self.area(zone)),
                    times: Times::default(),
                    steps: most.saturating_add(1),
                    begun: state.begun(rule.index).min(*most),
                    held: state.not_before(),
                }));
            }
            ConstraintKind::Turns { quarter } => self.turn(agent, task, *quarter),
            ConstraintKind::Late { by, weight } => task.penalties.push(Penalty::Late {
                by: *by,
                weight: *weight,
            }),
            ConstraintKind::Avoid { zone, weight } => {
                let penalty = Penalty::Avoid(self.area(zone), *weight);
                task.penalties.push(penalty);
            }
            // Between agents.
            ConstraintKind::Capacity { zone, .. } if state.uncounted.contains(&rule.index) => {
                let area = self.area(zone);
                task.conditions
                    .counters
                    .push(left(rule, area, (None, rests), terrain));
            }
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Gap { .. }
            | ConstraintKind::Apart { .. } => {}
        }
        Ok(())
    }

    /// Whether an agent stays where it arrives.
    pub(super) fn rests(&self, agent: AgentId) -> bool {
        let agents = self.instance.agents();
        let agent = agents.get(agent);
        agent.is_some_and(|agent| self.instance.keeps(agent))
    }

    /// Turns by one rule keep those by another of fewer steps.
    fn turn(&self, agent: AgentId, task: &mut Task, quarter: u32) {
        for counter in &mut task.conditions.counters {
            if let Counter::Turns(turns) = counter {
                turns.quarter = turns.quarter.max(quarter);
                return;
            }
        }
        let begun = self.state(agent).stood;
        let agent = self.instance.agents().get(agent);
        let heading = agent.and_then(|agent| agent.heading);
        let turns = Turns {
            quarter,
            heading,
            begun,
        };
        task.conditions.counters.push(Counter::Turns(turns));
    }

    /// Where an agent vanishes, what it does at its goal it does before it enters it for
    /// the last time.
    pub(super) fn ask_for_entry(&self, agent: AgentId, task: &mut Task) {
        let counters = &task.conditions.counters;
        let stays_there = |counter: &Counter| match counter {
            Counter::Stay(stay) => {
                (stay.steps > 0 || stay.times.first() > 0) && task.may_rest_at(stay.at)
            }
            Counter::LongWait(_)
            | Counter::Sequence(_)
            | Counter::Turns(_)
            | Counter::Entry(_)
            | Counter::Visited(_)
            | Counter::Order(..)
            | Counter::Left(_) => false,
        };
        let has_entry = |counter: &Counter| matches!(counter, Counter::Entry(_));
        if !self.rests(agent) && counters.iter().any(stays_there) && !counters.iter().any(has_entry)
        {
            task.conditions.counters.push(Counter::Entry(Entry {
                from: 0,
                stood: false,
                may_stay: false,
            }));
        }
    }
}

/// Notes that an agent has to be at a vertex, as far as tables can bear it.
fn visit(task: &mut Task, v: Vertex) {
    if task.waypoints.len() < MAX_WAYPOINTS {
        task.visit(v);
    }
}

/// Keeps an agent away from the vertices of an area at some times, in transit not.
pub(super) fn keep_off(
    task: &mut Task,
    terrain: &Terrain,
    area: &Area,
    (times, rests): (Times, bool),
) {
    // At rest it would be there at the later of these times.
    let last = times.last();
    if rests && last < u32::MAX {
        match task.goal {
            Some(goal) if area.has(goal) => {
                task.not_before = task.not_before.max(last.saturating_add(1));
            }
            Some(_) => {}
            None => {
                let vertices = (0..terrain.size() as Vertex).filter(|&v| area.has(v));
                task.not_resting.extend(vertices.map(|v| (v, last)));
            }
        }
    } else if rests && task.goal.is_none() {
        // (Of later times it is never there.)
        let vertices = (0..terrain.size() as Vertex).filter(|&v| area.has(v));
        let from = times.first();
        task.not_resting
            .extend(vertices.filter(|_| from > 0).map(|v| (v, u32::MAX)));
    } else if rests && task.goal.is_some_and(|goal| area.has(goal)) {
        task.not_before = u32::MAX;
    }
    forbid(task, Act::Stand(area.clone()), times);
}

/// Keeps an agent out of an area at some times.
fn close(task: &mut Task, terrain: &Terrain, area: &Area, (times, rests): (Times, bool)) {
    keep_off(task, terrain, area, (times, rests));
    // Half way along a slow arc it is at both ends: a step after it began to cross.
    let arcs = slow_arcs(terrain, area);
    let to = times.to.map(|to| to.checked_sub(1));
    if !arcs.is_empty() && to != Some(None) {
        let times = Times {
            from: times.from.map(|from| from.saturating_sub(1)),
            to: to.flatten(),
        };
        forbid(task, Act::Cross(arcs), times);
    }
}

/// The slow arcs with an end in an area, in ascending order; an agent in transit at time 0
/// is on such an arc, too.
pub(super) fn slow_arcs(terrain: &Terrain, area: &Area) -> Vec<u32> {
    let touches = |id: u32| {
        let (from, to) = terrain.ends(id);
        area.has(from) || area.has(to)
    };
    let arcs = (0..terrain.size() as Vertex).flat_map(|v| terrain.arcs(v));
    let slow = arcs.filter(|arc| arc.slow && touches(arc.id));
    sorted(slow.map(|arc| arc.id))
}

pub(super) fn forbid(task: &mut Task, act: Act, times: Times) {
    task.conditions.forbidden.push(Forbidden {
        act,
        times,
        unless: 0,
    });
}

fn sorted(arcs: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut arcs: Vec<u32> = arcs.collect();
    sort(&mut arcs);
    arcs.dedup();
    arcs
}

pub(super) fn arc(terrain: &Terrain, from: Cell, to: Cell) -> Option<Arc> {
    let (u, v) = (terrain.vertex(from)?, terrain.vertex(to)?);
    terrain.arcs(u).iter().find(|arc| arc.to == v).copied()
}
