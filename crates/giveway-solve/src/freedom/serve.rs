//! A freedom request, from the scene to the answer, part after part.

use giveway_model::{Costs, Instance, Plan, Version, check::check};

use super::{
    About, FreedomAnswer, FreedomRequest,
    parts::{self, BestPlan},
};
use crate::{
    Host, Refusal, Status,
    solve::{self, SolveTask, Solved},
};

/// Serves a freedom request, and tells the host of every part.
///
/// # Errors
/// When the scene is no instance, or the plan that was handed in breaks a rule.
pub(crate) fn serve(request: &FreedomRequest, host: &dyn Host) -> Result<FreedomAnswer, Refusal> {
    let scene = &request.scene;
    let instance = Instance::new(scene.clone()).map_err(|faults| Refusal::Scene { faults })?;
    let given = given(&instance, request)?;
    let objective = request.objective.clone();
    let mut task = SolveTask::new(instance, objective, request.within, request.limits, host);
    task.start.clone_from(&given);
    let solved = solve::solve(&task);
    let mut answer = begun(&task, given, &solved);
    let best = answer.costs.zip(answer.plan.clone());
    if let (Status::Optimal, Some((costs, plan)), Some(optimum)) =
        (answer.status, best, solved.reach)
    {
        answer.pending = request.asked();
        let subject = BestPlan {
            task: &task,
            scene,
            plan: &plan,
            costs,
            optimum,
            count: request.count_limit(),
        };
        if let Err(stop) = parts::serve(&subject, &mut answer) {
            answer.reason = Some(stop.into());
        }
    }
    answer.stats = task.budget.stats();
    Ok(answer)
}

/// The plan that was handed in, if one was, as the judge passes it.
fn given(instance: &Instance, request: &FreedomRequest) -> Result<Option<Plan>, Refusal> {
    let Some(mut plan) = request.plan.clone() else {
        return Ok(None);
    };
    let violations = check(instance, &plan).violations;
    if !violations.is_empty() {
        return Err(Refusal::Plan { violations });
    }
    plan.cut_trailing_goals(instance);
    Ok(Some(plan))
}

/// The answer when the search for the best plan has ended.
fn begun(task: &SolveTask, given: Option<Plan>, solved: &Solved) -> FreedomAnswer {
    let best = &solved.answer;
    let vector = |costs: &Costs| costs.vector(&task.objective);
    let as_good = |plan: &Plan| {
        let own = check(&task.instance, plan).costs?;
        let soon = task.within.is_none_or(|within| own.makespan <= within);
        (soon && Some(vector(&own)) == best.costs.as_ref().map(vector)).then_some(own)
    };
    let (about, costs, plan) = match given {
        None => (About::Found, best.costs, best.plan.clone()),
        Some(plan) => match as_good(&plan) {
            Some(own) => (About::Given, Some(own), Some(plan)),
            None => (About::Better, best.costs, best.plan.clone()),
        },
    };
    FreedomAnswer {
        giveway: Version,
        status: best.status,
        objective: task.objective.clone(),
        about,
        costs,
        plan,
        backbone: None,
        plans: None,
        farthest: None,
        slack: None,
        critical: None,
        pending: Vec::new(),
        reach: best.reach,
        reason: best.reason.clone(),
        stats: task.budget.stats(),
    }
}
