//! Judges a plan that was made by leading robots by hand.

use giveway_model::check::{Rule, Violation, check};
use giveway_model::{Cell, Costs, Instance, Objective, Plan, Scene, ends_with_rest};
use giveway_solve::Response;

use super::proved::{self, Proved};
use super::statement::first_better;
use super::{Judging, Situation, Verdict, Why, ask};
use crate::lesson::task::{Lead, LeadAim};
use crate::port::Evidence;

pub(super) fn begin(task: &Lead, situation: Situation<'_>, plan: &Plan) -> Judging {
    let costs = match judged(task, situation, plan) {
        Ok(costs) => costs,
        Err(verdict) => return (*verdict).into(),
    };
    match &task.aim {
        LeadAim::Legal {} => Verdict::solved(Why::Legal).into(),
        LeadAim::Cost { cost, at_most } => {
            let value = costs.get(*cost);
            let why = Why::Costs {
                cost: *cost,
                value,
                at_most: *at_most,
            };
            Verdict::if_holds(value <= *at_most, why).into()
        }
        LeadAim::Best { objective } => {
            Judging::Ask(vec![ask::solve(situation.scene, objective.as_ref())])
        }
    }
}

pub(super) fn conclude(
    task: &Lead,
    situation: Situation<'_>,
    plan: &Plan,
    responses: &[Response],
) -> Verdict {
    let costs = match judged(task, situation, plan) {
        Ok(costs) => costs,
        Err(verdict) => return *verdict,
    };
    let objective = match &task.aim {
        LeadAim::Best {
            objective: Some(objective),
        } => objective,
        _ => &situation.scene.objective,
    };
    match proved::solved(responses.first()) {
        Ok(Proved::Best(best, _)) => against(objective, &costs, &best),
        // The plan is legal, so this cannot be; it is no reason to say "solved".
        Ok(Proved::NoPlan) => Verdict::not_yet(Why::Unknown(None)),
        Err(why) => Verdict::not_yet(why),
    }
}

fn against(objective: &Objective, costs: &Costs, best: &Costs) -> Verdict {
    let worse = first_better(objective.costs(), costs, best);
    let first = objective.costs().first().copied();
    match (worse, first) {
        (Some(cost), _) => Verdict::not_yet(Why::NotBest {
            cost,
            value: costs.get(cost),
            best: best.get(cost),
        }),
        (None, Some(cost)) => Verdict::solved(Why::Best {
            cost,
            value: costs.get(cost),
        }),
        (None, None) => Verdict::solved(Why::Legal),
    }
}

/// The costs of a plan that keeps all rules, else what is wrong with it.
fn judged(task: &Lead, situation: Situation<'_>, plan: &Plan) -> Result<Costs, Box<Verdict>> {
    let instance = Instance::new(situation.scene.clone());
    let Ok(instance) = instance else {
        return Err(Box::new(Verdict::not_yet(Why::Untouched)));
    };
    if let Some(name) = led_another(task, situation, plan) {
        return Err(Box::new(Verdict::not_like_this(Why::LedAnother(name))));
    }
    let report = check(&instance, plan);
    let mut open = Vec::new();
    for violation in report.violations {
        match violation.rule {
            Rule::Goal | Rule::Waypoint | Rule::Shape => open.push(violation),
            _ if is_past(situation.scene, plan, &violation) => {
                let evidence = Evidence {
                    time: Some(violation.time),
                    violations: vec![violation.clone()],
                    ..Evidence::default()
                };
                let verdict = Verdict::not_like_this(Why::Broken(violation));
                return Err(Box::new(verdict.with(evidence)));
            }
            _ => {}
        }
    }
    // What is left to do: the robots that are not home come first.
    let to_do = |rule: Rule| open.iter().find(move |violation| violation.rule == rule);
    let left = to_do(Rule::Goal).or_else(|| to_do(Rule::Waypoint));
    if let Some(violation) = left.or_else(|| open.first()) {
        let name = violation.agents.first().cloned().unwrap_or_default();
        let why = match violation.rule {
            Rule::Waypoint => Why::NotVisited(name, violation.cell),
            _ => Why::NotHome(name),
        };
        return Err(Box::new(Verdict::not_yet(why)));
    }
    let costs = report.costs;
    costs.ok_or_else(|| Box::new(Verdict::not_yet(Why::Untouched)))
}

/// Whether a broken rule is one of steps that were made, rather than of a robot that is
/// taken to stand where it was led to so far.
fn is_past(scene: &Scene, plan: &Plan, violation: &Violation) -> bool {
    violation.agents.iter().all(|name| {
        let path = plan.path(name);
        let agent = scene.agents.iter().find(|agent| agent.name == *name);
        let goal = agent.and_then(|agent| agent.goal);
        let is_home = goal.is_some() && path.last() == Some(&goal);
        is_home || (violation.time as usize) < path.len()
    })
}

/// A robot that was not to be led, and goes another way than the step's plan has it: where
/// it has no path there, it stands where it starts.
fn led_another(task: &Lead, situation: Situation<'_>, plan: &Plan) -> Option<String> {
    let others = situation.scene.agents.iter();
    let mut others = others.filter(|agent| !task.robots.contains(&agent.name));
    let given = situation.step.plan.as_ref();
    let changed = others.find(|agent| match given {
        Some(given) if !given.path(&agent.name).is_empty() => {
            let charges = |plan: &Plan| plan.charges.get(&agent.name).cloned();
            let charges = (charges(plan), charges(given));
            let paths = [plan.path(&agent.name), given.path(&agent.name)];
            let [path, wanted] = paths.map(|path| without_rest(path, agent.goal));
            charges.0.unwrap_or_default() != charges.1.unwrap_or_default() || path != wanted
        }
        Some(_) | None => {
            let mut cells = plan.path(&agent.name).iter().flatten();
            cells.any(|cell| *cell != agent.start)
        }
    });
    changed.map(|agent| agent.name.clone())
}

/// A path without the steps in which its robot rests at its end.
fn without_rest(path: &[Option<Cell>], goal: Option<Cell>) -> &[Option<Cell>] {
    let mut path = path;
    while ends_with_rest(path, goal) {
        path = path.split_last().map_or(path, |(_, before)| before);
    }
    path
}
