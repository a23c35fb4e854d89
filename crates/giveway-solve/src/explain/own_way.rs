//! The witness of an agent's own way: it does as asked, all others do as in the plan. Of its best walks, one
//! that breaks the fewest rules.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{
    Condition, Cost, Objective, Plan, Question,
    check::{Violation, arrivals, own_costs},
};

use super::{
    ask::{Ask, best, names, walks},
    fitting::FittingQuestion,
    lone_walk::{lone_walk, problem_of_one, replaced},
    losses::loss,
    waits,
};
use crate::{budget::Budget, problem::Relaxed, walk::to_plan};

/// The witness and its agent; `None` where the agent alone cannot do what is asked for, or the question has
/// no agent.
pub(crate) fn witness(
    case: &FittingQuestion,
    budget: &Rc<Budget>,
) -> Option<(String, Vec<Violation>)> {
    if let Question::Wait { agent, .. } = case.question {
        let violations = waits::witness(case.instance, case.question, case.plan, case.whole);
        return Some((agent.clone(), violations));
    }
    let own = about_agent(case, budget);
    let all = case.conditions().filter(|_| own.is_none());
    let mut found: Option<(usize, String, Vec<Violation>)> = None;
    for condition in own.iter().chain(all) {
        let Some(agent) = condition.agent() else {
            continue;
        };
        let Some(other) = moved(case, condition, agent, budget) else {
            continue;
        };
        let violations = case.whole.check(case.instance, &other);
        let count = violations.len();
        if found.as_ref().is_none_or(|(fewest, ..)| count < *fewest) {
            found = Some((count, agent.to_owned(), violations));
        }
    }
    found.map(|(_, agent, violations)| (agent, violations))
}

/// A condition on a cost of all, as one on the agent that it is due to: with the sum of costs the one that
/// loses most, to arrive sooner.
fn about_agent(case: &FittingQuestion, budget: &Rc<Budget>) -> Option<Condition> {
    let cost = match case.conditions().next()? {
        Condition::Below {
            agent: None, cost, ..
        } => *cost,
        Condition::Below { agent: Some(_), .. }
        | Condition::Never { .. }
        | Condition::Visit { .. }
        | Condition::Move { .. }
        | Condition::Charge { .. }
        | Condition::Before { .. }
        | Condition::Keeps(_) => return None,
    };
    let own = |name: &str, cost: Cost| {
        own_costs(case.instance, name, case.plan).map_or(0, |costs| costs.get(cost))
    };
    let (agent, less) = match cost {
        Cost::SumOfCosts => (loss(case, budget)?.agent, Cost::Makespan),
        Cost::Makespan | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => {
            // The first of those with the most.
            let agents = case.instance.agents().iter().rev();
            let agent = agents.max_by_key(|agent| own(&agent.name, cost))?;
            (agent.name.clone(), cost)
        }
    };
    let limit = own(&agent, less);
    (limit > 0).then_some(Condition::Below {
        agent: Some(agent),
        cost: less,
        limit,
    })
}

/// The plan with another walk of one agent that is as asked for.
fn moved(
    case: &FittingQuestion,
    condition: &Condition,
    agent: &str,
    budget: &Rc<Budget>,
) -> Option<Plan> {
    let among = among_others(case, condition, agent, budget);
    let is_met = |plan: &Plan| condition.holds(case.instance, plan) == Some(true);
    among
        .filter(is_met)
        .or_else(|| alone(case, condition, agent, budget).filter(is_met))
}

/// The earliest walk with the fewest collisions. What counts over a whole walk
/// it keeps by chance only.
fn among_others(
    case: &FittingQuestion,
    condition: &Condition,
    agent: &str,
    budget: &Rc<Budget>,
) -> Option<Plan> {
    let instance = case.instance;
    let index = instance.agents().iter().position(|a| a.name == agent)?;
    let problem = problem_of_one(instance, case.plan, (index, Some(condition)), budget)?;
    let mut walks = walks(instance, &problem, case.plan)?;
    let latest = arrivals(instance, case.plan).into_iter().flatten().max();
    let latest = latest
        .unwrap_or(0)
        .max(problem.default_horizon(instance.grid()));
    walks[index] = lone_walk(&problem, &walks, (index, latest), budget).ok()??;
    let other = to_plan(&problem, &names(instance), &walks);
    Some(replaced(case.plan, agent, &other))
}

/// The best walk of the agent alone, whatever it meets.
fn alone(
    case: &FittingQuestion,
    condition: &Condition,
    agent: &str,
    budget: &Rc<Budget>,
) -> Option<Plan> {
    let instance = case.instance.alone(agent)?;
    let objective: &Objective = case.objective();
    let found = best(
        &Ask {
            instance: &instance,
            relaxed: &Relaxed::default(),
            conditions: std::slice::from_ref(condition),
            objective,
            caps: &BTreeMap::new(),
            within: case.within,
            at_least_within: case.costs.makespan,
        },
        budget,
    );
    Some(replaced(case.plan, agent, &found.plan?))
}
