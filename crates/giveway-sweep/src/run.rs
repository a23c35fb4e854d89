//! One task, done.

use giveway_solve::plan::{PlanAnswer, PlanEnd, PlanRequest};
use giveway_solve::words::reason;
use giveway_solve::{Host, Request, Response, SolveAnswer, SolveRequest, Status, serve};

use crate::certificate::certify;
use crate::clock::Clocked;
use crate::row::Took;
use crate::{Loaded, Method, Row, RowStatus, Task, planner};

/// Does a task on its instance; the clocks of the host begin with it.
pub fn run(task: &Task, loaded: &Loaded, host: &dyn Host) -> Row {
    let instance = &loaded.instance;
    let objective = task.objective.clone();
    let request = match &task.planner {
        Method::Search => Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            objective: objective.clone(),
            limits: task.limits,
            // Fingerprints of certificates stay those of earlier sweeps.
            as_found: true,
            // Its cores are guesses for lemmas.
            trace: task.certificate.is_some(),
            ..SolveRequest::default()
        }),
        Method::Planner(planner) => Request::Plan(PlanRequest {
            objective: objective.clone(),
            limits: task.limits,
            ..PlanRequest::new(instance.to_scene(), *planner)
        }),
        Method::Command(name) => {
            return match &task.command {
                Some(spec) => planner::row(task, spec, loaded, host),
                None => Row::error(task, format!("There is no command of the planner {name}.")),
            };
        }
    };
    let (clock, limits) = (task.clock, task.certificate);
    let clocked = Clocked { clock, host };
    let response = serve(&request, &clocked);
    let mut took = Took {
        cpu_seconds: host.cpu_seconds(),
        wall_seconds: host.wall_seconds(),
        ..Took::default()
    };
    let row = match response {
        Response::Solved(answer) => {
            let mut row = solved(task, &answer);
            if let Some(limits) = limits.filter(|_| row.is_success()) {
                let certificate = certify(instance, task, limits, &answer, &clocked);
                row.certificate = Some(certificate);
                took.certificate_cpu_seconds = Some(host.cpu_seconds() - took.cpu_seconds);
            }
            row
        }
        Response::Planned(answer) => planned(task, &answer),
        Response::Refused(refusal) => Row::error(task, refusal.sentences().join("; ")),
        _ => Row::error(
            task,
            "An answer to another request, a fault of this program.".to_owned(),
        ),
    };
    Row {
        map: loaded.map.clone(),
        agents: Some(instance.agents().len()),
        objective: Some(objective.unwrap_or_else(|| instance.objective().clone())),
        took,
        ..row
    }
}

fn solved(task: &Task, answer: &SolveAnswer) -> Row {
    let status = match answer.status {
        Status::Optimal => RowStatus::Optimal,
        Status::Feasible => RowStatus::Feasible,
        Status::Impossible => RowStatus::Impossible,
        Status::Unknown => RowStatus::Unknown,
    };
    Row {
        complete: answer.reach.is_complete(),
        within: answer.reach.within(),
        costs: answer.costs,
        bounds: answer.bounds.clone(),
        ..Row::bare(task, status, answer.reason.as_ref().map(reason))
    }
}

fn planned(task: &Task, answer: &PlanAnswer) -> Row {
    let (status, within) = match &answer.ended {
        PlanEnd::Best { reach } => (RowStatus::Optimal, reach.within()),
        PlanEnd::Refused { .. } => (RowStatus::Refused, None),
        PlanEnd::Alone { .. } => (RowStatus::Impossible, None),
        _ if answer.plan.is_some() => (RowStatus::Feasible, None),
        _ => (RowStatus::Unknown, None),
    };
    Row {
        complete: matches!(status, RowStatus::Optimal | RowStatus::Impossible) && within.is_none(),
        within,
        costs: answer.costs,
        bounds: answer.bounds.clone(),
        ..Row::bare(task, status, None)
    }
}
