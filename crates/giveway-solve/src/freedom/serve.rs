//! A freedom request, from the scene to the answer, part after part.

use giveway_model::{Costs, Instance, Plan, Version, check::check};

use super::{
    About, FreedomAnswer, FreedomRequest,
    parts::{self, BestPlan},
};
use crate::{
    Host, ProvedBest, Reach, Reason, Refusal, Status,
    search::{LatestArrivals, Proved},
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
    let handed_on = request.proved.as_ref().and_then(|proved| {
        let best = Best::handed_on(&task, given.as_ref()?, proved)?;
        Some((best, About::Given))
    });
    let (best, about) = match handed_on {
        Some(known) => known,
        None => Best::searched(&task, given),
    };
    let mut answer = begun(&task, &best, about);
    let known = best.costs.zip(best.plan.as_ref());
    if let (Status::Optimal, Some((costs, plan)), Some(optimum)) =
        (best.status, known, best.optimum)
    {
        answer.pending = request.asked();
        let subject = BestPlan {
            task: &task,
            scene,
            plan,
            costs,
            optimum,
            latest: best.latest,
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

/// What is known of the best plan.
struct Best {
    status: Status,
    costs: Option<Costs>,
    plan: Option<Plan>,
    /// How far it is proved that none is better.
    optimum: Option<Proved>,
    /// The latest arrivals that the proof leaves, where it leaves such.
    latest: Option<LatestArrivals>,
    reach: Reach,
    reason: Option<Reason>,
}

impl Best {
    /// The plan that was handed in, with the proof that came with it.
    fn handed_on(task: &SolveTask, given: &Plan, proved: &ProvedBest) -> Option<Self> {
        let (optimum, latest) = proved.handed_on();
        optimum.is_some().then(|| Self {
            status: Status::Optimal,
            costs: check(&task.instance, given).costs,
            plan: Some(given.clone()),
            optimum,
            latest,
            reach: proved.reach,
            reason: None,
        })
    }

    /// What a search finds out, and which plan that is of: the one that was handed in stays where
    /// none is better.
    fn searched(task: &SolveTask, given: Option<Plan>) -> (Self, About) {
        let Solved {
            answer,
            reach: optimum,
            latest,
            ..
        } = solve::solve(task);
        let mut best = Self {
            status: answer.status,
            costs: answer.costs,
            plan: answer.plan,
            optimum,
            latest,
            reach: answer.reach,
            reason: answer.reason,
        };
        let Some(given) = given else {
            return (best, About::Found);
        };
        let vector = |costs: &Costs| costs.vector(&task.objective);
        let own = check(&task.instance, &given).costs.filter(|own| {
            let soon = task.within.is_none_or(|within| own.makespan <= within);
            soon && Some(vector(own)) == best.costs.as_ref().map(vector)
        });
        if own.is_none() {
            return (best, About::Better);
        }
        best.costs = own;
        best.plan = Some(given);
        (best, About::Given)
    }
}

/// The answer when it is known what the best plan is.
fn begun(task: &SolveTask, best: &Best, about: About) -> FreedomAnswer {
    FreedomAnswer {
        giveway: Version,
        status: best.status,
        objective: task.objective.clone(),
        about,
        costs: best.costs,
        plan: best.plan.clone(),
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
