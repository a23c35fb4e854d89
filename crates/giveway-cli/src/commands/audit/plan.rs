//! The audit of one plan.

use giveway_model::{Instance, compare::claims, format::foreign::ForeignPlan};
use giveway_solve::audit::AuditRequest;
use giveway_solve::{Limits, Request, Response, serve};

use crate::{
    args::{Audit, Common},
    clock::Clock,
    commands::{refused, unexpected},
    failure::Failure,
    output::report::Audited,
    progress::CommandHost,
};

/// A plan, with what it is for.
pub(super) struct Subject {
    pub(super) instance: Instance,
    /// What was noted of the instance.
    pub(super) notes: Vec<String>,
    pub(super) plan: ForeignPlan,
}

/// Has a plan audited.
///
/// # Errors
/// When the service refuses, which it does not for a checked instance.
pub(super) fn audited(
    subject: Subject,
    args: &Audit,
    common: &Common,
    clock: Clock,
) -> Result<Audited, Failure> {
    let Subject {
        instance,
        notes,
        plan,
    } = subject;
    let objective = args.objective.as_ref().unwrap_or(instance.objective());
    let host = CommandHost::new(clock, common.quiet, objective.clone());
    let request = Request::Audit(AuditRequest {
        scene: instance.to_scene(),
        plan: plan.plan.clone(),
        objective: Some(objective.clone()),
        within: args.within,
        limits: Limits {
            seconds: Some(args.time_limit),
            ..Limits::default()
        },
    });
    let response = serve(&request, &host);
    host.finish();
    let file = std::path::Path::new(&plan.file);
    match response {
        Response::Audited(answer) => Ok(Audited {
            claims: claims(&instance, &plan.plan, plan.claimed, plan.written),
            instance,
            notes,
            plan,
            answer: *answer,
        }),
        Response::Refused(refusal) => Err(refused(refusal, file)),
        _ => Err(unexpected(file)),
    }
}
