//! A change request: one time after the other.

use std::rc::Rc;

use giveway_model::{
    Cost, Instance, Objective, Plan, Version,
    change::History,
    check::{Violation, check_history, costs_over_time},
    snapshot::Snapshot,
};

use super::{
    ChangeAnswer, ChangeRequest, Method, MethodAnswer, Methods, Step, horizon, method,
    method_case::MethodCase,
};
use crate::{Host, budget::Budget, service::Refusal};

/// Serves a change request.
///
/// # Errors
/// Where the scene, the plan or a change is refused.
pub(crate) fn serve(request: &ChangeRequest, host: &dyn Host) -> Result<ChangeAnswer, Refusal> {
    let instance = Instance::new(request.scene.clone());
    let instance = instance.map_err(|faults| Refusal::Scene { faults })?;
    let objective = request.objective.as_ref().unwrap_or(instance.objective());
    let objective = makespan_first(objective);
    request
        .changes
        .few()
        .map_err(|faults| Refusal::Changes { faults })?;
    let (mut history, known) = adopted_so_far(&instance, request)?;
    let mut plan = request.plan.clone();
    let mut steps: Vec<Step> = Vec::new();
    for (at, list) in request.changes.by_time().into_iter().skip(known) {
        let mut after = history.clone();
        let applied = after.apply(at, &list, &plan);
        applied.map_err(|faults| Refusal::Changes { faults })?;
        let snapshot = Snapshot::new(at, &instance, (&history, &after), &plan);
        let objective = snapshot.instance.in_force(objective.clone());
        let mut methods = Vec::new();
        for &method in &request.methods {
            let case = MethodCase {
                snapshot: &snapshot,
                method,
                objective: &objective,
                within: request.within.map(|within| within.saturating_sub(at)),
                budget: Rc::new(Budget::new(host, request.limits)),
            };
            let answer = horizon::hold_to(request.within, method::run(&case));
            methods.push((method, answer));
        }
        let (adopted, next) = adopt(&methods);
        steps.push(Step {
            at,
            before: costs_over_time(&history, &plan),
            methods: Methods(methods),
            adopted,
        });
        match next {
            Some(next) => plan = next,
            None => break,
        }
        history = after;
    }
    let last = steps.pop();
    Ok(ChangeAnswer {
        giveway: Version,
        at: last.as_ref().map(|step| step.at),
        before: last.as_ref().and_then(|step| step.before),
        adopted: last.as_ref().and_then(|step| step.adopted),
        methods: last.map(|step| step.methods).unwrap_or_default(),
        history: steps,
    })
}

/// The first method that has a plan.
fn adopt(methods: &[(Method, MethodAnswer)]) -> (Option<Method>, Option<Plan>) {
    let found = methods
        .iter()
        .find_map(|(method, answer)| Some((*method, answer.result.plan.clone()?)));
    found.unzip()
}

/// The costs that each method minimises: the makespan, then the others in order.
pub fn makespan_first(objective: &Objective) -> Objective {
    let others = objective.costs().iter().copied();
    let mut costs = vec![Cost::Makespan];
    costs.extend(others.filter(|&cost| cost != Cost::Makespan));
    // It has each cost once, as the given one has.
    Objective::new(costs).unwrap_or_default()
}

/// The history with the changes that the plan knows already: those before the
/// time that the request asks for, those that the plan says it knows, or else as
/// few times as make the plan valid.
fn adopted_so_far(
    instance: &Instance,
    request: &ChangeRequest,
) -> Result<(History, usize), Refusal> {
    let plan = &request.plan;
    let mut history = History::new(instance);
    let mut broken: Option<Vec<Violation>> = None;
    let times = request.changes.by_time();
    // The request counts before the time that the plan itself names.
    let said = plan.knows.map(|knows| knows.saturating_add(1));
    let wanted = request.since.or(said).map(|since| {
        let before = times.iter().take_while(|(at, _)| *at < since);
        before.count()
    });
    for known in 0..=times.len() {
        let report = check_history(&history, plan);
        if report.is_valid() && wanted.is_none_or(|wanted| wanted == known) {
            return Ok((history, known));
        }
        let fewer = !report.is_valid()
            && broken
                .as_ref()
                .is_none_or(|broken| report.violations.len() < broken.len());
        if fewer {
            broken = Some(report.violations);
        }
        let next = times
            .get(known)
            .map(|(at, list)| history.apply(*at, list, plan));
        if !matches!(next, Some(Ok(()))) {
            break;
        }
    }
    Err(Refusal::Plan {
        violations: broken.unwrap_or_default(),
    })
}
