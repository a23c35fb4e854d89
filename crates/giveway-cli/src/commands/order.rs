//! `giveway order`: the order that robots keep where they have no common clock.

use giveway_order::words;
use giveway_solve::order::{OrderAnswer, OrderFormat, OrderRequest};
use giveway_solve::{Refusal, Request, Response, serve};

use super::{one_standard_input, otherwise::refused_plan, unexpected};
use crate::{
    args::{Common, Order},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, stream, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Order, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    let inputs = [&args.source.instance].into_iter().chain(&args.plan);
    one_standard_input(inputs.chain(&args.changes))?;
    let mut said = Said::default();
    let instance = input::instance(&args.source, args.plan.as_deref(), common, &mut said)?;
    let plan = args.plan.as_deref();
    let plan = plan.map(|path| match &args.changes {
        None => input::plan(path, &instance, common, &mut said),
        Some(_) => input::plan_over_time(path, &instance, common, &mut said),
    });
    let plan = plan.transpose()?;
    let changes = args.changes.as_deref().map(input::changes).transpose()?;
    let request = Request::Order(OrderRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        changes: changes.as_ref().map(|file| file.changes.clone()),
        late: args.late.clone(),
        to: args.to.into_iter().collect(),
        objective: None,
        within: args.within,
        limits: clock.limits(args.time_limit),
    });
    let host = CommandHost::new(clock, common.quiet, instance.objective().clone());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Order(answer) => {
            match (args.to, answer.files.first()) {
                (Some(_), Some(file)) => {
                    if !common.quiet {
                        notes(&said, &answer, instance.units().is_none());
                    }
                    stream::file(file.text.as_bytes())?;
                }
                // Without an order there is nothing to write.
                (Some(_), None) => return Err(Failure::Refused(vec![answer.words.clone()])),
                (None, _) => output::answer(common.format, &said, &answer, |columns| {
                    text::order(&instance, plan.as_ref(), &answer, columns)
                })?,
            }
            Ok(if answer.costs.is_some() {
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

/// Says beside a file what it does not hold.
fn notes(said: &Said, answer: &OrderAnswer, has_no_units: bool) {
    let of_world = |format: OrderFormat| match format {
        OrderFormat::Waypoints | OrderFormat::Vda5050 => true,
        OrderFormat::Dot | OrderFormat::Csv => false,
    };
    let mut notes = said.notes().to_vec();
    notes.extend(answer.order.iter().flat_map(words::later));
    notes.extend(words::losses(&answer.losses));
    if has_no_units && answer.files.iter().any(|it| of_world(it.format)) {
        notes.push(words::no_units());
    }
    for note in notes {
        stream::note(&format!("note: {note}"));
    }
}
