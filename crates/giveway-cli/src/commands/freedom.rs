//! `giveway freedom`: what must be so in every best plan.

use giveway_solve::freedom::FreedomRequest;
use giveway_solve::{Request, Response, Status, serve};

use super::{one_standard_input, proof, refused, unexpected};
use crate::{
    args::{Common, Freedom},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Freedom, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input([&args.source.instance].into_iter().chain(&args.plan))?;
    if let Some(folder) = &args.proof {
        proof::check_folder(folder)?;
    }
    let mut said = Said::default();
    let mut instance = input::instance(&args.source, args.plan.as_deref(), common, &mut said)?;
    if let Some(objective) = &args.objective {
        instance = instance.with_objective(objective.clone());
    }
    let plan = args.plan.as_deref();
    let plan = plan.map(|path| input::plan(path, &instance, common, &mut said));
    let request = Request::Freedom(FreedomRequest {
        scene: instance.to_scene(),
        plan: plan.transpose()?,
        objective: None,
        within: args.within,
        proved: None,
        parts: args.parts.named(),
        count: args.parts.count,
        limits: clock.limits(args.time_limit),
    });
    let host = CommandHost::new(clock, common.quiet, instance.objective().clone());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Freedom(answer) => {
            output::answer(common.format, &said, &answer, |columns| {
                text::freedom(&instance, &answer, columns)
            })?;
            if let Some(folder) = &args.proof {
                let asker = proof::Asker {
                    time_limit: args.time_limit,
                    common,
                    clock,
                };
                proof::write_freedom(folder, &instance, &answer, &asker)?;
            }
            Ok(match answer.status {
                Status::Unknown => Exit::Unknown,
                _ => Exit::Answered,
            })
        }
        Response::Refused(refusal) => Err(refused(refusal, &args.source.instance)),
        _ => Err(unexpected(&args.source.instance)),
    }
}
