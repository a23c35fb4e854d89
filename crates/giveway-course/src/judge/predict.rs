//! Judges what was predicted, by what the solver has proved.

use std::collections::BTreeMap;

use giveway_model::{Cell, Cost, Objective, Scene};
use giveway_solve::freedom::{FreedomAnswer, FreedomPart, PlanCount, Visit};
use giveway_solve::plan::{PlanAnswer, Planner, Went};
use giveway_solve::{Request, Response, Status};

use super::proved::{self, Proved};
use super::{Judging, Situation, Verdict, Why, ask, ledger, rules};
use crate::lesson::task::Predict;
use crate::lesson::{Quantity, Value};
use crate::port::Evidence;

pub(super) fn begin(task: &Predict, situation: Situation<'_>) -> Judging {
    match requests(&task.what, situation) {
        Ok(requests) => Judging::Ask(requests),
        Err(why) => Verdict::not_yet(why).into(),
    }
}

pub(super) fn conclude(
    task: &Predict,
    situation: Situation<'_>,
    guess: &Value,
    responses: &[Response],
) -> Verdict {
    match truth(&task.what, situation.scene, responses) {
        Ok((truth, evidence)) => {
            let answer = task.answers.iter().position(|other| other.value == *guess);
            let why = Why::Guessed {
                guess: guess.clone(),
                truth: truth.clone(),
                answer,
            };
            Verdict::if_holds(*guess == truth, why).with(evidence)
        }
        Err(why) => Verdict::not_yet(why),
    }
}

/// The answer for somebody who did not want to say one.
pub(super) fn reveal(task: &Predict, situation: Situation<'_>, responses: &[Response]) -> Verdict {
    match truth(&task.what, situation.scene, responses) {
        Ok((truth, evidence)) => Verdict::not_yet(Why::Revealed(truth)).with(evidence),
        Err(why) => Verdict::not_yet(why),
    }
}

fn requests(what: &Quantity, situation: Situation<'_>) -> Result<Vec<Request>, Why> {
    let scene = situation.scene;
    let request = match what {
        Quantity::Cost { .. } => ask::solve(scene, None),
        Quantity::Arrival { .. }
        | Quantity::Place { .. }
        | Quantity::Waits {}
        | Quantity::FirstWaypoint { .. } => ask::freedom(scene, FreedomPart::Backbone),
        Quantity::Plans {} => ask::freedom(scene, FreedomPart::Plans),
        Quantity::Points { costs } => match Objective::new(costs.clone()) {
            Ok(objective) => ask::front(scene, objective),
            Err(error) => return Err(Why::Refused(error.to_string())),
        },
        Quantity::Planner { planner, order, .. } => ask::planner(scene, *planner, order.clone()),
        Quantity::Node { .. } => ask::planner(scene, Planner::Cbs, None),
        Quantity::Changed {
            changes, method, ..
        } => match &situation.step.plan {
            Some(plan) => ask::change(scene, plan, changes, *method),
            None => return Err(Why::Untouched),
        },
        Quantity::Price { rule } => return Ok(rules::ask_price(scene, *rule)),
        Quantity::Decides {} => return Ok(rules::ask_deciding(scene)),
        Quantity::FirstAt { cell } => return Ok(rules::ask_first(scene, *cell)),
        Quantity::Delay { .. } | Quantity::LosesMost {} | Quantity::CostsMost {} => {
            return ledger::ask(situation);
        }
    };
    Ok(vec![request])
}

/// The right value, with what shows it; else why there is none.
pub(super) type Truth = Result<(Value, Evidence), Why>;

