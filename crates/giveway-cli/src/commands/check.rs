//! `giveway check`: every rule that a plan breaks.

use giveway_model::{Objective, change::History};
use giveway_solve::{CheckRequest, Refusal, Request, Response, serve};

use super::{one_standard_input, otherwise::otherwise, refused, unexpected};
use crate::{
    args::{Check, Common},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Check, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    let inputs = [&args.source.instance, &args.plan];
    one_standard_input(inputs.into_iter().chain(&args.changes))?;
    let mut said = Said::default();
    let instance = input::instance(&args.source, Some(&args.plan), common, &mut said)?;
    let plan = match &args.changes {
        None => input::plan(&args.plan, &instance, common, &mut said)?,
        Some(_) => input::plan_over_time(&args.plan, &instance, common, &mut said)?,
    };
    let changes = args.changes.as_deref().map(input::changes).transpose()?;
    let request = Request::Check(CheckRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        changes: changes.as_ref().map(|file| file.changes.clone()),
    });
    let host = CommandHost::new(clock, common.quiet, Objective::default());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Checked(answer) => {
            if !answer.valid && changes.is_none() {
                said.add(otherwise(&instance, &plan));
            }
            let history = changes.as_ref().and_then(|file| {
                // It was made for the judge, so it can be made again.
                History::of(&instance, &file.changes, &plan).ok()
            });
            output::answer(common.format, &said, &answer, |columns| match &history {
                None => text::check(&instance, &plan, &answer, columns),
                Some(history) => text::check_over_time(&instance, history, &plan, &answer, columns),
            })?;
            Ok(if answer.valid {
                Exit::Answered
            } else {
                Exit::Wrong
            })
        }
        Response::Refused(refusal) => Err(match (refusal, &changes) {
            (Refusal::Changes { faults }, Some(file)) => file.refused(faults),
            (refusal, _) => refused(refusal, &args.source.instance),
        }),
        _ => Err(unexpected(&args.source.instance)),
    }
}
