//! Reservations: the vertices and edges of many walks at each time.

use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::FxBuildHasher;
use smallvec::SmallVec;

use super::OtherAgents;
use crate::{
    AgentId,
    problem::Problem,
    rules::{Presence, RuleTable},
    single::{Mask, Place, Task},
    terrain::Vertex,
    walk::{Walk, arrival, crossed},
};
use giveway_model::sorting::map;

#[expect(
    clippy::disallowed_types,
    reason = "only looked up, never iterated, so its order cannot matter"
)]
type Table = std::collections::HashMap<(u32, u32), Agents, FxBuildHasher>;

/// The agents at one place and time: rarely more than one, and then without a heap.
type Agents = SmallVec<[AgentId; 2]>;

/// The walks of some agents, indexed by what they use.
pub struct Reservations<'p> {
    problem: &'p Problem,
    at: Table,
    along: Table,
    /// Under `stay`: who rests at a vertex, and from which time on.
    rests: BTreeMap<Vertex, Vec<(u32, AgentId)>>,
    /// The times at which each vertex where an agent may rest is visited by an agent on its way.
    visits: BTreeMap<Vertex, BTreeSet<(u32, AgentId)>>,
    /// What rules between agents look at, where there are some.
    rules: Option<RuleTable<'p>>,
}

impl<'p> Reservations<'p> {
    /// Of nobody.
    pub fn new(problem: &'p Problem) -> Self {
        let ends = |task: &Task| task.ends(&problem.terrain);
        let anywhere = problem.tasks.iter().find(|task| task.goal.is_none());
        let ends: Vec<Vertex> = match anywhere {
            Some(task) => ends(task),
            None => problem.tasks.iter().flat_map(ends).collect(),
        };
        Self {
            problem,
            at: Table::default(),
            along: Table::default(),
            rests: BTreeMap::new(),
            visits: map(ends.into_iter().map(|v| (v, BTreeSet::new()))),
            rules: RuleTable::new(problem),
        }
    }

    /// The walks of all agents.
    pub fn of(problem: &'p Problem, walks: &[Walk]) -> Self {
        let mut all = Self::new(problem);
        for (agent, walk) in walks.iter().enumerate() {
            all.add(agent, walk);
        }
        all
    }
}

impl OtherAgents for Reservations<'_> {
    fn problem(&self) -> &Problem {
        self.problem
    }

    fn add(&mut self, agent: AgentId, walk: &[Place]) {
        if let Some(rules) = &mut self.rules {
            rules.add(agent, walk);
        }
        for (time, place) in walk.iter().enumerate() {
            if let Place::At(v) = *place {
                self.at.entry((time as u32, v)).or_default().push(agent);
                if let Some(visits) = self.visits.get_mut(&v) {
                    visits.insert((time as u32, agent));
                }
            }
            if let Some(arc) = crossed(&self.problem.terrain, walk, time) {
                self.along
                    .entry((time as u32, arc.id))
                    .or_default()
                    .push(agent);
            }
        }
        if let Some(&Place::At(end)) = walk.last()
            && self.problem.rests(agent)
        {
            let rests = self.rests.entry(end).or_default();
            rests.push((arrival(walk) + 1, agent));
        }
    }

    fn remove(&mut self, agent: AgentId, walk: &[Place]) {
        if let Some(rules) = &mut self.rules {
            rules.remove(agent, walk);
        }
        let drop = |table: &mut Table, key: (u32, u32)| {
            if let Some(users) = table.get_mut(&key) {
                users.retain(|user| *user != agent);
                if users.is_empty() {
                    table.remove(&key);
                }
            }
        };
        for (time, place) in walk.iter().enumerate() {
            if let Place::At(v) = *place {
                drop(&mut self.at, (time as u32, v));
                if let Some(visits) = self.visits.get_mut(&v) {
                    visits.remove(&(time as u32, agent));
                }
            }
            if let Some(arc) = crossed(&self.problem.terrain, walk, time) {
                drop(&mut self.along, (time as u32, arc.id));
            }
        }
        if let Some(&Place::At(end)) = walk.last()
            && let Some(rests) = self.rests.get_mut(&end)
        {
            rests.retain(|&(_, other)| other != agent);
        }
    }

    fn at(&self, time: u32, v: Vertex) -> impl Iterator<Item = AgentId> + '_ {
        let resting = self.rests.get(&v).into_iter().flatten();
        let resting = resting.filter(move |(from, _)| *from <= time);
        let passing = self.at.get(&(time, v)).into_iter().flatten();
        passing.copied().chain(resting.map(|&(_, agent)| agent))
    }

    fn against(&self, time: u32, arc: u32) -> impl Iterator<Item = AgentId> + '_ {
        self.along
            .get(&(time, arc ^ 1))
            .into_iter()
            .flatten()
            .copied()
    }

    fn after(&self, time: u32, v: Vertex) -> impl Iterator<Item = AgentId> + '_ {
        let visits = self.visits.get(&v);
        visits
            .into_iter()
            .flat_map(move |set| set.range((time + 1, 0)..))
            .map(|&(_, agent)| agent)
    }

    fn last_visit(&self, goal: Vertex) -> Option<u32> {
        let visits = self.visits.get(&goal)?;
        visits.last().map(|&(time, _)| time)
    }

    fn met_by_rules(&self, here: Presence) -> Vec<AgentId> {
        let rules = self.rules.iter();
        rules.flat_map(|rules| rules.met(here)).collect()
    }

    fn met_after_end(&self, agent: AgentId, v: Vertex, time: u32, mask: Mask) -> Vec<AgentId> {
        let rules = self.rules.iter();
        rules
            .flat_map(|rules| rules.met_after_end(agent, v, time, mask))
            .collect()
    }

    fn met_by_rules_on(&self, agent: AgentId, walk: &[Place]) -> BTreeSet<AgentId> {
        let rules = self.rules.as_ref();
        rules.map_or_else(BTreeSet::new, |rules| rules.met_by(agent, walk))
    }
}
