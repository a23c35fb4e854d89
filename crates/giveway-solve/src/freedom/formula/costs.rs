//! The costs of the objective, each at most what the best plan has: together they
//! allow the best plans and no others.

use std::collections::BTreeSet;

use giveway_model::{Cost, Costs, Objective};

use super::agent::AgentCode;
use crate::{
    budget::Stop,
    encode::{limit::SumLimit, totalizer::capped, weighted::WeightedCounter},
    problem::Problem,
    sat::{Clauses, Lit, Sat},
    single::Place,
};

/// Writes the limits. The makespan needs none: it is in the caps.
///
/// # Errors
/// When the budget is spent.
pub(super) fn limit(
    problem: &Problem,
    agents: &[AgentCode],
    (objective, best): (&Objective, &Costs),
    out: &mut Sat,
) -> Result<(), Stop> {
    for &cost in objective.costs() {
        let most = best.get(cost);
        match cost {
            Cost::Makespan => {}
            Cost::Penalty => penalty(problem, agents, most, out)?,
            Cost::SumOfCosts => {
                let total: u32 = problem.optima.iter().sum();
                let mut sum = SumLimit::new(most.saturating_sub(total) as usize);
                for (code, &optimum) in agents.iter().zip(&problem.optima) {
                    // Digit d: it arrives more than d steps after its optimum.
                    let delays = (optimum..code.cap).map(|time| !code.by(time));
                    sum.add(&delays.collect::<Vec<Lit>>(), out)?;
                }
            }
            Cost::Charges | Cost::Moves | Cost::Waits => {
                let mut sum = SumLimit::new(most as usize);
                for code in agents {
                    let events = events(code, cost, out);
                    let digits = capped(&events, most as usize + 1, out)?;
                    sum.add(&digits, out)?;
                }
            }
        }
    }
    Ok(())
}

/// Counters of a penalty with more entries than this are not written.
const MOST_ENTRIES: usize = 4_000_000;

/// The penalty of all agents, in units; late steps up to their optima are certain.
fn penalty(problem: &Problem, agents: &[AgentCode], most: u32, out: &mut Sat) -> Result<(), Stop> {
    let unit = problem.penalty_unit();
    let mut counter = WeightedCounter::default();
    let (mut certain, mut row) = (0_u32, 0);
    let mut weights = BTreeSet::new();
    for (agent, code) in agents.iter().enumerate() {
        let (task, optimum) = (&problem.tasks[agent], problem.optima[agent]);
        certain = certain.saturating_add(task.penalty_of_time(0, optimum));
        for (places, time) in code.places.iter().zip(0..code.cap) {
            let is_certain = if time < optimum {
                task.penalty_of_time(time, time + 1)
            } else {
                0
            };
            for (&place, &here) in places {
                let all = task.penalty_at(&problem.terrain, place, time);
                let weight = all.saturating_sub(is_certain) / unit;
                if weight > 0 {
                    let event = counter.event(row, weight, out);
                    out.clause(&[!here, code.by(time), event]);
                    weights.insert(weight);
                }
            }
            row += 1;
        }
    }
    let most = most.saturating_sub(certain) / unit;
    let columns = reachable(most, &weights, MOST_ENTRIES / (row as usize).max(1));
    if columns.is_none() {
        return Err(Stop::Memory);
    }
    let more = counter.more_than(most, out);
    out.clause(&[!more]);
    Ok(())
}

/// The amounts from which weights lead up to an amount; `None` where there are too many.
fn reachable(most: u32, weights: &BTreeSet<u32>, limit: usize) -> Option<BTreeSet<u32>> {
    let mut amounts = BTreeSet::from([most]);
    let mut open = vec![most];
    while let Some(amount) = open.pop() {
        let less = weights
            .iter()
            .map_while(|weight| amount.checked_sub(*weight));
        open.extend(less.filter(|&less| amounts.insert(less)));
        if amounts.len() > limit {
            return None;
        }
    }
    Some(amounts)
}

/// Literals that hold when an agent charges, moves or waits at a time.
fn events(code: &AgentCode, cost: Cost, out: &mut Sat) -> Vec<Lit> {
    if cost == Cost::Charges {
        return code.charges.values().copied().collect();
    }
    let mut events = Vec::new();
    for time in 0..code.cap {
        let event = out.fresh();
        events.push(event);
        let Some(places) = code.places.get(time as usize) else {
            continue;
        };
        for (&place, &here) in places {
            if matches!(place, Place::Along(_)) {
                continue; // the second half of a move
            }
            let stands = code.at(time + 1, place);
            // It may have arrived, and be gone.
            let mut clause = vec![!here, event, code.by(time)];
            match (cost, stands) {
                (Cost::Moves, stands) => clause.extend(stands),
                (_, Some(stands)) => clause.push(!stands),
                (_, None) => continue,
            }
            out.clause(&clause);
        }
    }
    events
}
