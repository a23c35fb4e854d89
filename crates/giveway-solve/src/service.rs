//! The one door of the solver: requests in, progress and a response out.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{
    Fault, Instance, Version,
    check::{Violation, check, check_changes},
    question::Misfit,
};
use giveway_proof::Report;
use serde::{Deserialize, Serialize};

use crate::{
    Basic, CheckAnswer, CheckRequest, ExportAnswer, FrontAnswer, Host, Request, SolveAnswer,
    SolveRequest, assumed,
    audit::{self, AuditAnswer},
    budget::Budget,
    certify::{certify, export},
    change::{self, ChangeAnswer, ChangeRequest},
    delays::{self, DelaysAnswer},
    explain::{ExplainAnswer, engine},
    freedom::{self, FreedomAnswer},
    order::{self, OrderAnswer},
    pareto,
    plan::{self, PlanAnswer},
    price::{self, PriceAnswer},
    sizing::{self, SizingAnswer},
    solve::{self, SolveTask},
    together::{self, TogetherAnswer},
};

/// The response to a request. An error is a response, too.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "response", rename_all = "kebab-case")]
#[cfg_attr(
    target_pointer_width = "64",
    expect(
        clippy::large_enum_variant,
        reason = "a request has one response: no list of them is ever held"
    )
)]
pub enum Response {
    /// To [`Request::Solve`].
    Solved(SolveAnswer),
    /// To [`Request::Solve`] with `pareto`.
    Front(FrontAnswer),
    /// To [`Request::Check`].
    Checked(CheckAnswer),
    /// To [`Request::Explain`].
    Explained(Box<ExplainAnswer>),
    /// To [`Request::Certify`].
    Certified(Box<Report>),
    /// To [`Request::Export`].
    Exported(Box<ExportAnswer>),
    /// To [`Request::Change`].
    Changed(Box<ChangeAnswer>),
    /// To [`Request::Audit`].
    Audited(Box<AuditAnswer>),
    /// To [`Request::Plan`].
    Planned(Box<PlanAnswer>),
    /// To [`Request::Together`].
    Together(Box<TogetherAnswer>),
    /// To [`Request::Freedom`].
    Freedom(Box<FreedomAnswer>),
    /// To [`Request::Price`].
    Priced(Box<PriceAnswer>),
    /// To [`Request::Delays`].
    Delays(Box<DelaysAnswer>),
    /// To [`Request::Order`].
    Order(Box<OrderAnswer>),
    /// To [`Request::Sizing`].
    Sized(Box<SizingAnswer>),
    /// The request is wrong; nothing was done.
    Refused(Refusal),
}

/// Why a request was refused.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "refusal", rename_all = "kebab-case")]
pub enum Refusal {
    /// The scene is no instance of the problem; there is at least one fault.
    Scene {
        /// Every fault, with its place in the scene.
        faults: Vec<Fault>,
    },
    /// The request asks for something that does not exist.
    Request {
        /// The fault: found, and expected.
        fault: Fault,
    },
    /// Changes contradict the world as the plan has it.
    Changes {
        /// The faults, each with its place in the changes.
        faults: Vec<Fault>,
    },
    /// The plan that is asked about is none.
    Plan {
        /// Every rule that it breaks.
        violations: Vec<Violation>,
    },
    /// The question cannot be asked of the plan.
    Question {
        /// Why the question does not fit the plan, and which questions do.
        misfit: Misfit,
    },
}

impl Refusal {
    /// The faults in sentences or phrases, one each.
    pub fn sentences(&self) -> Vec<String> {
        match self {
            Self::Scene { faults } | Self::Changes { faults } => {
                faults.iter().map(ToString::to_string).collect()
            }
            Self::Request { fault } => vec![fault.to_string()],
            Self::Plan { violations } => violations.iter().map(|v| v.message.clone()).collect(),
            Self::Question { misfit } => vec![misfit.to_string()],
        }
    }
}

impl Refusal {
    /// The faults of the request, each with its place in it.
    pub fn faults(self) -> Vec<Fault> {
        let in_part = |faults: Vec<Fault>, part| -> Vec<Fault> {
            let faults = faults.into_iter();
            faults.map(|fault| fault.of_part(part)).collect()
        };
        match self {
            Self::Scene { faults } => in_part(faults, "scene"),
            Self::Changes { faults } => in_part(faults, "changes"),
            Self::Request { fault } => vec![fault],
            Self::Plan { violations } => violations
                .into_iter()
                .map(|violation| {
                    // It is a sentence, so it is quoted.
                    let found = format!("\"{}\"", violation.message);
                    Fault::at("plan", found, "a plan that breaks no rule")
                })
                .collect(),
            Self::Question { misfit } => vec![misfit.fault().of_part("question")],
        }
    }
}

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
