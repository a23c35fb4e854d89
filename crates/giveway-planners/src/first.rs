//! Initial plan: prioritised planning, then LaCAM, then repair.
//!
//! Prioritised planning, in a few orders, is fast and mostly finds a plan. Where it
//! does not, LaCAM moves all agents at once, if they have nothing but goals; else
//! collisions are repaired in small groups.

use crate::{
    AgentId,
    budget::{Budget, CountedBudget, Stop},
    lacam::{Options, lacam},
    local::repair,
    plain::Plain,
    prioritised::{Ended, Order, prioritised},
    problem::Problem,
    walk::{Walk, arrival},
};

/// Orders in which agents are planned one after the other: LaCAM is as fast as one
/// order, and mostly finds a plan, but not for all that agents have to do.
const ORDERS: u32 = 4;
const PLAIN_ORDERS: u32 = 1;
/// The same where rules of a scene's own keep others from filling the gaps: who has to pass a zone
/// before others rest in it is found out by trying.
const ORDERS_UNDER_RULES: u32 = 40;
/// States of single agents that they may look at, for each agent.
const STATES_PER_AGENT: u64 = 30_000;
/// Configurations that LaCAM makes, for each agent.
const STEPS_PER_AGENT: u64 = 2_000;

/// The planner of the first plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum First {
    /// Agents planned one after the other.
    Prioritised,
    /// LaCAM.
    Lacam,
    /// Collisions repaired in small groups.
    Repair,
}

/// A plan and who had it, from walks of each agent apart that may collide; `None` where none is
/// found soon. No walk is longer than the horizon.
///
/// # Errors
/// When the budget is spent.
pub fn first_plan(
    problem: &Problem,
    apart: Vec<Walk>,
    horizon: u32,
    budget: &dyn Budget,
) -> Result<Option<(Vec<Walk>, First)>, Stop> {
    let tries = match Plain::new(problem) {
        Ok(_) => PLAIN_ORDERS,
        Err(_) if problem.is_constrained => ORDERS_UNDER_RULES,
        Err(_) => ORDERS,
    };
    let states = STATES_PER_AGENT.saturating_mul(problem.agents() as u64);
    let part = CountedBudget::new(budget, states);
    match prioritised(problem, &Order::Found { tries }, horizon, false, &part).ended {
        Ended::Found(walks) => return Ok(Some((walks, First::Prioritised))),
        Ended::NoOrderWorks(_) => {}
        Ended::Stopped(_) => budget.check()?, // (else only this part is spent)
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
        if let Some(walks) = found {
            return Ok(Some((walks, First::Lacam)));
        }
    }
    let repaired = repair(problem, apart, horizon, budget)?;
    Ok(repaired.map(|walks| (walks, First::Repair)))
}

/// A plan in which agents are planned in an order, or in one of a few like it; `None` where none is found soon. No
/// walk is longer than the horizon.
///
/// # Errors
/// When the budget is spent.
pub fn plan_in_order(
    problem: &Problem,
    first: Vec<AgentId>,
    horizon: u32,
    budget: &dyn Budget,
) -> Result<Option<Vec<Walk>>, Stop> {
    let states = STATES_PER_AGENT.saturating_mul(problem.agents() as u64);
    let part = CountedBudget::new(budget, states);
    let order = Order::From {
        first,
        tries: ORDERS_UNDER_RULES,
    };
    match prioritised(problem, &order, horizon, false, &part).ended {
        Ended::Found(walks) => return Ok(Some(walks)),
        Ended::NoOrderWorks(_) => {}
        Ended::Stopped(_) => budget.check()?, // (else only this part is spent)
    }
    Ok(None)
}
