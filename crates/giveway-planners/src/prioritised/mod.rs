//! Prioritised planning: one agent after the other, each around those before it.
//!
//! Erdmann and Lozano-Perez, "On multiple moving objects" (1987). Fast, neither
//! complete nor best: whether it finds a plan depends on the order. In a *found*
//! order an agent that gets stuck moves to the front and all is begun again;
//! where that comes to an order seen before, orders are drawn by lot (always the
//! same). Plain tasks, and most rules of a scene's own, are planned by safe intervals, batteries by
//! space-time A*.

mod furthest;
#[cfg(test)]
mod tests;
mod trace;

use std::collections::BTreeSet;

use fastrand::Rng;

pub use trace::{OrderAttempt, Planned, Stuck};

use crate::{
    AgentId,
    budget::{Budget, Stop},
    chance::shuffle,
    local::{OtherAgents, Query, Reservations, Timetable},
    problem::Problem,
    walk::{Walk, arrival},
};

/// In which order agents are planned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Order {
    /// In this one; agents that it lacks come last, by number.
    Given(Vec<AgentId>),
    /// In the first of so many orders at most that works.
    Found {
        /// How many orders are tried.
        tries: u32,
    },
    /// The same, beginning with one; agents that it lacks come last, by number.
    From {
        /// The first order.
        first: Vec<AgentId>,
        /// How many orders are tried.
        tries: u32,
    },
}

impl Default for Order {
    fn default() -> Self {
        Self::Found { tries: 200 }
    }
}

/// How prioritised planning ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ended {
    /// With a plan: the walks, one an agent.
    Found(Vec<Walk>),
    /// No order that was tried works. There may be a plan.
    NoOrderWorks(Stuck),
    /// Early.
    Stopped(Stop),
}

/// The result of prioritised planning.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub ended: Ended,
    /// How many orders were tried.
    pub tried: u32,
    /// The orders that were tried, where they are recorded.
    pub attempts: Option<Vec<OrderAttempt>>,
}

/// States to look at for one agent under rules of a scene's own, which safe intervals do not
/// tell all of.
const MOST_UNDER_RULES: u32 = 100_000;
/// Attempts that are told at most.
const MOST_TOLD: usize = 200;
/// Walks are told up to so many places in all.
const MOST_PLACES: usize = 20_000;

/// Plans the agents one after the other, no walk longer than the horizon.
pub fn prioritised(
    problem: &Problem,
    order: &Order,
    horizon: u32,
    traced: bool,
    budget: &dyn Budget,
) -> Outcome {
    let mut outcome = Outcome {
        ended: Ended::Found(Vec::new()),
        tried: 0,
        attempts: traced.then(Vec::new),
    };
    let mut places = if traced { MOST_PLACES } else { 0 };
    let mut orders = Orders::new(problem, order);
    let mut current = orders.first();
    outcome.ended = loop {
        let mut attempt = OrderAttempt {
            order: current.clone(),
            planned: Vec::new(),
            stuck: None,
            furthest: Walk::new(),
            dead_end: false,
        };
        let tried = if let Some(nobody) = Timetable::new(problem) {
            attempt.run(nobody, horizon, traced, &mut places, budget)
        } else {
            let nobody = Reservations::new(problem);
            attempt.run(nobody, horizon, traced, &mut places, budget)
        };
        outcome.tried += 1;
        let stuck = attempt.stuck.clone();
        if let Some(attempts) = outcome
            .attempts
            .as_mut()
            .filter(|told| told.len() < MOST_TOLD)
        {
            attempts.push(attempt);
        }
        match (tried, stuck) {
            (Err(stop), _) => break Ended::Stopped(stop),
            (Ok(walks), None) => break Ended::Found(walks),
            (Ok(_), Some(stuck)) => match orders.next(&current, &stuck) {
                Some(next) => current = next,
                None => break Ended::NoOrderWorks(stuck),
            },
        }
    };
    outcome
}

