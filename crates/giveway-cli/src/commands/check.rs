//! `giveway check`: every rule that a plan breaks.

use giveway_model::Objective;
use giveway_solve::{CheckRequest, Request, Response, serve};

use super::{refused, unexpected};
use crate::{
    args::{Check, Common},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input::{self, is_standard_input},
    output::{self, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Check, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    if is_standard_input(&args.source.instance) && is_standard_input(&args.plan) {
        return Err(Failure::Usage(
            "found - for both INSTANCE and PLAN, expected it for one of them".to_owned(),
        ));
    }
    let instance = input::instance(&args.source, common)?;
    let plan = input::plan(&args.plan)?;
    let request = Request::Check(CheckRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
    });
    let host = CommandHost::new(clock, common.quiet, Objective::default());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Checked(answer) => {
            output::answer(common.format, &answer, |columns| {
                text::check(&instance, &plan, &answer, columns)
            })?;
            Ok(if answer.valid {
                Exit::Answered
            } else {
                Exit::Wrong
            })
        }
        Response::Refused(refusal) => Err(refused(refusal, &args.source.instance)),
        _ => Err(unexpected(&args.source.instance)),
    }
}
