//! Large neighbourhood search behind the one door: a first plan, made better and better.

use giveway_model::Cost;

use super::{Asked, Best, Halt, Outcome, Report, Trace};
use crate::{
    AgentId,
    budget::{Budget, Stop},
    first::first_plan,
    lns::{Effort, Lns},
    local::apart,
    walk::{Walk, costs},
};

/// States of single agents in one round: about one neighbourhood.
const STATES: u64 = 1_000;
/// Rounds in all, and without a better plan on end.
const ROUNDS: u64 = 20_000;
const IN_VAIN: u64 = 1_000;
/// Improvements that are told.
const TOLD: usize = 1_000;

/// A better plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Improvement {
    /// The agents that got other walks.
    pub changed: Vec<AgentId>,
    /// The costs before, in the order of the objective.
    pub before: Vec<u32>,
    /// The costs after.
    pub after: Vec<u32>,
}

/// Plans by neighbourhoods.
pub(super) fn lns(asked: &Asked, mut best: Best, budget: &dyn Budget) -> Report {
    let mut made = Made {
        rounds: 0,
        improvements: Vec::new(),
    };
    let ended = improve(asked, &mut best, &mut made, budget);
    Report {
        outcome: match ended {
            Ok(()) => Outcome::found(best),
            Err(stop) => Outcome::stopped(Halt::Budget(stop), best),
        },
        steps: made.rounds,
        trace: asked.traced.then_some(Trace::Lns(made.improvements)),
    }
}

struct Made {
    rounds: u64,
    improvements: Vec<Improvement>,
}

fn improve(
    asked: &Asked,
    best: &mut Best,
    made: &mut Made,
    budget: &dyn Budget,
) -> Result<(), Stop> {
    let problem = asked.problem;
    let (horizon, objective) = (asked.horizon(), asked.objective);
    let walks = apart(problem, budget)?;
    let Some((mut walks, _)) = first_plan(problem, walks, horizon, budget)? else {
        return Ok(());
    };
    best.offer(&walks);
    let effort = Effort {
        states: STATES,
        horizon,
        enough: enough(asked),
    };
    let vector = |walks: &[Walk]| costs(problem, walks).vector(objective);
    let mut lns = Lns::default();
    let mut in_vain = 0;
    while made.rounds < ROUNDS && in_vain < IN_VAIN {
        let first = vector(&walks);
        if first.first() <= Some(&effort.enough) {
            break;
        }
        let old = walks.clone();
        // Even where it is stopped, the walks are a plan.
        let improved = lns.improve(problem, &mut walks, effort, objective, budget);
        made.rounds += 1;
        in_vain += 1;
        let after = vector(&walks);
        if after < first {
            in_vain = 0;
            best.offer(&walks);
            if made.improvements.len() < TOLD {
                let changed = (0..walks.len()).filter(|&agent| walks[agent] != old[agent]);
                made.improvements.push(Improvement {
                    changed: changed.collect(),
                    before: first,
                    after,
                });
            }
        }
        improved?;
    }
    Ok(())
}

/// A value of the first cost that no plan is below: what the agents need alone.
fn enough(asked: &Asked) -> u32 {
    let problem = asked.problem;
    let agents = 0..problem.agents();
    match asked.objective.costs().first() {
        Some(Cost::Makespan) => problem.optima.iter().copied().max().unwrap_or(0),
        Some(Cost::SumOfCosts) => agents.map(|agent| problem.least_cost(agent)).sum(),
        _ => 0,
    }
}
