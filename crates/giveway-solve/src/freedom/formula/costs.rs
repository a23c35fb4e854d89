//! The costs of the objective, each at most what the best plan has: together they
//! allow the best plans and no others.

use giveway_model::{Cost, Costs, Objective};

use super::agent::AgentCode;
use crate::{
    budget::Stop,
    encode::{limit::SumLimit, totalizer::capped},
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
            // (No rule of the scene is in force here, so there is no penalty.)
            Cost::Makespan | Cost::Penalty => {}
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
