//! `giveway price`: what each rule of a scene's own costs.

use giveway_solve::price::PriceRequest;
use giveway_solve::{Request, Response, Status, serve};

use super::{one_standard_input, refused, unexpected};
use crate::{
    args::{Common, Price},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Price, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input([&args.source.instance].into_iter().chain(&args.plan))?;
    let mut said = Said::default();
    let mut instance = input::instance(&args.source, args.plan.as_deref(), common, &mut said)?;
    if let Some(objective) = &args.objective {
        instance = instance.with_objective(objective.clone());
    }
    let plan = args.plan.as_deref();
    let plan = plan.map(|path| input::plan(path, &instance, common, &mut said));
    let request = Request::Price(PriceRequest {
        scene: instance.to_scene(),
        objective: None,
        within: args.within,
        start: plan.transpose()?,
        loosen: args.loosen,
        known: None,
        limits: clock.limits(args.time_limit),
    });
    let host = CommandHost::new(clock, common.quiet, instance.objective().clone());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Priced(answer) => {
            output::answer(common.format, &said, &answer, |columns| {
                text::price(&instance, &answer, columns)
            })?;
            Ok(match answer.status {
                Status::Unknown => Exit::Unknown,
                Status::Optimal | Status::Feasible | Status::Impossible => Exit::Answered,
            })
        }
        Response::Refused(refusal) => Err(refused(refusal, &args.source.instance)),
        _ => Err(unexpected(&args.source.instance)),
    }
}
