//! What would happen if an agent did as is asked for, and all others as in the
//! plan: its own best walk, and of these one that breaks the fewest rules.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{
    Cell, Cost, Objective, Path, Plan, Question,
    check::{Violation, arrivals},
};

use super::{ask::Ask, ask::best, own_plan::own_costs, verdict::Case, waits};
use crate::{
    budget::Budget,
    counterfactual::{Counterfactual, Counterfactuals},
    local::{Others, Query, Reservations, plan_one},
    problem::{Problem, Relaxed},
    single::Place,
    terrain::Terrain,
    walk::{Walk, to_plan},
};

/// What would happen, and to whom; `None` where the agent alone cannot do what
/// is asked for, or nobody is asked about.
pub(crate) fn witness(case: &Case, budget: &Rc<Budget>) -> Option<(String, Vec<Violation>)> {
    if let Question::Wait { agent, .. } = case.question {
        let violations = waits::witness(case.instance, case.question, case.plan, case.past);
        return Some((agent.clone(), violations));
    }
    let conditions = match about_agent(case) {
        Some(question) => Counterfactuals::of(&question, case.instance, case.plan, case.past),
        None => case.conditions.clone(),
    };
    let mut found: Option<(usize, String, Vec<Violation>)> = None;
    for condition in conditions.iter() {
        let Some(agent) = condition.agent() else {
            continue;
        };
        let Some(other) = moved(case, condition, agent, budget) else {
            continue;
        };
        let violations = case.past.check(case.instance, &other);
        let count = violations.len();
        if found.as_ref().is_none_or(|(fewest, ..)| count < *fewest) {
            found = Some((count, agent.to_owned(), violations));
        }
    }
    found.map(|(_, agent, violations)| (agent, violations))
}

/// A question about a cost of all, as one about the agent that it is due to.
fn about_agent(case: &Case) -> Option<Question> {
    let most = |value: &dyn Fn(&str) -> u32| {
        let agents = case.instance.agents().iter();
        // The first of those with the most.
        let best = agents.rev().max_by_key(|agent| value(&agent.name))?;
        (value(&best.name) > 0).then(|| best.name.clone())
    };
    let own = |name: &str, cost: Cost| {
        own_costs(case.instance, name, case.plan).map_or(0, |costs| costs.get(cost))
    };
    let by = |cost: Cost| most(&|name: &str| own(name, cost));
    match case.question {
        Question::Makespan => by(Cost::Makespan).map(|agent| Question::Arrival { agent }),
        Question::SumOfCosts => by(Cost::Waits).map(|agent| Question::Arrival { agent }),
        Question::Charges { agent: None } => {
            let agent = by(Cost::Charges);
            agent.map(|agent| Question::Charges { agent: Some(agent) })
        }
        Question::Moves { agent: None } => {
            let agent = by(Cost::Moves);
            agent.map(|agent| Question::Moves { agent: Some(agent) })
        }
        Question::Waits { agent: None } => {
            let agent = by(Cost::Waits);
            agent.map(|agent| Question::Waits { agent: Some(agent) })
        }
        _ => None,
    }
}

/// The plan with another walk of one agent that is as asked for.
fn moved(
    case: &Case,
    condition: &Counterfactual,
    agent: &str,
    budget: &Rc<Budget>,
) -> Option<Plan> {
    let among = among_others(case, condition, agent, budget);
    let is_met = |plan: &Plan| condition.is_met_by(case.instance, plan);
    among
        .filter(is_met)
        .or_else(|| alone(case, condition, agent, budget).filter(is_met))
}

/// The earliest walk with the fewest collisions. What counts over a whole walk
/// it keeps by chance only.
fn among_others(
    case: &Case,
    condition: &Counterfactual,
    agent: &str,
    budget: &Rc<Budget>,
) -> Option<Plan> {
    let instance = case.instance;
    let problem = Problem::relaxed(instance, Relaxed::default(), Some(condition), budget).ok()?;
    let index = instance.agents().iter().position(|a| a.name == agent)?;
    let mut others = Reservations::new(&problem);
    let mut walks: Vec<Walk> = Vec::new();
    for (i, other) in instance.agents().iter().enumerate() {
        let path = case.plan.path(&other.name);
        let walk = walk_of(&problem.terrain, path, other.goal)?;
        if i != index {
            others.add(i, &walk);
        }
        walks.push(walk);
    }
    let latest = arrivals(instance, case.plan).into_iter().flatten().max();
    let query = Query {
        agent: index,
        latest: latest
            .unwrap_or(0)
            .max(problem.default_horizon(instance.grid())),
        conflict_penalty: Some(0),
        expansion_limit: u32::MAX,
    };
    let (walk, _) = plan_one(&problem, &others, query, budget).ok()??;
    walks[index] = walk;
    let names: Vec<String> = instance.agents().iter().map(|a| a.name.clone()).collect();
    Some(replaced(
        case.plan,
        agent,
        &to_plan(&problem, &names, &walks),
    ))
}

/// The best walk of the agent alone, whatever it meets.
fn alone(
    case: &Case,
    condition: &Counterfactual,
    agent: &str,
    budget: &Rc<Budget>,
) -> Option<Plan> {
    let instance = case.instance.alone(agent)?;
    let objective: &Objective = case.objective();
    let found = best(
        &Ask {
            instance: &instance,
            relaxed: &Relaxed::default(),
            condition: condition.limit().is_none().then_some(condition),
            objective,
            caps: &BTreeMap::new(),
            within: case.within,
            at_least_within: case.costs.makespan,
            past: case.past,
        },
        budget,
    );
    Some(replaced(case.plan, agent, &found.plan?))
}

/// A plan with the way of one agent taken from another.
fn replaced(plan: &Plan, agent: &str, other: &Plan) -> Plan {
    let mut plan = plan.clone();
    plan.paths
        .insert(agent.to_owned(), other.path(agent).to_vec());
    let charges = other.charges(agent).to_vec();
    if charges.is_empty() {
        plan.charges.remove(agent);
    } else {
        plan.charges.insert(agent.to_owned(), charges);
    }
    plan
}

/// A path of a valid plan, as the search sees it.
pub(crate) fn walk_of(terrain: &Terrain, path: &[Option<Cell>], goal: Cell) -> Option<Walk> {
    let mut path: Path = path.to_vec();
    while path.len() >= 2 && path.ends_with(&[Some(goal), Some(goal)]) {
        path.pop();
    }
    let vertex = |time: usize| terrain.vertex(path.get(time).copied().flatten()?);
    let place = |(time, entry): (usize, &Option<Cell>)| {
        if let Some(cell) = entry {
            return terrain.vertex(*cell).map(Place::At);
        }
        let (from, to) = (vertex(time.checked_sub(1)?)?, vertex(time + 1)?);
        let mut arcs = terrain.arcs(from).iter();
        arcs.find(|arc| arc.to == to)
            .map(|arc| Place::Along(arc.id))
    };
    path.iter().enumerate().map(place).collect()
}
