//! The one door of the solver: requests in, progress and a response out.

mod proofs;
mod refusal;
mod response;

use giveway_model::{
    Fault, Instance, Version,
    check::{check, check_changes},
};

use crate::{
    Basic, CheckAnswer, CheckRequest, Host, Request, SolveRequest, assumed, audit,
    budget::Budget,
    certify::{certify, export},
    change::{self, ChangeRequest},
    delays,
    explain::engine,
    freedom, order, pareto, plan, price, sizing,
    solve::{self, SolveTask},
    together,
};

pub use proofs::Proofs;
pub use refusal::Refusal;
pub use response::Response;

/// Serves a request. The same request gives the same response, its seconds apart, where a
/// proof, a limit of work or a limit of conflicts ends it. Where seconds, memory or the host
/// end it, how far it came decides.
pub fn serve(request: &Request, host: &dyn Host) -> Response {
    match request {
        Request::Check(request) => serve_check(request),
        Request::Solve(request) => serve_solve(request, host),
        Request::Explain(request) => match engine::explain(request, host) {
            Ok(mut answer) => {
                assumed::weaken_explained(&request.scene, &mut answer);
                Response::Explained(Box::new(answer))
            }
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Certify(request) => match certify(request, host) {
            Ok(report) => Response::Certified(Box::new(report)),
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Export(request) => match export(request, host) {
            Ok(answer) => Response::Exported(Box::new(answer)),
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Audit(request) => match audit::serve(request, host) {
            Ok(answer) => Response::Audited(Box::new(answer)),
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Plan(request) => match plan::serve(request, host) {
            Ok(mut answer) => {
                assumed::weaken_planned(&request.scene, &mut answer);
                Response::Planned(Box::new(answer))
            }
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Freedom(request) => match assumed::refuse_goalless(&request.scene)
            .and_then(|()| freedom::serve(request, host))
        {
            Ok(mut answer) => {
                assumed::weaken_freedom(&request.scene, &mut answer);
                Response::Freedom(Box::new(answer))
            }
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Together(request) => match together::serve(request, host) {
            Ok(answer) => Response::Together(Box::new(answer)),
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Price(request) => match price::serve(request, host) {
            Ok(mut answer) => {
                assumed::weaken_priced(&request.scene, &mut answer);
                Response::Priced(Box::new(answer))
            }
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Delays(request) => match delays::serve(request, host) {
            Ok(mut answer) => {
                assumed::weaken_delays(&request.scene, &mut answer);
                Response::Delays(Box::new(answer))
            }
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Order(request) => match order::serve(request, host) {
            Ok(answer) => Response::Order(Box::new(answer)),
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Sizing(request) => match sizing::serve(request, host) {
            Ok(answer) => Response::Sized(Box::new(answer)),
            Err(refusal) => Response::Refused(refusal),
        },
        Request::Change(request) => serve_change(request, host),
    }
}

/// Serves what needs no more than search and judge, as [`serve`] does: a program that
/// calls nothing else is small, and soon there.
pub fn serve_basic(request: Basic<'_>, host: &dyn Host) -> Response {
    match request {
        Basic::Solve(request) => serve_best(request, host),
        Basic::Change(request) => serve_change(request, host),
    }
}

fn serve_solve(request: &SolveRequest, host: &dyn Host) -> Response {
    if request.pareto {
        serve_front(request, host)
    } else {
        serve_best(request, host)
    }
}

fn serve_best(request: &SolveRequest, host: &dyn Host) -> Response {
    match task(request, host) {
        Ok((task, instance)) => {
            let mut answer = solve::solve(&task).answer;
            let objective = &task.objective;
            assumed::weaken_solved((&instance, objective), &mut answer);
            Response::Solved(answer)
        }
        Err(refusal) => Response::Refused(refusal),
    }
}

fn serve_front(request: &SolveRequest, host: &dyn Host) -> Response {
    let (mut task, instance) = match task(request, host) {
        Ok(tasked) => tasked,
        Err(refusal) => return Response::Refused(refusal),
    };
    // A front has the costs that are named, and no penalty besides.
    let named = request.objective.as_ref();
    task.objective = named.unwrap_or_else(|| instance.objective()).clone();
    let costs = task.objective.costs().len();
    if !(2..=3).contains(&costs) {
        let fault = Fault::at(
            "objective",
            format!("{costs} costs"),
            "two or three for a Pareto front",
        );
        return Response::Refused(Refusal::Request { fault });
    }
    let mut answer = pareto::front(&task);
    assumed::weaken_front((&instance, &task.objective), &mut answer);
    Response::Front(answer)
}

/// The task of a request, and the instance.
fn task<'a>(
    request: &SolveRequest,
    host: &'a dyn Host,
) -> Result<(SolveTask<'a>, Instance), Refusal> {
    let instance =
        Instance::new(request.scene.clone()).map_err(|faults| Refusal::Scene { faults })?;
    let objective = request.objective.clone();
    let solved = instance.clone();
    let mut task = SolveTask::new(solved, objective, request.within, request.limits, host);
    task.start.clone_from(&request.start);
    task.as_found = request.as_found;
    if !request.trace {
        return Ok((task, instance));
    }
    if request.pareto {
        let fault = Fault::at("trace", "true with \"pareto\"", "the trace of one search");
        return Err(Refusal::Request { fault });
    }
    Ok((task.traced(Budget::new(host, request.limits)), instance))
}

fn serve_change(request: &ChangeRequest, host: &dyn Host) -> Response {
    match change::serve(request, host) {
        Ok(mut answer) => {
            let scene = &request.scene;
            let objective = request.objective.as_ref().unwrap_or(&scene.objective);
            assumed::weaken_changed(scene, objective, &mut answer);
            Response::Changed(Box::new(answer))
        }
        Err(refusal) => Response::Refused(refusal),
    }
}

fn serve_check(request: &CheckRequest) -> Response {
    let instance = match Instance::new(request.scene.clone()) {
        Ok(instance) => instance,
        Err(faults) => return Response::Refused(Refusal::Scene { faults }),
    };
    let report = match &request.changes {
        None => check(&instance, &request.plan),
        Some(changes) => match check_changes(&instance, changes, &request.plan) {
            Ok(report) => report,
            Err(faults) => return Response::Refused(Refusal::Changes { faults }),
        },
    };
    Response::Checked(CheckAnswer {
        giveway: Version,
        valid: report.violations.is_empty(),
        costs: report.costs,
        violations: report.violations,
    })
}
