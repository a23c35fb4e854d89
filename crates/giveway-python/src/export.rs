//! Certificates of answers as files: what is claimed is read off the answer.

use giveway_model::format::from_object;
use giveway_model::{Objective, Plan, Scene};
use giveway_solve::explain::ExplainAnswer;
use giveway_solve::freedom::FreedomAnswer;
use giveway_solve::{Certificate, CertifyRequest, ExportRequest, Limits, Request, SolveAnswer};
use serde::Deserialize;

use crate::call::{Failure, instance};

/// An answer, and what it is about.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Answered {
    scene: Scene,
    #[serde(default)]
    objective: Option<Objective>,
    answer: Answer,
    /// The plan that a question was asked of, where it came with it.
    #[serde(default)]
    plan: Option<Plan>,
    #[serde(default, deserialize_with = "from_object")]
    limits: Limits,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Answer {
    Solve(Box<SolveAnswer>),
    Explain(Box<ExplainAnswer>),
    Freedom(Box<FreedomAnswer>),
}

/// The request for the certificates of an answer.
pub(crate) fn request(answered: Answered) -> Result<Request, Failure> {
    let (scene, limits) = (answered.scene, answered.limits);
    let instance = instance(scene)?;
    let instance = match answered.objective {
        Some(objective) => instance.with_objective(objective),
        None => instance,
    };
    let one = |name: &str, request| {
        let name = name.to_owned();
        vec![Certificate { name, request }]
    };
    let certificates = match &answered.answer {
        Answer::Solve(answer) => {
            let request = CertifyRequest::of_solved(instance.to_scene(), None, answer);
            let request = request.with_hints(answer.trace.as_ref());
            one("solved", request)
        }
        Answer::Explain(answer) => {
            let plan = answered.plan.as_ref();
            let request = CertifyRequest::of_explained(&instance, plan, answer);
            one("explained", request)
        }
        Answer::Freedom(answer) => answer.certificates(&instance),
    };
    Ok(Request::Export(ExportRequest {
        certificates,
        limits,
    }))
}
