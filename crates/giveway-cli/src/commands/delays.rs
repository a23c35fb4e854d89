//! `giveway explain SCENE delays`: who costs whom.

use giveway_model::question::Asked;
use giveway_solve::delays::DelaysRequest;
use giveway_solve::{Refusal, Request, Response, serve};

use super::{explain::asked, one_standard_input, otherwise::refused_plan, unexpected};
use crate::{
    args::{Common, Explain},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, text},
    progress::CommandHost,
};

/// The question as it is typed.
pub(super) const KIND: &str = "delays";

pub(super) fn run(args: &Explain, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    about_all(args)?;
    let inputs = [&args.source.instance].into_iter().chain(&args.plan);
    one_standard_input(inputs.chain(&args.changes))?;
    let mut said = Said::default();
    let mut instance = input::instance(&args.source, args.plan.as_deref(), common, &mut said)?;
    if let Some(objective) = &args.objective {
        instance = instance.with_objective(objective.clone());
    }
    let plan = args.plan.as_deref();
    let plan = plan.map(|path| match &args.changes {
        None => input::plan(path, &instance, common, &mut said),
        Some(_) => input::plan_over_time(path, &instance, common, &mut said),
    });
    let plan = plan.transpose()?;
    let changes = args.changes.as_deref().map(input::changes).transpose()?;
    let request = Request::Delays(DelaysRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        changes: changes.as_ref().map(|file| file.changes.clone()),
        at: args.at_time,
        objective: None,
        within: args.within,
        ledger_only: false,
        limits: clock.limits(args.time_limit),
    });
    let host = CommandHost::new(clock, common.quiet, instance.objective().clone());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Delays(answer) => {
            output::answer(common.format, &said, &answer, |columns| {
                text::delays(&instance, plan.as_ref(), &answer, columns)
            })?;
            let is_known = answer.costs.is_some() && answer.reason.is_none();
            Ok(if is_known {
                Exit::Answered
            } else {
                Exit::Unknown
            })
        }
        Response::Refused(refusal) => Err(match (refusal, &changes) {
            (Refusal::Changes { faults }, Some(file)) => file.refused(faults),
            (refusal, _) => {
                refused_plan(refusal, &args.source.instance, (&instance, plan.as_ref()))
            }
        }),
        _ => Err(unexpected(&args.source.instance)),
    }
}

/// The question is about the whole plan, and has no certificate.
fn about_all(args: &Explain) -> Result<(), Failure> {
    let only = Asked {
        kind: KIND.to_owned(),
        ..Asked::default()
    };
    if asked(args) != only || args.question.rule.is_some() {
        return Err(Failure::Usage(
            "the question \"delays\" is about the whole plan: it stands without other words"
                .to_owned(),
        ));
    }
    if args.proof.is_some() {
        return Err(Failure::Usage(
            "--proof is not for the question \"delays\": giveway solve --proof proves the sum of costs"
                .to_owned(),
        ));
    }
    Ok(())
}
