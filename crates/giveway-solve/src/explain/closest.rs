//! The other plan that is closest to the one asked about.

use std::rc::Rc;

use giveway_model::{Cell, Costs, Instance, Plan, check::check};

use super::verdict::Case;
use crate::{
    Limits,
    budget::Budget,
    counterfactual::Counterfactual,
    problem::{Problem, Relaxed},
    search::{Before, Bounded, Extent, Horizon, Reach, closest as search_closest},
    single::Place,
    walk::to_plan,
};
use giveway_model::sorting::{map, sort};

/// Clauses that it may derive, and seconds that it may take.
const DERIVED: u64 = 20_000;
const SECONDS: f64 = 3.0;

/// Of the plans that cost as much as the best other one, that which is closest
/// to the plan asked about, and whether that is proved.
pub(crate) fn closest(case: &Case, best: (&Plan, Costs), budget: &Rc<Budget>) -> (Plan, bool) {
    let part = Rc::new(
        budget
            .part(Limits {
                seconds: Some(SECONDS),
                ..Limits::default()
            })
            .with_derived(DERIVED),
    );
    let mut proved = true;
    let mut nearest = (distance(case, best.0), best.0.clone());
    for condition in case.conditions.iter() {
        match with(case, condition, best.1, &part) {
            Attempt::Plan(plan, is_proved) => {
                proved &= is_proved;
                let distance = distance(case, &plan);
                if distance < nearest.0 {
                    nearest = (distance, plan);
                }
            }
            Attempt::None => {}
            Attempt::Unknown => proved = false,
        }
    }
    budget.absorb(&part);
    (nearest.1, proved)
}

/// What one way to be as asked for gives.
enum Attempt {
    /// A plan, and whether none is closer.
    Plan(Plan, bool),
    /// None costs so little.
    None,
    Unknown,
}

fn with(case: &Case, condition: &Counterfactual, costs: Costs, budget: &Rc<Budget>) -> Attempt {
    let instance = case.instance;
    let problem = Problem::relaxed(instance, Relaxed::default(), Some(condition), budget);
    let Ok(mut problem) = problem else {
        return match budget.check() {
            Ok(()) => Attempt::None, // the agent alone cannot
            Err(_) => Attempt::Unknown,
        };
    };
    case.past.wake(instance, &mut problem);
    let grid = instance.grid();
    // Where a horizon is far away, closer plans beyond the default are not worth
    // the search; then that none is closer is not claimed.
    let near = problem
        .default_horizon(grid)
        .max(case.costs.makespan)
        .max(costs.makespan);
    let horizon = Horizon::of(&problem, grid, case.within, case.costs.makespan).up_to(near);
    let objective = case.objective().costs().iter();
    let mut limits = map(objective.map(|&cost| (cost, costs.get(cost))));
    if condition.limit_costs(&mut limits).is_err() {
        return Attempt::None;
    }
    let Some(before) = before(&problem, instance, case.plan) else {
        return Attempt::Unknown;
    };
    let bounded = Bounded { horizon, limits };
    if (0..problem.agents()).any(|a| problem.optima[a] > problem.not_after(a).min(horizon.latest()))
    {
        return Attempt::None;
    }
    match search_closest(&problem, &before, &bounded, Extent::Entries, budget) {
        Ok(None) => Attempt::None,
        Err(_) => Attempt::Unknown,
        Ok(Some(close)) => {
            let names: Vec<String> = instance.agents().iter().map(|a| a.name.clone()).collect();
            let mut plan = to_plan(&problem, &names, &close.walks);
            for (name, same) in names.iter().zip(close.same) {
                let charges = case.plan.charges(name);
                if same && !charges.is_empty() {
                    plan.charges.insert(name.clone(), charges.to_vec());
                }
            }
            let report = check(instance, &plan);
            let as_good = case
                .past
                .costs(instance, &plan)
                .is_some_and(|own| own.vector(case.objective()) == costs.vector(case.objective()));
            if report.is_valid() && as_good && condition.is_met_by(instance, &plan) {
                let far = |proved: Reach| case.shown.is_some_and(|shown| proved.covers(shown));
                Attempt::Plan(plan, close.proved.is_some_and(far))
            } else {
                Attempt::Unknown
            }
        }
    }
}

/// A valid plan as walks.
fn before(problem: &Problem, instance: &Instance, plan: &Plan) -> Option<Vec<Before>> {
    let mut plan = plan.clone();
    plan.cut_trailing_goals(instance);
    let terrain = &problem.terrain;
    let agents = instance.agents().iter();
    let each = agents.map(|agent| {
        let path = plan.path(&agent.name);
        let mut walk = Vec::with_capacity(path.len());
        for (time, entry) in path.iter().enumerate() {
            if let Some(cell) = entry {
                walk.push(Place::At(terrain.vertex(*cell)?));
                continue;
            }
            let from = terrain.vertex(path.get(time.checked_sub(1)?).copied()??)?;
            let to = terrain.vertex(path.get(time + 1).copied()??)?;
            let arc = terrain.arcs(from).iter().find(|arc| arc.to == to)?;
            walk.push(Place::Along(arc.id));
        }
        let mut charges = plan.charges(&agent.name).to_vec();
        sort(&mut charges);
        Some(Before { walk, charges })
    });
    each.collect()
}

/// How far a plan is from the one asked about: agents that do something else,
/// then entries that differ, arrived agents padded.
fn distance(case: &Case, other: &Plan) -> (usize, usize) {
    let (mut agents, mut entries) = (0, 0);
    for agent in case.instance.agents() {
        let (a, b) = (case.plan.path(&agent.name), other.path(&agent.name));
        let at = |path: &[Option<Cell>], time: usize| {
            path.get(time).copied().unwrap_or(Some(agent.goal))
        };
        let times = 0..a.len().max(b.len());
        let differ = times.filter(|&time| at(a, time) != at(b, time)).count();
        let recharged = case.plan.charges(&agent.name) != other.charges(&agent.name);
        agents += usize::from(differ > 0 || recharged);
        entries += differ;
    }
    (agents, entries)
}
