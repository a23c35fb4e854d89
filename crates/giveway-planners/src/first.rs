//! A first plan, by whoever has one first.
//!
//! Agents that are planned one after the other mostly find their way, and fast:
//! tried in a few orders. Where they do not, LaCAM moves all of them at once, if
//! they have nothing but goals; else collisions are repaired in small groups.

use fastrand::Rng;

use crate::{
    AgentId,
    budget::{Budget, Stop},
    chance::below,
    lacam::{Options, lacam},
    local::{Others, Query, Reservations, Timetable, repair},
    plain::Plain,
    problem::Problem,
    walk::{Walk, arrival},
};

/// Orders in which agents are planned one after the other.
const ORDERS: usize = 3;
/// States to look at for one agent.
const EXPANSION_LIMIT: u32 = 30_000;
/// Configurations that LaCAM makes, for each agent.
const STEPS_PER_AGENT: u64 = 2_000;

/// A plan, from walks of each agent apart that may collide; `None` where none is
/// found soon. No walk is longer than the horizon.
///
/// # Errors
/// When the budget is spent.
pub fn first_plan(
    problem: &Problem,
    apart: Vec<Walk>,
    horizon: u32,
    budget: &dyn Budget,
) -> Result<Option<Vec<Walk>>, Stop> {
    let mut rng = Rng::with_seed(problem.agents() as u64);
    // LaCAM is as fast as one order, and mostly finds a plan.
    let plain = Plain::new(problem).is_ok();
    for _ in 0..if plain { 1 } else { ORDERS } {
        if let Some(walks) = one_by_one(problem, &order(problem, &mut rng), horizon, budget)? {
            return Ok(Some(walks));
        }
    }
    let options = Options {
        step_limit: STEPS_PER_AGENT.saturating_mul(problem.agents() as u64),
        guided: true,
        first_only: true,
        told: 0,
    };
    if let Ok(report) = lacam(problem, options, budget, &mut |_| {}) {
        budget.check()?;
        let in_time = |walks: &Vec<Walk>| walks.iter().all(|walk| arrival(walk) <= horizon);
        let found = report.best.map(|found| found.walks).filter(in_time);
        if found.is_some() {
            return Ok(found);
        }
    }
    repair(problem, apart, horizon, budget)
}

/// Those with the longest ways first, about.
fn order(problem: &Problem, rng: &mut Rng) -> Vec<AgentId> {
    let mut agents: Vec<(usize, AgentId)> = problem
        .optima
        .iter()
        .enumerate()
        .map(|(agent, &optimum)| {
            let optimum = optimum as usize;
            (optimum + below(rng, optimum / 2 + 1), agent)
        })
        .collect();
    giveway_model::sorting::sort_by_key(&mut agents, |&(length, agent)| {
        (std::cmp::Reverse(length), agent)
    });
    agents.into_iter().map(|(_, agent)| agent).collect()
}

/// Prioritised planning (Erdmann and Lozano-Pérez 1987); `None` where somebody
/// finds no way around those before it.
fn one_by_one(
    problem: &Problem,
    order: &[AgentId],
    horizon: u32,
    budget: &dyn Budget,
) -> Result<Option<Vec<Walk>>, Stop> {
    match Timetable::new(problem) {
        Some(table) => among(table, order, horizon, budget),
        None => among(Reservations::new(problem), order, horizon, budget),
    }
}

fn among(
    mut others: impl Others,
    order: &[AgentId],
    horizon: u32,
    budget: &dyn Budget,
) -> Result<Option<Vec<Walk>>, Stop> {
    let mut walks = vec![Walk::new(); order.len()];
    for &agent in order {
        let query = Query {
            agent,
            latest: horizon,
            conflict_penalty: None,
            expansion_limit: EXPANSION_LIMIT,
        };
        let Some((walk, _)) = others.plan(query, budget)? else {
            return Ok(None);
        };
        others.add(agent, &walk);
        walks[agent] = walk;
    }
    Ok(Some(walks))
}
