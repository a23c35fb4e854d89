//! What an agent loses beside its earliest arrival alone: of a question about a cost of all agents, the agent
//! that its answer begins with.

use std::rc::Rc;

use giveway_model::{Question, check::arrivals};

use super::{
    ask::{names, walks},
    fitting::FittingQuestion,
    lone_walk::{lone_walk, problem_of_one},
};
use crate::{
    budget::Budget,
    problem::Problem,
    walk::{Walk, arrival},
};

/// When an agent arrives, and when it could alone; both in time steps of the whole plan.
pub(crate) struct Loss {
    pub(crate) agent: String,
    pub(crate) arrival: u32,
    /// Its waypoints, battery and own rules kept.
    pub(crate) alone: u32,
}

/// Of the makespan the agent that arrives last, of the sum of costs the one that loses most: the first of
/// several. `None` of other questions.
pub(crate) fn loss(case: &FittingQuestion, budget: &Rc<Budget>) -> Option<Loss> {
    let is_of_last = match case.question {
        Question::Makespan => true,
        Question::SumOfCosts => false,
        Question::Wait { .. }
        | Question::Yield { .. }
        | Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Slow { .. }
        | Question::Order { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Penalty
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => return None,
    };
    // The first of those that arrive last.
    let arrivals = arrivals(case.instance, case.plan);
    let last = (0..arrivals.len()).rev();
    let last = last.max_by_key(|&agent| arrivals.get(agent).copied().flatten())?;
    let problem = if is_of_last {
        problem_of_one(case.instance, case.plan, (last, None), budget)?
    } else {
        Problem::new(case.instance, budget).ok()?
    };
    let walks = walks(case.instance, &problem, case.plan)?;
    let alone = |(agent, walk): (usize, &Walk)| {
        let own = arrival(walk);
        let lone = lone_walk(&problem, &walks, (agent, own), budget).ok()??;
        Some((own, arrival(&lone), agent))
    };
    let (own, alone, agent) = if is_of_last {
        alone((last, walks.get(last)?))
    } else {
        // The first of those with the most.
        let all: Option<Vec<_>> = walks.iter().enumerate().rev().map(alone).collect();
        let lost = |it: &(u32, u32, usize)| it.0.saturating_sub(it.1);
        all?.into_iter().max_by_key(lost)
    }?;
    Some(Loss {
        agent: names(case.instance).into_iter().nth(agent)?,
        arrival: case.whole.time(own),
        alone: case.whole.time(alone),
    })
}
