//! `giveway change`: how to go on with a plan around which the world changes.

use giveway_model::Objective;
use giveway_solve::change::{ChangeAnswer, ChangeRequest};
use giveway_solve::{Limits, Refusal, Request, Response, Status, serve};

use super::{one_standard_input, refused, unexpected};
use crate::{
    args::{Change, Common},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Change, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input([&args.source.instance, &args.plan, &args.changes])?;
    let instance = input::instance(&args.source, common)?;
    let plan = input::plan(&args.plan, &instance, common)?;
    let file = input::changes(&args.changes)?;
    let request = Request::Change(ChangeRequest {
        scene: instance.to_scene(),
        plan,
        changes: file.changes.clone(),
        since: args.since,
        methods: args.method.clone(),
        objective: args.objective.clone(),
        within: args.within,
        limits: Limits {
            seconds: args.time_limit,
            ..Limits::default()
        },
    });
    let host = CommandHost::new(clock, common.quiet, Objective::default());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Changed(answer) => {
            output::answer(common.format, &answer, |columns| {
                text::change(&instance, &file.changes, &answer, columns)
            })?;
            Ok(exit(&answer))
        }
        Response::Refused(Refusal::Changes { faults }) => Err(file.refused(faults)),
        Response::Refused(refusal) => Err(refused(refusal, &args.source.instance)),
        _ => Err(unexpected(&args.source.instance)),
    }
}

/// Unknown where the last change is left with neither a plan nor a proof.
fn exit(answer: &ChangeAnswer) -> Exit {
    let mut methods = answer.methods.0.iter();
    let is_open = methods.any(|(_, method)| method.result.status == Status::Unknown);
    if answer.adopted.is_none() && is_open {
        Exit::Unknown
    } else {
        Exit::Answered
    }
}
