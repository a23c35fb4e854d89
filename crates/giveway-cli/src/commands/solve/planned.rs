//! `giveway solve --planner`: a plan by a planner of the textbook.

use giveway_model::{Instance, Objective};
use giveway_solve::{
    Request, Response,
    plan::{PlanAnswer, PlanEnd, PlanRequest, Planner},
    serve,
};

use super::limits;
use crate::{
    args::{Common, Solve},
    clock::Clock,
    commands::{refused, unexpected},
    exit::Exit,
    failure::Failure,
    output::{self, Said, text},
    progress::CommandHost,
};

pub(super) fn run(
    planner: Planner,
    args: &Solve,
    (instance, objective): (&Instance, &Objective),
    said: &Said,
    common: &Common,
    clock: Clock,
) -> Result<Exit, Failure> {
    if args.order.is_some() && planner != Planner::Prioritised {
        return Err(Failure::Usage(format!(
            "found --order for {planner}, expected it for prioritised"
        )));
    }
    let request = Request::Plan(PlanRequest {
        objective: Some(objective.clone()),
        within: args.within,
        order: args.order.clone(),
        trace: args.trace.is_some(),
        limits: limits(args, clock),
        ..PlanRequest::new(instance.to_scene(), planner)
    });
    let host = CommandHost::new(clock, common.quiet, objective.clone());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Planned(mut answer) => {
            // It goes into a file of its own.
            let trace = answer.trace.take();
            output::answer(common.format, said, &answer, |columns| {
                text::planned(instance, &answer, columns)
            })?;
            if let Some((path, trace)) = args.trace.as_deref().zip(trace) {
                output::trace(path, &trace)?;
            }
            Ok(exit(&answer))
        }
        Response::Refused(refusal) => Err(refused(refusal, &args.source.instance)),
        _ => Err(unexpected(&args.source.instance)),
    }
}

fn exit(answer: &PlanAnswer) -> Exit {
    let is_proved = matches!(answer.ended, PlanEnd::Alone { .. });
    if answer.plan.is_some() || is_proved {
        Exit::Answered
    } else {
        Exit::Unknown
    }
}
