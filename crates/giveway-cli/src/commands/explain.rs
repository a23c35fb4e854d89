//! `giveway explain`: why a plan is as it is.

use giveway_model::{Instance, Plan, Question, change::History, question::Asked};
use giveway_solve::explain::{ExplainRequest, Layer, Verdict};
use giveway_solve::{Refusal, Request, Response, serve};

use super::{delays, one_standard_input, otherwise::refused_plan, proof, unexpected};
use crate::{
    args::{Common, Explain},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input::{self, ChangesFile, is_standard_input},
    output::{self, Said, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Explain, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    if args.question.kind == delays::KIND {
        return delays::run(args, common, clock);
    }
    let question = question(args)?;
    let from_input = args.plan.as_deref().is_some_and(is_standard_input);
    if from_input && is_standard_input(&args.source.instance) {
        return Err(Failure::Usage(
            "found - for both INSTANCE and --plan, expected it for one of them".to_owned(),
        ));
    }
    let inputs = [&args.source.instance].into_iter().chain(&args.plan);
    one_standard_input(inputs.chain(&args.changes))?;
    if let Some(folder) = &args.proof {
        proof::check_folder(folder)?;
    }
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
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        changes: changes.as_ref().map(|file| file.changes.clone()),
        at: args.at_time,
        question,
        objective: None,
        within: args.within,
        proved: None,
        known: None,
        layers: args.layers.clone(),
        limits: clock.limits(args.time_limit),
    });
    let host = CommandHost::new(clock, common.quiet, instance.objective().clone());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Explained(answer) => {
            let plan = plan.as_ref().or(answer.plan.as_ref());
            output::answer(common.format, &said, &answer, |columns| {
                match history(args, &instance, changes.as_ref(), plan) {
                    None => text::explain(&instance, plan, &answer, columns),
                    Some((history, plan)) => {
                        text::explain_over_time(&instance, &history, plan, &answer, columns)
                    }
                }
            })?;
            if let Some(folder) = &args.proof {
                let asker = proof::Asker {
                    time_limit: args.time_limit,
                    common,
                    clock,
                };
                proof::write_explained(folder, &instance, plan, &answer, &asker)?;
            }
            Ok(match (answer.valid, answer.verdict) {
                (Some(false), _) => Exit::Wrong,
                (_, Verdict::Unknown) if is_judged(args) => Exit::Unknown,
                _ => Exit::Answered,
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

/// Whether the answer is to have a verdict.
fn is_judged(args: &Explain) -> bool {
    let quick = |layer: &Layer| matches!(layer, Layer::Here | Layer::Near);
    args.layers.is_empty() || !args.layers.iter().all(quick)
}

/// The world over time with the changes that count, where there are any.
fn history<'a>(
    args: &Explain,
    instance: &Instance,
    changes: Option<&ChangesFile>,
    plan: Option<&'a Plan>,
) -> Option<(History, &'a Plan)> {
    let mut changes = changes?.changes.clone();
    let counts = |at: u32| args.at_time.is_none_or(|shown| at <= shown);
    changes.changes.retain(|change| counts(change.at));
    // It was made for the answer, so it can be made again.
    Some((History::of(instance, &changes, plan?).ok()?, plan?))
}

/// The question as it was typed.
fn question(args: &Explain) -> Result<Question, Failure> {
    let Some(file) = &args.question.rule else {
        return asked(args).question().map_err(|error| {
            let sentence = error.to_string();
            Failure::Usage(sentence.trim_end_matches('.').to_owned())
        });
    };
    let only = Asked {
        kind: "rule".to_owned(),
        ..Asked::default()
    };
    if asked(args) != only {
        return Err(Failure::Usage(
            "--rule is for the question \"rule\", without other words".to_owned(),
        ));
    }
    let rule = Box::new(input::rule_of_file(file)?);
    Ok(Question::Rule { rule })
}

/// The question, in the parts in which it was typed.
pub(super) fn asked(args: &Explain) -> Asked {
    let question = &args.question;
    Asked {
        kind: question.kind.clone(),
        agents: question.who.clone(),
        at: question.at,
        from: question.from,
        to: question.to,
        time: question.time,
        at_least: question.at_least,
        fewer_than: question.fewer_than,
        from_cell: question.from_cell,
        to_cell: question.to_cell,
        first: question.first,
        second: question.second,
    }
}
