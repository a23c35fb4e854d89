//! The requests of the judges, each with a budget that a learner would wait for.

use giveway_model::change::Changes;
use giveway_model::{Grid, Objective, Plan, Question, Scene};
use giveway_solve::audit::AuditRequest;
use giveway_solve::change::{ChangeRequest, Method};
use giveway_solve::delays::DelaysRequest;
use giveway_solve::explain::ExplainRequest;
use giveway_solve::freedom::{FreedomPart, FreedomRequest};
use giveway_solve::plan::{PlanRequest, Planner};
use giveway_solve::{Limits, Request, SolveRequest};

/// Seconds that a request may take.
const SECONDS: f64 = 20.0;
/// Conflicts that it may take, so that it ends where there is no clock, too.
const CONFLICTS: u64 = 400_000;

fn limits() -> Limits {
    Limits {
        seconds: Some(SECONDS),
        conflicts: Some(CONFLICTS),
        ..Limits::default()
    }
}

/// The best plan of a scene, by other costs where some are given.
pub(crate) fn solve(scene: &Scene, objective: Option<&Objective>) -> Request {
    Request::Solve(SolveRequest {
        scene: scene.clone(),
        objective: objective.cloned(),
        limits: limits(),
        ..SolveRequest::default()
    })
}

/// The best plan of a scene without one of its own rules, by its number.
pub(super) fn without(scene: &Scene, rule: u32) -> Request {
    let mut without = scene.clone();
    if let Some(rule) = without.constraints.get_mut(rule as usize) {
        rule.off = true;
    }
    solve(&without, None)
}

/// The best plan of one robot of a scene alone, by its index.
pub(super) fn alone(scene: &Scene, index: usize) -> Request {
    let mut alone = scene.clone();
    let agent = alone.agents.get(index).cloned();
    alone.agents = agent.into_iter().collect();
    // Rules about others go with them.
    if let Ok(grid) = Grid::from_rows(&alone.map) {
        alone.settle_rules(&grid);
    }
    solve(&alone, None)
}

/// The Pareto front of some costs.
pub(super) fn front(scene: &Scene, objective: Objective) -> Request {
    Request::Solve(SolveRequest {
        scene: scene.clone(),
        objective: Some(objective),
        pareto: true,
        limits: limits(),
        ..SolveRequest::default()
    })
}

/// A question about a plan, else about the best one.
pub(super) fn explain(scene: &Scene, plan: Option<&Plan>, question: Question) -> Request {
    Request::Explain(ExplainRequest {
        scene: scene.clone(),
        plan: plan.cloned(),
        changes: None,
        at: None,
        question,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: limits(),
    })
}

/// How good a plan is.
pub(super) fn audit(scene: &Scene, plan: &Plan) -> Request {
    Request::Audit(AuditRequest {
        scene: scene.clone(),
        plan: plan.clone(),
        limits: limits(),
        ..AuditRequest::default()
    })
}

/// What all best plans have in common.
pub(super) fn freedom(scene: &Scene, part: FreedomPart) -> Request {
    Request::Freedom(FreedomRequest {
        scene: scene.clone(),
        parts: vec![part],
        limits: limits(),
        ..FreedomRequest::default()
    })
}

/// What a planner of the textbook does.
pub(super) fn planner(scene: &Scene, planner: Planner, order: Option<Vec<String>>) -> Request {
    Request::Plan(PlanRequest {
        order,
        trace: planner == Planner::Cbs,
        limits: limits(),
        ..PlanRequest::new(scene.clone(), planner)
    })
}

/// Who costs whom in a plan.
pub(super) fn delays(scene: &Scene, plan: &Plan) -> Request {
    Request::Delays(DelaysRequest {
        scene: scene.clone(),
        plan: Some(plan.clone()),
        ledger_only: true,
        limits: limits(),
        ..DelaysRequest::default()
    })
}

pub(super) fn change(scene: &Scene, plan: &Plan, changes: &Changes, method: Method) -> Request {
    Request::Change(ChangeRequest {
        scene: scene.clone(),
        plan: plan.clone(),
        changes: changes.clone(),
        since: None,
        methods: vec![method],
        objective: None,
        within: None,
        limits: limits(),
    })
}
