//! A plan made better: large neighbourhood search.
//!
//! A delayed agent and those in the way of a better walk of its own are planned
//! anew, in random order, each around all others; the result is kept where it
//! is no worse (MAPF-LNS; Li et al. 2021).

use fastrand::Rng;
use giveway_model::{Cost, Objective};

use super::{
    Query, Reservations,
    chance::{below, shuffle},
    plan_one,
};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    problem::Problem,
    walk::{Walk, arrival, costs},
};

/// States to look at for one agent.
const EXPANSION_LIMIT: u32 = 20_000;

/// A search that can be continued; the same calls give the same plans.
pub struct Lns {
    rng: Rng,
}

impl Default for Lns {
    /// A search at its beginning.
    fn default() -> Self {
        Self {
            rng: Rng::with_seed(7),
        }
    }
}

impl Lns {
    /// Tries some neighbourhoods; true where the plan became better. No walk
    /// becomes longer than the horizon.
    ///
    /// # Errors
    /// When the budget is spent; the walks are a plan then, too.
    pub fn improve(
        &mut self,
        problem: &Problem,
        walks: &mut [Walk],
        horizon: u32,
        objective: &Objective,
        rounds: usize,
        budget: &dyn Budget,
    ) -> Result<bool, Stop> {
        let mut others = Reservations::of(problem, walks);
        let first = costs(problem, walks).vector(objective);
        let mut best = first.clone();
        for _ in 0..rounds {
            let Some(group) = self.choose_group(problem, walks, &others, horizon, budget)? else {
                break;
            };
            let old: Vec<Walk> = group.iter().map(|&a| walks[a].clone()).collect();
            for &agent in &group {
                others.remove(agent, &walks[agent]);
            }
            let room = match objective.costs().first() {
                Some(Cost::SumOfCosts) => Room::sum(&old, horizon),
                Some(Cost::Makespan) => Room::each(horizon.min(best[0])),
                _ => Room::each(horizon),
            };
            let planned = replan(problem, walks, &mut others, &group, room, budget);
            let vector = costs(problem, walks).vector(objective);
            if matches!(planned, Ok(true)) && vector <= best {
                best = vector;
                continue;
            }
            for (&agent, old) in group.iter().zip(old) {
                others.remove(agent, &walks[agent]);
                walks[agent] = old;
            }
            for &agent in &group {
                others.add(agent, &walks[agent]);
            }
            planned?;
        }
        Ok(best < first)
    }

    /// An agent that arrives later than it would alone, and those that it would
    /// meet on a walk that arrives sooner.
    fn choose_group(
        &mut self,
        problem: &Problem,
        walks: &[Walk],
        others: &Reservations,
        horizon: u32,
        budget: &dyn Budget,
    ) -> Result<Option<Vec<AgentId>>, Stop> {
        let delayed: Vec<AgentId> = (0..walks.len())
            .filter(|&a| arrival(&walks[a]) > problem.optima[a])
            .collect();
        if delayed.is_empty() {
            return Ok(None);
        }
        let latest = walks.iter().map(|w| arrival(w)).max().unwrap_or(0);
        // Now and then the agent that makes the makespan.
        let last = delayed
            .iter()
            .copied()
            .find(|&a| arrival(&walks[a]) == latest);
        let seed = match last {
            Some(last) if self.rng.u8(..4) == 0 => last,
            _ => delayed[below(&mut self.rng, delayed.len())],
        };
        let spare = arrival(&walks[seed]) - problem.optima[seed];
        let sooner = problem.optima[seed] + self.rng.u32(..spare);
        let query = Query {
            agent: seed,
            latest: sooner.min(horizon),
            conflict_penalty: Some(1),
            expansion_limit: EXPANSION_LIMIT,
        };
        let mut group = vec![seed];
        if let Some((walk, _)) = plan_one(problem, others, query, budget)? {
            group.extend(others.met_by(seed, &walk));
        }
        let size = (2 + below(&mut self.rng, 7)).max(group.len().min(10));
        group.truncate(size);
        while group.len() < size.min(walks.len()) {
            let other = below(&mut self.rng, walks.len());
            if !group.contains(&other) {
                group.push(other);
            }
        }
        if self.rng.bool() {
            shuffle(&mut self.rng, &mut group);
        }
        Ok(Some(group))
    }
}

/// How late agents that are planned anew may arrive for the plan to be no
/// worse: what cannot be is not searched for, which takes the longest.
#[derive(Clone, Copy)]
struct Room {
    /// The latest arrival of each.
    each: u32,
    /// What their arrivals may be together.
    sum: u32,
}

impl Room {
    /// Each by a time.
    const fn each(latest: u32) -> Self {
        Self {
            each: latest,
            sum: u32::MAX,
        }
    }

    /// Together no later than on these walks.
    fn sum(walks: &[Walk], latest: u32) -> Self {
        Self {
            each: latest,
            sum: walks.iter().map(|walk| arrival(walk)).sum(),
        }
    }
}

/// Plans agents one after the other around all others; false where one finds
/// no way, or none within the room.
fn replan(
    problem: &Problem,
    walks: &mut [Walk],
    others: &mut Reservations,
    group: &[AgentId],
    room: Room,
    budget: &dyn Budget,
) -> Result<bool, Stop> {
    let least: u32 = group.iter().map(|&agent| problem.optima[agent]).sum();
    let mut spare = room.sum.saturating_sub(least);
    for &agent in group {
        let optimum = problem.optima[agent];
        let query = Query {
            agent,
            latest: room.each.min(optimum.saturating_add(spare)),
            conflict_penalty: None,
            expansion_limit: EXPANSION_LIMIT,
        };
        match plan_one(problem, others, query, budget)? {
            Some((walk, _)) => {
                spare = spare.saturating_sub(arrival(&walk).saturating_sub(optimum));
                walks[agent] = walk;
                others.add(agent, &walks[agent]);
            }
            None => return Ok(false),
        }
    }
    Ok(true)
}
