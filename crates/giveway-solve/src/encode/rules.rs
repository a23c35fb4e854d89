//! Rules between agents in clauses: zones with a limit, gaps, distances.
//!
//! Like collisions, they are written for the agents inside the SAT solver only, as their
//! MDDs grow. A zone counts its agents at each time by a totalizer with no more outputs
//! than its limit needs; gaps and distances exclude pairs of positions. An agent that a zone
//! does not count until it has left it has a literal for each time: that it has left by then.

use std::collections::BTreeMap;

use giveway_planners::rules::{Between, SharedKind, near, touched};

use super::{collisions::AgentId, limit::SumLimit};
use crate::{
    budget::Stop,
    sat::{Clauses, Lit},
    single::Place,
    terrain::{Terrain, Vertex},
};

/// The agents in a zone at a time.
struct Count {
    inside: BTreeMap<AgentId, Lit>,
    sum: SumLimit,
}

/// Positions of agents, each with its literal.
type Positions = Vec<(AgentId, Lit)>;

/// Clauses of rules between the agents inside the solver.
#[derive(Default)]
pub(crate) struct RuleClauses {
    /// By rule and time.
    zones: BTreeMap<(usize, u32), Count>,
    /// At a vertex, by time.
    visits: BTreeMap<Vertex, BTreeMap<u32, Positions>>,
    /// At a vertex or in transit to or from it, by time.
    touching: BTreeMap<(u32, Vertex), Positions>,
    /// By rule and agent: it has left the zone by the times from 0 on.
    left: BTreeMap<(usize, AgentId), Vec<Lit>>,
}

impl RuleClauses {
    /// An agent may be at a place at a time, namely when the literal is true.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(crate) fn occupy(
        &mut self,
        (between, terrain): (&Between, &Terrain),
        (time, place): (u32, Place),
        (agent, at): (AgentId, Lit),
        out: &mut impl Clauses,
    ) -> Result<(), Stop> {
        let mut has_gap = false;
        let mut has_distance = false;
        for (number, rule) in between.rules.iter().enumerate() {
            if !rule.binds(agent) {
                continue;
            }
            match &rule.kind {
                SharedKind::Capacity { area, most, times } => {
                    let is_inside = touched(terrain, place).any(|v| area.has(v));
                    let left = rule
                        .begins_uncounted(agent)
                        .then(|| self.has_left((number, agent), time, out));
                    if let (false, Some(left)) = (is_inside, left) {
                        out.clause(&[!at, left]);
                    }
                    if is_inside && times.contains(time) {
                        self.count((number, time), *most, (agent, at, left), out)?;
                    }
                }
                SharedKind::Gap { steps } => {
                    has_gap = true;
                    if let Place::At(v) = place {
                        let times = time.saturating_sub(*steps)..=time.saturating_add(*steps);
                        let visits = self.visits.get(&v).into_iter();
                        let visits = visits.flat_map(|visits| visits.range(times.clone()));
                        for &(other, there) in visits.flat_map(|(_, positions)| positions) {
                            if other != agent && rule.binds(other) {
                                out.clause(&[!at, !there]);
                            }
                        }
                    }
                }
                SharedKind::Apart { distance, times } => {
                    has_distance = true;
                    if times.contains(time) {
                        for v in touched(terrain, place) {
                            for u in near(terrain, v, *distance) {
                                let there = self.touching.get(&(time, u)).into_iter().flatten();
                                for &(other, there) in there {
                                    if other != agent && rule.binds(other) {
                                        out.clause(&[!at, !there]);
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
        if let (true, Place::At(v)) = (has_gap, place) {
            let visits = self.visits.entry(v).or_default();
            visits.entry(time).or_default().push((agent, at));
        }
        if has_distance {
            for v in touched(terrain, place) {
                let touching = self.touching.entry((time, v)).or_default();
                touching.push((agent, at));
            }
        }
        Ok(())
    }

    /// The literal "an agent has left the zone of a rule by a time".
    fn has_left(&mut self, key: (usize, AgentId), time: u32, out: &mut impl Clauses) -> Lit {
        let left = self.left.entry(key).or_default();
        loop {
            if let Some(&lit) = left.get(time as usize) {
                return lit;
            }
            let next = out.fresh();
            if let Some(&last) = left.last() {
                out.clause(&[!last, next]);
            }
            left.push(next);
        }
    }

    /// An agent is in the zone of a rule at a time, where the literals are true: that it is
    /// there, and, where it is given, that it has left before.
    fn count(
        &mut self,
        key: (usize, u32),
        most: u32,
        (agent, at, left): (AgentId, Lit, Option<Lit>),
        out: &mut impl Clauses,
    ) -> Result<(), Stop> {
        let count = self.zones.entry(key).or_insert_with(|| Count {
            inside: BTreeMap::new(),
            sum: SumLimit::new(most as usize),
        });
        let inside = if let Some(&inside) = count.inside.get(&agent) {
            inside
        } else {
            let inside = out.fresh();
            count.inside.insert(agent, inside);
            count.sum.add(&[inside], out)?;
            inside
        };
        let clause = [Some(!at), left.map(|left| !left), Some(inside)];
        let clause: Vec<Lit> = clause.into_iter().flatten().collect();
        out.clause(&clause);
        Ok(())
    }
}
