//! Everyone apart, then collisions repaired.
//!
//! Every agent takes a best walk of its own that meets few others; then small
//! groups of colliding agents are planned anew, never with more collisions than
//! before, until none is left (MAPF-LNS2; Li et al. 2022).

use std::collections::BTreeSet;

use fastrand::Rng;

use super::{OtherAgents, Query, Reservations, plan_one, space_time::DEAR};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    chance::{below, shuffle},
    problem::Problem,
    walk::Walk,
};

/// Agents planned anew at once.
const GROUP: usize = 8;
/// States to look at for one agent.
const EXPANSION_LIMIT: u32 = 30_000;

/// Rounds without success after which the expansion limit doubles.
const STUCK: u32 = 30;

/// Each agent at its own optimum, with few collisions. The walk of an agent is empty where its
/// optimum is only a lower bound, or conditions that only a SAT solver keeps rule out what was
/// looked at.
///
/// # Errors
/// When the budget is spent.
pub fn apart(problem: &Problem, budget: &dyn Budget) -> Result<Vec<Walk>, Stop> {
    let mut others = Reservations::new(problem);
    let mut walks = Vec::with_capacity(problem.agents());
    for agent in 0..problem.agents() {
        let query = Query {
            agent,
            latest: problem.optima[agent],
            conflict_penalty: Some(1),
            expansion_limit: u32::MAX,
        };
        let walk = plan_one(problem, &others, query, budget)?;
        let walk = walk.map(|(walk, _)| walk).unwrap_or_default();
        others.add(agent, &walk);
        walks.push(walk);
    }
    Ok(walks)
}

/// A plan, from walks that may collide; `None` where none is found soon. No
/// walk is longer than the horizon.
///
/// # Errors
/// When the budget is spent.
pub fn repair(
    problem: &Problem,
    walks: Vec<Walk>,
    horizon: u32,
    budget: &dyn Budget,
) -> Result<Option<Vec<Walk>>, Stop> {
    let mut repair = Repair::new(problem, walks, horizon);
    let mut rng = Rng::with_seed(problem.agents() as u64);
    let rounds = 100 + 20 * problem.agents();
    let mut stuck = 0;
    for _ in 0..rounds {
        let colliding: Vec<AgentId> = repair.pairs.iter().map(|&(agent, _)| agent).collect();
        if colliding.is_empty() {
            return Ok(Some(repair.walks));
        }
        let before = colliding.len();
        let seed = colliding[below(&mut rng, colliding.len())];
        let group = repair.choose_group(seed, &mut rng, budget)?;
        repair.expansion_limit = EXPANSION_LIMIT << (stuck / STUCK).min(2);
        repair.replan(&group, budget)?;
        stuck = if repair.pairs.len() < before {
            0
        } else {
            stuck + 1
        };
    }
    Ok(None)
}

/// Walks under repair.
struct Repair<'p> {
    problem: &'p Problem,
    horizon: u32,
    expansion_limit: u32,
    walks: Vec<Walk>,
    others: Reservations<'p>,
    /// Which agents collide: both orders of each pair.
    pairs: BTreeSet<(AgentId, AgentId)>,
}

impl<'p> Repair<'p> {
    fn new(problem: &'p Problem, walks: Vec<Walk>, horizon: u32) -> Self {
        let others = Reservations::of(problem, &walks);
        let mut repair = Self {
            problem,
            horizon,
            expansion_limit: EXPANSION_LIMIT,
            walks,
            others,
            pairs: BTreeSet::new(),
        };
        for agent in 0..repair.walks.len() {
            repair.meet(agent);
        }
        repair
    }

    /// Notes whom an agent collides with.
    fn meet(&mut self, agent: AgentId) {
        for other in self.others.met_by(agent, &self.walks[agent]) {
            self.pairs.insert((agent, other));
            self.pairs.insert((other, agent));
        }
    }

    /// The agents that an agent collides with.
    fn met(&self, agent: AgentId) -> Vec<AgentId> {
        let pairs = self.pairs.range((agent, 0)..(agent + 1, 0));
        pairs.map(|&(_, other)| other).collect()
    }

    /// Takes an agent's walk away.
    fn lift(&mut self, agent: AgentId) {
        self.others.remove(agent, &self.walks[agent]);
        for other in self.met(agent) {
            self.pairs.remove(&(agent, other));
            self.pairs.remove(&(other, agent));
        }
    }

    /// Gives an agent a walk.
    fn lay(&mut self, agent: AgentId, walk: Walk) {
        self.others.add(agent, &walk);
        self.walks[agent] = walk;
        self.meet(agent);
    }

    /// The agent and those it collides with; then those they collide with, or
    /// those in its straight way; then others by chance; in random order.
    fn choose_group(
        &self,
        seed: AgentId,
        rng: &mut Rng,
        budget: &dyn Budget,
    ) -> Result<Vec<AgentId>, Stop> {
        let mut candidates = self.met(seed);
        if rng.u8(..4) > 0 {
            let mut next = 0;
            while next < candidates.len() && candidates.len() < GROUP {
                let met = self.met(candidates[next]);
                candidates.extend(met.into_iter().filter(|&other| other != seed));
                next += 1;
            }
        } else {
            let query = Query {
                agent: seed,
                latest: self.problem.optima[seed],
                conflict_penalty: Some(0),
                expansion_limit: EXPANSION_LIMIT,
            };
            let alone = Reservations::new(self.problem);
            if let Some((walk, _)) = plan_one(self.problem, &alone, query, budget)? {
                candidates.extend(self.others.met_by(seed, &walk));
            }
            shuffle(rng, &mut candidates);
        }
        let by_chance = (0..GROUP).map(|_| below(rng, self.walks.len()));
        let mut group = vec![seed];
        for other in candidates.into_iter().chain(by_chance) {
            if group.len() < GROUP && !group.contains(&other) {
                group.push(other);
            }
        }
        shuffle(rng, &mut group);
        Ok(group)
    }

    /// Plans a group anew, one after the other; keeps the old walks where the
    /// new ones would collide more.
    fn replan(&mut self, group: &[AgentId], budget: &dyn Budget) -> Result<(), Stop> {
        let before = self.pairs.len();
        let old: Vec<Walk> = group.iter().map(|&a| self.walks[a].clone()).collect();
        for &agent in group {
            self.lift(agent);
        }
        for (&agent, old) in group.iter().zip(&old) {
            let query = Query {
                agent,
                latest: self.horizon,
                conflict_penalty: Some(DEAR),
                expansion_limit: self.expansion_limit,
            };
            let found = plan_one(self.problem, &self.others, query, budget)?;
            self.lay(agent, found.map_or_else(|| old.clone(), |(walk, _)| walk));
        }
        if self.pairs.len() > before {
            for &agent in group {
                self.lift(agent);
            }
            for (&agent, old) in group.iter().zip(old) {
                self.lay(agent, old);
            }
        }
        Ok(())
    }
}
