//! Audits: what is claimed of plans that are the best, that are not, and that are none.

mod forged;
mod random;
mod words;

use giveway_model::{Instance, Plan};

use super::{AuditAnswer, AuditRequest};
use crate::{Host, Limits, Request, Response, serve};

/// A request with a budget that needs no clock.
fn request(instance: &Instance, plan: &Plan) -> AuditRequest {
    AuditRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        limits: Limits {
            conflicts: Some(20_000),
            ..Limits::default()
        },
        ..AuditRequest::default()
    }
}

fn audit(request: &AuditRequest, host: &dyn Host) -> AuditAnswer {
    match serve(&Request::Audit(request.clone()), host) {
        Response::Audited(answer) => *answer,
        other => panic!("{other:?}"),
    }
}