/// The orders to try.
struct Orders {
    first: Vec<AgentId>,
    left: u32,
    seen: BTreeSet<Vec<AgentId>>,
    rng: Rng,
}

impl Orders {
    fn new(problem: &Problem, order: &Order) -> Self {
        let (given, left) = match order {
            Order::Given(given) => (given.as_slice(), 1),
            Order::Found { tries } => (&[][..], *tries),
            Order::From { first, tries } => (first.as_slice(), *tries),
        };
        let mut first: Vec<AgentId> = Vec::new();
        for agent in given.iter().copied().chain(0..problem.agents()) {
            if agent < problem.agents() && !first.contains(&agent) {
                first.push(agent);
            }
        }
        Self {
            first,
            left,
            seen: BTreeSet::new(),
            rng: Rng::with_seed(7),
        }
    }

    fn first(&mut self) -> Vec<AgentId> {
        self.seen.insert(self.first.clone());
        self.first.clone()
    }

    /// The next order after one in which an agent got stuck.
    fn next(&mut self, order: &[AgentId], stuck: &Stuck) -> Option<Vec<AgentId>> {
        self.left = self.left.saturating_sub(1);
        let mut next: Vec<AgentId> = vec![stuck.agent];
        next.extend(order.iter().filter(|&&agent| agent != stuck.agent));
        while self.left > 0 && !self.seen.insert(next.clone()) {
            self.left -= 1;
            shuffle(&mut self.rng, &mut next);
        }
        (self.left > 0).then_some(next)
    }
}

impl OrderAttempt {
    /// Plans in its order, from nobody on; the walks are by agent, and a plan
    /// unless one is stuck. So many places are still told of them.
    fn run(
        &mut self,
        mut others: impl OtherAgents,
        horizon: u32,
        traced: bool,
        places: &mut usize,
        budget: &dyn Budget,
    ) -> Result<Vec<Walk>, Stop> {
        let mut walks = vec![Walk::new(); self.order.len()];
        for &agent in &self.order {
            budget.check()?;
            let query = Query {
                agent,
                latest: horizon,
                conflict_penalty: None,
                expansion_limit: expansion_limit(others.problem()),
            };
            let walk = others.plan(query, budget)?.map(|(walk, _)| walk);
            let alone = others.problem().optima[agent];
            let is_late = walk.as_ref().is_none_or(|walk| arrival(walk) > alone);
            let around = if is_late && (traced || walk.is_none()) {
                in_the_way(&mut others, agent, budget)?
            } else {
                Vec::new()
            };
            let Some(walk) = walk else {
                self.stuck = Some(Stuck { agent, around });
                if *places > 0 {
                    (self.furthest, self.dead_end) =
                        furthest::furthest(&others, agent, horizon, budget)?;
                    *places = places.saturating_sub(self.furthest.len());
                }
                return Ok(walks);
            };
            let is_told = walk.len() <= *places;
            *places = places.saturating_sub(walk.len());
            self.planned.push(Planned {
                agent,
                arrival: arrival(&walk),
                alone,
                around,
                walk: if is_told { walk.clone() } else { Walk::new() },
            });
            others.add(agent, &walk);
            walks[agent] = walk;
        }
        Ok(walks)
    }
}

/// The states to look at for one agent.
const fn expansion_limit(problem: &Problem) -> u32 {
    if problem.is_constrained {
        MOST_UNDER_RULES
    } else {
        u32::MAX
    }
}

/// The agents on the way that an agent would take alone.
fn in_the_way(
    others: &mut impl OtherAgents,
    agent: AgentId,
    budget: &dyn Budget,
) -> Result<Vec<AgentId>, Stop> {
    let query = Query {
        agent,
        latest: others.problem().optima[agent],
        conflict_penalty: Some(1),
        expansion_limit: expansion_limit(others.problem()),
    };
    let own = others.plan(query, budget)?;
    let met = own.map(|(walk, _)| others.met_by(agent, &walk));
    Ok(met.into_iter().flatten().collect())
}
