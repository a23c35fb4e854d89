//! A first plan: everyone apart, then collisions repaired.
//!
//! Every agent takes a best walk of its own that meets few others; then small
//! groups of colliding agents are planned anew, never with more collisions than
//! before, until none is left (MAPF-LNS2; Li et al. 2022).

use std::collections::BTreeSet;

use fastrand::Rng;

use super::{Query, Reservations, plan_one};
use crate::{
    encode::collisions::AgentId,
    meter::{Meter, Stop},
    problem::Problem,
    walk::Walk,
};

/// Agents planned anew at once.
const GROUP: usize = 8;
/// States to look at for one agent.
const EFFORT: u32 = 30_000;

/// Each agent at its own optimum, with few collisions.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn apart(problem: &Problem, meter: &Meter) -> Result<Vec<Walk>, Stop> {
    let mut others = Reservations::new(problem);
    let mut walks = Vec::with_capacity(problem.agents());
    for agent in 0..problem.agents() {
        let query = Query {
            agent,
            latest: problem.optima[agent],
            soft: true,
            effort: u32::MAX,
        };
        let walk = plan_one(problem, &others, query, meter)?;
        let walk = walk.map(|(walk, _)| walk).unwrap_or_default();
        others.add(agent, &walk);
        walks.push(walk);
    }
    Ok(walks)
}

/// Repairs walks until no two collide; `None` where that does not succeed soon.
/// No walk is longer than the horizon.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn first_plan(
    problem: &Problem,
    mut walks: Vec<Walk>,
    horizon: u32,
    meter: &Meter,
) -> Result<Option<Vec<Walk>>, Stop> {
    let mut others = Reservations::of(problem, &walks);
    let mut rng = Rng::with_seed(problem.agents() as u64);
    let rounds = 100 + 20 * problem.agents();
    for _ in 0..rounds {
        let colliding: Vec<AgentId> = (0..walks.len())
            .filter(|&agent| !others.met_by(agent, &walks[agent]).is_empty())
            .collect();
        if colliding.is_empty() {
            return Ok(Some(walks));
        }
        let seed = colliding[rng.usize(..colliding.len())];
        let group = choose_group(seed, &others, &walks, &mut rng);
        replan(problem, &mut walks, &mut others, &group, horizon, meter)?;
    }
    Ok(None)
}

/// The agent, those it collides with, those they collide with, up to the size
/// of a group, and others by chance; in random order.
fn choose_group(
    seed: AgentId,
    others: &Reservations,
    walks: &[Walk],
    rng: &mut Rng,
) -> Vec<AgentId> {
    let mut group = vec![seed];
    let mut next = 0;
    while next < group.len() && group.len() < GROUP {
        let agent = group[next];
        next += 1;
        for other in others.met_by(agent, &walks[agent]) {
            if group.len() < GROUP && !group.contains(&other) {
                group.push(other);
            }
        }
    }
    while group.len() < GROUP.min(walks.len()) {
        let other = rng.usize(..walks.len());
        if !group.contains(&other) {
            group.push(other);
        }
    }
    rng.shuffle(&mut group);
    group
}

/// Plans a group anew, one after the other; keeps the old walks where the new
/// ones would collide more.
fn replan(
    problem: &Problem,
    walks: &mut [Walk],
    others: &mut Reservations,
    group: &[AgentId],
    horizon: u32,
    meter: &Meter,
) -> Result<(), Stop> {
    let before = pairs(others, walks, group);
    let old: Vec<Walk> = group.iter().map(|&a| walks[a].clone()).collect();
    for &agent in group {
        others.remove(agent, &walks[agent]);
    }
    for &agent in group {
        let query = Query {
            agent,
            latest: horizon,
            soft: true,
            effort: EFFORT,
        };
        if let Some((walk, _)) = plan_one(problem, others, query, meter)? {
            walks[agent] = walk;
        }
        others.add(agent, &walks[agent]);
    }
    if pairs(others, walks, group) > before {
        for (&agent, old) in group.iter().zip(old) {
            others.remove(agent, &walks[agent]);
            others.add(agent, &old);
            walks[agent] = old;
        }
    }
    Ok(())
}

/// The pairs of colliding agents of which one is in the group.
fn pairs(others: &Reservations, walks: &[Walk], group: &[AgentId]) -> usize {
    let mut pairs = BTreeSet::new();
    for &agent in group {
        for other in others.met_by(agent, &walks[agent]) {
            pairs.insert((agent.min(other), agent.max(other)));
        }
    }
    pairs.len()
}
