//! Who is where and crosses what, of many walks at once.

use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::FxBuildHasher;

use super::Others;
use crate::{
    AgentId,
    problem::Problem,
    single::Place,
    terrain::Vertex,
    walk::{Walk, arrival, crossed},
};
use giveway_model::sorting::map;

#[expect(
    clippy::disallowed_types,
    reason = "only looked up, never iterated, so its order cannot matter"
)]
type Table = std::collections::HashMap<(u32, u32), Vec<AgentId>, FxBuildHasher>;

/// The walks of some agents, indexed by what they use.
pub struct Reservations<'p> {
    problem: &'p Problem,
    at: Table,
    along: Table,
    /// Under `stay`: who rests at a vertex, and from which time on.
    rests: BTreeMap<Vertex, (u32, AgentId)>,
    /// The times at which each goal is visited by an agent on its way.
    visits: BTreeMap<Vertex, BTreeSet<(u32, AgentId)>>,
}

impl<'p> Reservations<'p> {
    /// Of nobody.
    pub fn new(problem: &'p Problem) -> Self {
        let goals = problem.tasks.iter().map(|task| task.goal);
        Self {
            problem,
            at: Table::default(),
            along: Table::default(),
            rests: BTreeMap::new(),
            visits: map(goals.map(|goal| (goal, BTreeSet::new()))),
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

impl Others for Reservations<'_> {
    fn problem(&self) -> &Problem {
        self.problem
    }

    fn add(&mut self, agent: AgentId, walk: &[Place]) {
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
        if self.problem.rests(agent) {
            let goal = self.problem.tasks[agent].goal;
            self.rests.insert(goal, (arrival(walk) + 1, agent));
        }
    }

    fn remove(&mut self, agent: AgentId, walk: &[Place]) {
        let drop = |table: &mut Table, key: (u32, u32)| {
            if let Some(users) = table.get_mut(&key) {
                users.retain(|&user| user != agent);
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
        if self.problem.rests(agent) {
            self.rests.remove(&self.problem.tasks[agent].goal);
        }
    }

    fn at(&self, time: u32, v: Vertex) -> impl Iterator<Item = AgentId> + '_ {
        let resting = self.rests.get(&v).filter(|(from, _)| *from <= time);
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

    fn after(&self, time: u32, goal: Vertex) -> impl Iterator<Item = AgentId> + '_ {
        let visits = self.visits.get(&goal);
        visits
            .into_iter()
            .flat_map(move |set| set.range((time + 1, 0)..))
            .map(|&(_, agent)| agent)
    }

    fn last_visit(&self, goal: Vertex) -> Option<u32> {
        let visits = self.visits.get(&goal)?;
        visits.last().map(|&(time, _)| time)
    }
}
