//! The walks of other agents, as whoever plans one agent asks about them.

use std::collections::BTreeSet;

use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::Problem,
    rules::Presence,
    single::{Mask, Place},
    terrain::Vertex,
    walk::{Walk, arrival, crossed},
};

use super::{Query, space_time};

/// The walks of some agents, indexed by what they use.
pub trait OtherAgents {
    /// The problem that they are walks of.
    fn problem(&self) -> &Problem;

    /// Adds the walk of an agent.
    fn add(&mut self, agent: AgentId, walk: &[Place]);

    /// Takes away the walk of an agent, as it was added.
    fn remove(&mut self, agent: AgentId, walk: &[Place]);

    /// The agents at a vertex at a time.
    fn at(&self, time: u32, v: Vertex) -> impl Iterator<Item = AgentId> + '_;

    /// The agents that cross the edge of an arc the other way in the step that begins at a time.
    fn against(&self, time: u32, arc: u32) -> impl Iterator<Item = AgentId> + '_;

    /// The agents that visit a vertex after a time at which an agent may rest there.
    fn after(&self, time: u32, v: Vertex) -> impl Iterator<Item = AgentId> + '_;

    /// The last time at which a goal is visited by an agent on its way.
    fn last_visit(&self, goal: Vertex) -> Option<u32>;

    /// The agents that visit a vertex, in the order of time, as far as they are known.
    fn visitors(&self, _v: Vertex) -> Vec<AgentId> {
        Vec::new()
    }

    /// The agents that rules between agents keep an agent from a vertex for at a time, as far as
    /// they are known; it may be one of them itself.
    fn kept_away_by(&self, _agent: AgentId, _time: u32, _v: Vertex) -> Vec<AgentId> {
        Vec::new()
    }

    /// The agents with which an agent would break a rule between agents.
    fn met_by_rules(&self, _here: Presence) -> Vec<AgentId> {
        Vec::new()
    }

    /// The same of an agent whose walk ends at a vertex at a time, having come so far.
    fn met_after_end(&self, _agent: AgentId, _v: Vertex, _time: u32, _mask: Mask) -> Vec<AgentId> {
        Vec::new()
    }

    /// The agents with which a walk of an agent breaks a rule between agents.
    fn met_by_rules_on(&self, _agent: AgentId, _walk: &[Place]) -> BTreeSet<AgentId> {
        BTreeSet::new()
    }

    /// The best walk of an agent among them, and its number of collisions; see
    /// [`plan_one`](super::plan_one).
    ///
    /// # Errors
    /// When the budget is spent.
    fn plan(&mut self, query: Query, budget: &dyn Budget) -> Result<Option<(Walk, u32)>, Stop>
    where
        Self: Sized,
    {
        space_time::plan_one(self.problem(), self, query, budget)
    }

    /// The agents that a walk of an agent collides with.
    fn met_by(&self, agent: AgentId, walk: &[Place]) -> BTreeSet<AgentId> {
        let problem = self.problem();
        let mut met = BTreeSet::new();
        for (time, place) in walk.iter().enumerate() {
            let step = time as u32;
            if let Place::At(v) = *place {
                met.extend(self.at(step, v));
            }
            if let Some(arc) = crossed(&problem.terrain, walk, time) {
                met.extend(self.against(step, arc.id));
            }
        }
        if let Some(&Place::At(end)) = walk.last()
            && problem.rests(agent)
        {
            met.extend(self.after(arrival(walk), end));
        }
        met.retain(|&other| problem.collide(agent, other));
        // Two that ignore each other keep the scene's own rules all the same.
        met.append(&mut self.met_by_rules_on(agent, walk));
        met
    }
}
