//! A request for the order of a plan, from the scene to the answer.

use std::rc::Rc;

use giveway_model::change::History;
use giveway_model::check::{check_history, costs_over_time};
use giveway_model::{Fault, Instance, Plan, Version, tr};
use giveway_order::{Order, OrderGraph, csv, dot, losses, vda5050, waypoints, words};
use serde_json::json;

use super::{OrderAnswer, OrderFile, OrderFormat, OrderRequest};
use crate::{Host, Refusal, Stats, budget::Budget, explain::engine::solved};

/// Serves a request for the order of a plan.
///
/// # Errors
/// When the scene, the plan, the changes or the lateness are wrong, or there is no plan.
pub(crate) fn serve(request: &OrderRequest, host: &dyn Host) -> Result<OrderAnswer, Refusal> {
    let scene = request.scene.clone();
    let mut instance = Instance::new(scene).map_err(|faults| Refusal::Scene { faults })?;
    if let Some(objective) = &request.objective {
        instance = instance.with_objective(objective.clone());
    }
    if let Some(plan) = &request.plan {
        return answered(request, &instance, plan);
    }
    if request.changes.is_some() {
        let fault = Fault::at("plan", "none", "the plan that ran while the world changed");
        return Err(Refusal::Request { fault });
    }
    let budget = Rc::new(Budget::new(host, request.limits));
    let known = solved(&instance, request.within, &budget)?.answer;
    let mut answer = match &known.plan {
        Some(plan) => answered(request, &instance, plan)?,
        None => OrderAnswer {
            reason: known.reason.clone(),
            words: tr!("The search ended before there was a plan to ask about.").to_owned(),
            ..empty()
        },
    };
    answer.plan.clone_from(&known.plan);
    answer.stats = budget.stats();
    Ok(answer)
}

/// The answer about a plan.
fn answered(
    request: &OrderRequest,
    instance: &Instance,
    plan: &Plan,
) -> Result<OrderAnswer, Refusal> {
    let changes = request.changes.clone().unwrap_or_default();
    let history = History::of(instance, &changes, plan);
    let history = history.map_err(|faults| Refusal::Changes { faults })?;
    let report = check_history(&history, plan);
    if !report.is_valid() {
        let violations = report.violations;
        return Err(Refusal::Plan { violations });
    }
    let mut answer = OrderAnswer {
        costs: costs_over_time(&history, plan),
        ..empty()
    };
    let graph = match OrderGraph::new(&history, &changes, plan) {
        Ok(graph) => graph,
        Err(none) => {
            answer.words = words::no_order(&none);
            answer.none = Some(none);
            return Ok(answer);
        }
    };
    let order = graph.order();
    let mut sentences = words::all(&order);
    answer.losses = losses(&graph);
    sentences.extend(words::losses(&answer.losses));
    if !request.late.is_empty() {
        let late = graph
            .late(instance, &request.late)
            .map_err(|(index, error)| {
                let fault = error.fault(index);
                Refusal::Request { fault }
            })?;
        sentences.extend(words::outcome(&late));
        answer.late = Some(late);
    }
    let is_of_world = |format: &OrderFormat| match format {
        OrderFormat::Waypoints | OrderFormat::Vda5050 => true,
        // A table says what it is in.
        OrderFormat::Dot | OrderFormat::Csv => false,
    };
    if instance.units().is_none() && request.to.iter().any(is_of_world) {
        sentences.push(words::no_units());
    }
    let formats = request.to.iter();
    answer.files = formats
        .map(|&format| file(format, &order, instance))
        .collect();
    answer.without_slack = order.without_slack() as u32;
    answer.words = sentences.join(" ");
    answer.order = Some(order);
    Ok(answer)
}

/// The order in a format.
fn file(format: OrderFormat, order: &Order, instance: &Instance) -> OrderFile {
    let height = instance.grid().height();
    let units = instance.units();
    let pretty = |value: &serde_json::Value| format!("{value:#}\n");
    let text = match format {
        OrderFormat::Dot => dot(order),
        OrderFormat::Csv => csv(order, height, units),
        OrderFormat::Waypoints => pretty(&json!({
            "giveway": Version,
            "units": units,
            "waypoints": waypoints(order, height, units),
        })),
        OrderFormat::Vda5050 => {
            let messages = vda5050(order, instance.name(), height, units);
            pretty(&json!(messages))
        }
    };
    OrderFile { format, text }
}

/// The answer about which nothing is known.
fn empty() -> OrderAnswer {
    OrderAnswer {
        giveway: Version,
        costs: None,
        order: None,
        without_slack: 0,
        none: None,
        losses: Vec::new(),
        late: None,
        files: Vec::new(),
        plan: None,
        reason: None,
        words: String::new(),
        stats: Stats::default(),
    }
}
