//! A node of the constraint tree: a walk of each agent that keeps its constraints.

use std::rc::Rc;

use super::{
    conflict::{Conflict, between},
    constraint::Constraint,
    mdd::Mdd,
    rulebook::Rulebook,
};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    local::{OtherAgents, Reservations},
    problem::Problem,
    single::Place,
    walk::{Walk, arrival},
};

/// The walk of an agent in a node.
#[derive(Clone)]
pub(super) struct Way {
    /// The walk, which is one of the MDD.
    pub(super) walk: Rc<Walk>,
    /// All walks as short when it was planned. Constraints of others that the
    /// walk keeps by itself may have come since.
    pub(super) mdd: Rc<Mdd>,
}

/// A node that is open.
#[derive(Clone)]
pub(super) struct Node {
    /// All constraints, the root's first.
    pub(super) constraints: Vec<Constraint>,
    /// The walks, one an agent.
    pub(super) ways: Vec<Way>,
    /// All conflicts of these walks.
    pub(super) conflicts: Vec<Conflict>,
}

impl Node {
    /// The root: everyone apart, where there is a choice around those before it.
    pub(super) fn root(
        problem: &Problem,
        horizon: u32,
        budget: &dyn Budget,
    ) -> Result<Option<Self>, Stop> {
        let mut root = Self {
            constraints: Vec::new(),
            ways: Vec::new(),
            conflicts: Vec::new(),
        };
        for agent in 0..problem.agents() {
            let Some(way) = root.way(problem, agent, horizon, budget)? else {
                return Ok(None);
            };
            root.ways.push(way);
            root.meet(problem, agent);
        }
        Ok(Some(root))
    }

    /// The child with one constraint more; `None` where an agent cannot keep it.
    pub(super) fn child(
        &self,
        problem: &Problem,
        constraint: Constraint,
        horizon: u32,
        budget: &dyn Budget,
    ) -> Result<Option<Self>, Stop> {
        let mut child = self.clone();
        child.constraints.push(constraint);
        for agent in 0..child.ways.len() {
            let own = constraint.for_agent(problem, agent);
            let walk = &child.ways[agent].walk;
            let kept = own.is_none_or(|own| own.is_kept(problem, agent, walk));
            // Its own MDD is narrower now, even where its walk may stay.
            if kept && agent != constraint.agent {
                continue;
            }
            let Some(way) = child.way(problem, agent, horizon, budget)? else {
                return Ok(None);
            };
            child.ways[agent] = way;
            child.meet(problem, agent);
        }
        Ok(Some(child))
    }

    /// About what it holds beside the MDDs, in bytes. Of its walks one is its own.
    pub(super) fn bytes(&self) -> usize {
        let walk = self.ways.iter().map(|way| way.walk.len()).max();
        256 + size_of::<Constraint>() * self.constraints.capacity()
            + size_of::<Way>() * self.ways.capacity()
            + size_of::<Conflict>() * self.conflicts.capacity()
            + size_of::<Place>() * walk.unwrap_or(0)
    }

    /// The walks that are not those of another node; all without one.
    pub(super) fn walks_beside<'a>(
        &'a self,
        other: Option<&'a Self>,
    ) -> impl Iterator<Item = (AgentId, Rc<Walk>)> + 'a {
        let walks = self.ways.iter().map(|way| &way.walk).enumerate();
        let has = |other: &Self, agent: AgentId, walk: &Rc<Walk>| {
            let own = other.ways.get(agent);
            own.is_some_and(|own| Rc::ptr_eq(&own.walk, walk) || own.walk == *walk)
        };
        walks
            .filter(move |(agent, walk)| !other.is_some_and(|other| has(other, *agent, walk)))
            .map(|(agent, walk)| (agent, Rc::clone(walk)))
    }

    /// When each agent arrives.
    pub(super) fn arrivals(&self) -> impl Iterator<Item = u32> + '_ {
        self.ways.iter().map(|way| arrival(&way.walk))
    }

    /// A shortest walk of an agent by its constraints, with few conflicts.
    fn way(
        &self,
        problem: &Problem,
        agent: AgentId,
        horizon: u32,
        budget: &dyn Budget,
    ) -> Result<Option<Way>, Stop> {
        let mut rules = Rulebook::default();
        for constraint in &self.constraints {
            if let Some(own) = constraint.for_agent(problem, agent) {
                rules.add(own);
            }
        }
        // With more constraints nobody arrives sooner.
        let known = self.ways.get(agent).map_or(0, |way| way.mdd.arrival());
        let mdd = Mdd::new(problem, agent, &rules, known, horizon, budget)?;
        Ok(mdd.map(|mdd| {
            let mut others = Reservations::new(problem);
            for (other, way) in self.ways.iter().enumerate() {
                if other != agent {
                    others.add(other, &way.walk);
                }
            }
            Way {
                walk: Rc::new(mdd.calmest(problem, &others)),
                mdd: Rc::new(mdd),
            }
        }))
    }

    /// Notes anew whom an agent meets.
    fn meet(&mut self, problem: &Problem, agent: AgentId) {
        self.conflicts
            .retain(|c| c.first != agent && c.second != agent);
        let own = &self.ways[agent].walk;
        for (other, way) in self.ways.iter().enumerate() {
            if other < agent {
                let found = between(problem, (other, &way.walk), (agent, own));
                self.conflicts.extend(found);
            } else if other > agent {
                let found = between(problem, (agent, own), (other, &way.walk));
                self.conflicts.extend(found);
            }
        }
    }
}
