//! The audit of one plan.

use giveway_formats::ForeignPlan;
use giveway_model::compare::{ClaimedBound, claimed_bounds, claims};
use giveway_model::{Instance, Plan};
use giveway_solve::audit::{AuditAnswer, AuditRequest};
use giveway_solve::{Limits, Request, Response, serve};

use crate::{
    args::{Audit, Common},
    clock::Clock,
    commands::{otherwise::otherwise, refused, unexpected},
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
            claimed_bounds: bounds(&instance, &plan, &answer),
            claims: claims(&instance, &plan.plan, plan.claimed, plan.written),
            otherwise: (!answer.legal)
                .then(|| otherwise(&instance, &plan.plan))
                .flatten(),
            instance,
            notes,
            plan,
            answer: *answer,
        }),
        Response::Refused(refusal) => Err(refused(refusal, file)),
        _ => Err(unexpected(file)),
    }
}

/// The bounds that the file claims beside what is known here: of our bounds that of the first
/// cost, which holds for all plans, whatever they cost else.
fn bounds(instance: &Instance, plan: &ForeignPlan, answer: &AuditAnswer) -> Vec<ClaimedBound> {
    let plans: Vec<&Plan> = std::iter::once(&plan.plan).chain(&answer.better).collect();
    let mut proved = answer.bounds.clone();
    let first = answer.first_cost().filter(|_| answer.reach.is_complete());
    proved.retain(|cost, _| Some(*cost) == first);
    claimed_bounds(instance, &plans, plan.bounds, &proved)
}