fn truth(what: &Quantity, scene: &Scene, responses: &[Response]) -> Truth {
    let response = responses.first();
    match what {
        Quantity::Cost { cost } => match proved::solved(response)? {
            Proved::Best(costs, plan) => Ok((number(costs.get(*cost)), proved::best_plan(plan))),
            Proved::NoPlan => Err(Why::NoPlan),
        },
        Quantity::Arrival { robot } => with_visits(response, |visits| {
            arrival(visits.get(robot)?).map(Value::Number)
        }),
        Quantity::Place { robot, time } => with_visits(response, |visits| {
            place(visits.get(robot)?, *time).map(Value::Cell)
        }),
        Quantity::Waits {} => with_visits(response, |visits| {
            let mut waiting = visits.iter().filter(|(_, visits)| waits(visits));
            let (robot, _) = waiting.next()?;
            waiting
                .next()
                .is_none()
                .then(|| Value::Robot(robot.clone()))
        }),
        Quantity::FirstWaypoint { robot } => with_visits(response, |visits| {
            let agent = scene.agents.iter().find(|agent| agent.name == *robot)?;
            first_of(visits.get(robot)?, &agent.waypoints).map(Value::Cell)
        }),
        Quantity::Plans {} => {
            let answer = freedom(response)?;
            match answer.plans.as_ref().map(|plans| plans.number) {
                Some(PlanCount::Exactly(count)) => Ok((number(count), shown(answer))),
                _ => Err(Why::Unknown(answer.reason.clone())),
            }
        }
        Quantity::Points { .. } => match response {
            Some(Response::Front(front))
                if front.status == Status::Optimal && front.reach.is_complete() =>
            {
                let count = front.front.len() as u32;
                Ok((number(count), Evidence::default()))
            }
            other => Err(proved::unexpected(other)),
        },
        Quantity::Planner { cost, .. } => planned(*cost, response),
        Quantity::Node { number } => node(*number, response),
        Quantity::Changed {
            changes,
            method,
            cost,
        } => {
            let Some(Response::Changed(answer)) = response else {
                return Err(proved::unexpected(response));
            };
            let found = answer.methods.get(*method);
            let found = found.ok_or(Why::NoWayOn(*method))?;
            let Proved::Best(costs, plan) = proved::answer(&found.result)? else {
                return Err(Why::NoWayOn(*method));
            };
            let value = match cost {
                Some(cost) => costs.get(*cost),
                None if found.closest => found.kept.len() as u32,
                None => return Err(Why::Differs),
            };
            let evidence = Evidence {
                changes: Some(changes.clone()),
                ..proved::best_plan(plan)
            };
            Ok((number(value), evidence))
        }
        Quantity::Price { rule } => {
            let price = rules::price(scene, *rule, responses)?;
            Ok((number(price.steps), price.evidence))
        }
        Quantity::Decides {} => rules::deciding(scene, responses),
        Quantity::FirstAt { .. } => rules::first(scene, responses),
        Quantity::Delay { robot, because } => ledger::delay(robot, because.as_deref(), responses),
        Quantity::LosesMost {} => ledger::loses_most(responses),
        Quantity::CostsMost {} => ledger::costs_most(responses),
    }
}

const fn number(number: u32) -> Value {
    Value::Number(number)
}

fn freedom(response: Option<&Response>) -> Result<&FreedomAnswer, Why> {
    match response {
        Some(Response::Freedom(answer))
            if answer.status == Status::Optimal && answer.reach.is_complete() =>
        {
            Ok(answer)
        }
        Some(Response::Freedom(answer)) => Err(Why::Unknown(answer.reason.clone())),
        other => Err(proved::unexpected(other)),
    }
}

fn shown(answer: &FreedomAnswer) -> Evidence {
    answer
        .plan
        .as_ref()
        .map(proved::best_plan)
        .unwrap_or_default()
}

fn with_visits(
    response: Option<&Response>,
    find: impl FnOnce(&BTreeMap<String, Vec<Visit>>) -> Option<Value>,
) -> Truth {
    let answer = freedom(response)?;
    let visits = answer.backbone.as_ref().ok_or(Why::Unknown(None))?;
    let value = find(visits).ok_or(Why::Differs)?;
    Ok((value, shown(answer)))
}

/// When a robot arrives in every best plan: it comes to its goal then, from elsewhere.
fn arrival(visits: &[Visit]) -> Option<u32> {
    let (last, before) = visits.split_last()?;
    let comes = before.last().is_none_or(|visit| visit.always.is_proved());
    (last.always.is_proved() && comes).then_some(last.time)
}

fn place(visits: &[Visit], time: u32) -> Option<Cell> {
    let at = visits.iter().find(|visit| visit.time == time);
    match at {
        Some(visit) if visit.always.is_proved() => visit.cell,
        None if arrival(visits)? < time => visits.last()?.cell,
        Some(_) | None => None,
    }
}

fn waits(visits: &[Visit]) -> bool {
    visits.windows(2).any(|pair| match pair {
        [one, two] => {
            let sure = one.always.is_proved() && two.always.is_proved();
            sure && one.cell.is_some() && one.cell == two.cell
        }
        _ => false,
    })
}

/// The first of some cells that a robot visits, where all of its way there is sure.
fn first_of(visits: &[Visit], cells: &[Cell]) -> Option<Cell> {
    for visit in visits {
        if !visit.always.is_proved() {
            return None;
        }
        if let Some(cell) = visit.cell.filter(|cell| cells.contains(cell)) {
            return Some(cell);
        }
    }
    None
}

fn plan(response: Option<&Response>) -> Result<&PlanAnswer, Why> {
    match response {
        Some(Response::Planned(answer)) => Ok(answer),
        other => Err(proved::unexpected(other)),
    }
}

fn planned(cost: Cost, response: Option<&Response>) -> Truth {
    let answer = plan(response)?;
    let costs = answer.costs.ok_or(Why::NoPlan)?;
    let evidence = Evidence {
        plan: answer.plan.clone(),
        ..Evidence::default()
    };
    Ok((number(costs.get(cost)), evidence))
}

fn node(wanted: u64, response: Option<&Response>) -> Truth {
    let answer = plan(response)?;
    let went = answer.trace.as_ref().map(|trace| &trace.went);
    let Some(Went::Cbs { nodes, .. }) = went else {
        return Err(Why::Unknown(None));
    };
    let node = nodes.iter().find(|node| node.id == wanted);
    let cost = node.and_then(|node| node.cost).ok_or(Why::Unknown(None))?;
    Ok((number(cost), Evidence::default()))
}
