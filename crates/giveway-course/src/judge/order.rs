//! Judges an order for prioritised planning, by the planner itself.

use giveway_model::{Cost, Scene};
use giveway_solve::plan::{PlanEnd, Planner};
use giveway_solve::{Request, Response};

use super::proved::{self, Proved};
use super::{Did, Judging, Situation, Verdict, Why, ask};
use crate::lesson::read::MAX_ORDERED;
use crate::lesson::task::{Order, OrderAim};
use crate::port::Evidence;

pub(super) fn begin(task: &Order, situation: Situation<'_>, did: &Did) -> Judging {
    let scene = situation.scene;
    match did {
        Did::NoOrder if task.find == OrderAim::None && scene.agents.len() <= MAX_ORDERED => {
            let orders = all_orders(scene).into_iter();
            let tried = orders.map(|order| try_order(scene, order));
            Judging::Ask(
                std::iter::once(ask::solve(scene, None))
                    .chain(tried)
                    .collect(),
            )
        }
        Did::Ordered(order) if is_whole(scene, order) => Judging::Ask(vec![
            ask::solve(scene, None),
            try_order(scene, order.clone()),
        ]),
        _ => Verdict::not_yet(Why::Untouched).into(),
    }
}

pub(super) fn conclude(
    task: &Order,
    situation: Situation<'_>,
    did: &Did,
    responses: &[Response],
) -> Verdict {
    let verdict = match did {
        Did::NoOrder => none_works(situation.scene, responses),
        _ => one_tried(task.find, situation.scene, responses),
    };
    verdict.unwrap_or_else(Verdict::not_yet)
}

fn try_order(scene: &Scene, order: Vec<String>) -> Request {
    ask::planner(scene, Planner::Prioritised, Some(order))
}

fn is_whole(scene: &Scene, order: &[String]) -> bool {
    let all = scene.agents.iter().all(|agent| order.contains(&agent.name));
    all && order.len() == scene.agents.len()
}

/// All orders of a few robots, the scene's own first.
pub(crate) fn all_orders(scene: &Scene) -> Vec<Vec<String>> {
    let mut orders: Vec<Vec<String>> = vec![Vec::new()];
    for agent in &scene.agents {
        let longer = orders.iter().flat_map(|order| {
            (0..=order.len()).rev().map(|place| {
                let mut longer = order.clone();
                longer.insert(place, agent.name.clone());
                longer
            })
        });
        orders = longer.collect();
    }
    orders
}

/// How an order went.
enum Tried {
    Works(giveway_model::Costs, Evidence),
    Stuck(Why),
}

fn tried(response: Option<&Response>) -> Result<Tried, Why> {
    let Some(Response::Planned(answer)) = response else {
        return Err(proved::unexpected(response));
    };
    match (&answer.ended, answer.costs) {
        (_, Some(costs)) => {
            let plan = answer.plan.clone();
            let evidence = Evidence {
                plan,
                ..Evidence::default()
            };
            Ok(Tried::Works(costs, evidence))
        }
        (PlanEnd::NoOrderWorks { stuck, .. }, None) => Ok(Tried::Stuck(Why::OrderStuck {
            robot: stuck.agent.clone(),
            around: stuck.around.clone(),
        })),
        (PlanEnd::Alone { agent, .. }, None) => Err(Why::AloneStuck(agent.clone())),
        (PlanEnd::Stopped { reason }, None) => Err(Why::Unknown(Some(reason.clone()))),
        _ => Err(Why::Unknown(None)),
    }
}

fn none_works(scene: &Scene, responses: &[Response]) -> Result<Verdict, Why> {
    let Proved::Best(_, plan) = proved::solved(responses.first())? else {
        return Err(Why::NoPlan);
    };
    let orders = all_orders(scene);
    for (index, order) in orders.iter().enumerate() {
        if let Tried::Works(_, evidence) = tried(responses.get(index + 1))? {
            let verdict = Verdict::not_yet(Why::SomeOrderWorks(order.clone()));
            return Ok(verdict.with(evidence));
        }
    }
    let why = Why::NoOrderWorks {
        orders: orders.len(),
    };
    Ok(Verdict::solved(why).with(proved::best_plan(plan)))
}

fn one_tried(find: OrderAim, scene: &Scene, responses: &[Response]) -> Result<Verdict, Why> {
    let (costs, evidence) = match tried(responses.get(1))? {
        Tried::Works(costs, evidence) => (costs, evidence),
        Tried::Stuck(why) => return Ok(Verdict::not_yet(why)),
    };
    let cost = scene.objective.costs().first();
    let cost = cost.copied().unwrap_or(Cost::Makespan);
    let value = costs.get(cost);
    let best = match (find, proved::solved(responses.first())?) {
        (OrderAim::Best | OrderAim::Worse, Proved::Best(best, _)) => Some(best.get(cost)),
        _ => None,
    };
    let holds = match (find, best) {
        (OrderAim::Works, _) => true,
        (OrderAim::None, _) | (_, None) => false,
        (OrderAim::Best, Some(best)) => value == best,
        (OrderAim::Worse, Some(best)) => value > best,
    };
    let why = Why::OrderWorks { cost, value, best };
    Ok(Verdict::if_holds(holds, why).with(evidence))
}
