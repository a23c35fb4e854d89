//! `giveway change`: how to go on with a plan around which the world changes.

use giveway_model::{Instance, Objective};
use giveway_solve::change::{ChangeAnswer, ChangeRequest, makespan_first};
use giveway_solve::{Limits, Refusal, Request, Response, Status, serve};

use super::{one_standard_input, otherwise::refused_plan, unexpected};
use crate::{
    args::{Change, Common},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Change, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input([&args.source.instance, &args.plan, &args.changes])?;
    let mut said = Said::default();
    let instance = input::instance(&args.source, Some(&args.plan), common, &mut said)?;
    let plan = input::plan_over_time(&args.plan, &instance, common, &mut said)?;
    let file = input::changes(&args.changes)?;
    let request = Request::Change(ChangeRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        changes: file.changes.clone(),
        since: args.since,
        methods: args.method.clone(),
        objective: args.objective.clone(),
        within: args.within,
        limits: Limits {
            // Reading has taken its part.
            seconds: args
                .time_limit
                .map(|limit| (limit - clock.wall_seconds()).max(0.0)),
            ..Limits::default()
        },
    });
    let host = CommandHost::new(clock, common.quiet, objective(args, &instance));
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Changed(answer) => {
            output::answer(common.format, &said, &answer, |columns| {
                text::change(&instance, &file.changes, &answer, columns)
            })?;
            Ok(exit(&answer))
        }
        Response::Refused(Refusal::Changes { faults }) => Err(file.refused(faults)),
        Response::Refused(refusal) => {
            let asked = (&instance, Some(&plan));
            Err(refused_plan(refusal, &args.source.instance, asked))
        }
        _ => Err(unexpected(&args.source.instance)),
    }
}

/// The costs in the order in which each method minimises them: the makespan first.
fn objective(args: &Change, instance: &Instance) -> Objective {
    let asked = args.objective.as_ref().unwrap_or(instance.objective());
    makespan_first(asked)
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

#[cfg(test)]
mod tests {
    use clap::Parser;
    use giveway_model::format::native;

    use super::*;
    use crate::args::{Args, Command};

    #[test]
    fn the_costs_shown_while_it_works_are_those_that_the_methods_minimise() {
        let scene = r#"{ "giveway": 1, "map": [".."], "objective": ["sum-of-costs", "waits"],
            "agents": [{ "name": "A1", "start": [0, 0], "goal": [1, 0] }] }"#;
        let instance = Instance::new(native::read_scene(scene).unwrap()).unwrap();
        let minimised = |more: &[&str]| {
            let line = ["giveway", "change", "s.json", "p.json", "c.json"];
            let args = Args::try_parse_from(line.iter().chain(more)).unwrap();
            let Command::Change(args) = args.command else {
                panic!("another command");
            };
            objective(&args, &instance).to_string()
        };
        assert_eq!(minimised(&[]), "makespan,sum-of-costs,waits");
        let asked = minimised(&["--objective", "charges"]);
        assert_eq!(asked, "makespan,charges");
    }
}
