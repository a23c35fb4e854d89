//! What rules of a scene's own do: their price, the one that leaves no plan, who is first.
//!
//! All of it is told by the best plans of the scene and of the same scene with one rule less
//! or with some rules more. Where one of them is not proved, nothing is said.

use giveway_model::condition::Visit;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint, Scene};
use giveway_solve::{Request, Response};

use super::predict::Truth;
use super::proved::{self, Proved};
use super::statement::first_better;
use super::{Why, ask};
use crate::lesson::Value;
use crate::port::{Evidence, RulePrice, WithoutRule};

/// A rule's price: the first cost of the best plan without it, and with it.
pub(super) struct Price {
    pub(super) why: Why,
    pub(super) steps: u32,
    pub(super) evidence: Evidence,
}

/// The requests for a price.
pub(super) fn ask_price(scene: &Scene, rule: u32) -> Vec<Request> {
    vec![ask::solve(scene, None), ask::without(scene, rule)]
}

/// A rule's price.
///
/// # Errors
/// Where there is no plan with the rule, so no price, or where it is not known.
pub(super) fn price(scene: &Scene, rule: u32, responses: &[Response]) -> Result<Price, Why> {
    // A rule may be gone with what was edited.
    if !in_force(scene).any(|it| it == rule) {
        return Err(Why::Unclear);
    }
    let with = proved::solved(responses.first())?;
    let without = proved::solved(responses.get(1))?;
    let (Proved::Best(with, plan), Proved::Best(without, plan_without)) = (with, without) else {
        return Err(Why::NoPlan);
    };
    let first = scene.objective.costs().first().copied();
    let cost = first.ok_or(Why::Unknown(None))?;
    let (with, without) = (with.get(cost), without.get(cost));
    Ok(Price {
        why: Why::Price {
            rule,
            cost,
            with,
            without,
        },
        // With one rule more, the first cost of the best plan is never less.
        steps: with.saturating_sub(without),
        evidence: Evidence {
            without: Some(Box::new(WithoutRule {
                rule,
                plan: plan_without.clone(),
                price: Some(RulePrice {
                    cost,
                    with,
                    without,
                }),
            })),
            ..proved::best_plan(plan)
        },
    })
}

/// The rules in force, by their numbers.
fn in_force(scene: &Scene) -> impl Iterator<Item = u32> + '_ {
    scene.constraints_in_force().map(|rule| rule.index as u32)
}

/// The requests for the rule that leaves no plan: with all rules, and without each one.
pub(super) fn ask_deciding(scene: &Scene) -> Vec<Request> {
    let without = in_force(scene).map(|rule| ask::without(scene, rule));
    std::iter::once(ask::solve(scene, None))
        .chain(without)
        .collect()
}

/// The only rule without which there is a plan.
pub(super) fn deciding(scene: &Scene, responses: &[Response]) -> Truth {
    if let Proved::Best(costs, _) = proved::solved(responses.first())? {
        return Err(Why::Plan(costs));
    }
    let mut found = None;
    for (rule, response) in in_force(scene).zip(1..) {
        if let Proved::Best(_, plan) = proved::solved(responses.get(response))? {
            if found.is_some() {
                return Err(Why::Unclear);
            }
            found = Some((rule, plan));
        }
    }
    let (rule, plan) = found.ok_or(Why::Unclear)?;
    let without = WithoutRule {
        rule,
        plan: plan.clone(),
        price: None,
    };
    let evidence = Evidence {
        without: Some(Box::new(without)),
        ..Evidence::default()
    };
    Ok((Value::Rule { rule }, evidence))
}

/// The requests for who is first at a cell: the best plan, and the best one in which each
/// robot is there before all others.
pub(super) fn ask_first(scene: &Scene, cell: Cell) -> Vec<Request> {
    let first = scene.agents.iter().map(|first| {
        let mut forced = scene.clone();
        let at = |agent: &str| Visit {
            agent: agent.to_owned(),
            cell,
        };
        let others = scene.agents.iter().filter(|agent| agent.name != first.name);
        forced.constraints.extend(others.map(|second| Constraint {
            kind: ConstraintKind::Before {
                first: at(&first.name),
                second: at(&second.name),
            },
            agents: None,
            name: None,
            off: false,
        }));
        ask::solve(&forced, None)
    });
    std::iter::once(ask::solve(scene, None))
        .chain(first)
        .collect()
}

/// The only robot that can be first at the cell in a best plan. Where nobody has to be
/// there, every robot can.
pub(super) fn first(scene: &Scene, responses: &[Response]) -> Truth {
    let Proved::Best(best, plan) = proved::solved(responses.first())? else {
        return Err(Why::NoPlan);
    };
    let mut found = None;
    for (agent, response) in scene.agents.iter().zip(1..) {
        let forced = proved::solved(responses.get(response))?;
        let Proved::Best(costs, _) = forced else {
            continue;
        };
        if first_better(scene.objective.costs(), &costs, &best).is_none() {
            if found.is_some() {
                return Err(Why::Differs);
            }
            found = Some(agent.name.clone());
        }
    }
    let robot = found.ok_or(Why::Unclear)?;
    Ok((Value::Robot(robot), proved::best_plan(plan)))
}
