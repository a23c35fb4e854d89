//! `giveway solve`: the best plan, proved; or one by a planner of the textbook.

mod planned;

use giveway_model::Objective;
use giveway_solve::{Limits, Request, Response, SolveRequest, Status, serve};

use super::{proof, refused, unexpected};
use crate::{
    args::{Common, Solve},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Solve, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    if let Some(objective) = args.objective.as_ref().filter(|_| args.pareto) {
        check_front(objective)?;
    }
    if let Some(folder) = &args.proof {
        proof::check_folder(folder)?;
    }
    let mut said = Said::default();
    let instance = input::instance(&args.source, None, common, &mut said)?;
    let objective = args
        .objective
        .as_ref()
        .unwrap_or(instance.objective())
        .clone();
    if args.pareto {
        check_front(&objective)?;
    }
    // What a penalty costs is told, too; a front has the costs that are named.
    let objective = if args.pareto {
        objective
    } else {
        instance.in_force(objective)
    };
    if let Some(planner) = args.planner {
        return planned::run(planner, args, (&instance, &objective), &said, common, clock);
    }
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        objective: Some(objective.clone()),
        pareto: args.pareto,
        within: args.within,
        start: None,
        // A certificate is made of the steps of the search.
        trace: args.trace.is_some() || args.proof.is_some(),
        limits: limits(args, clock),
        as_found: args.proof.is_some(),
    });
    let host = CommandHost::new(clock, common.quiet, objective.clone());
    let response = serve(&request, &host);
    host.finish();
    match response {
        Response::Solved(mut answer) => {
            // It goes into a file of its own.
            let trace = answer.trace.take();
            output::answer(common.format, &said, &answer, |columns| {
                text::solve(&instance, &objective, &answer, columns)
            })?;
            if let Some((path, trace)) = args.trace.as_deref().zip(trace.as_ref()) {
                output::trace(path, trace)?;
            }
            if let Some(folder) = &args.proof {
                let asker = proof::Asker {
                    time_limit: args.time_limit,
                    common,
                    clock,
                };
                let instance = instance.with_objective(objective);
                answer.trace = trace;
                proof::write_solved(folder, &instance, &answer, &asker)?;
            }
            Ok(exit(answer.status))
        }
        Response::Front(answer) => {
            output::answer(common.format, &said, &answer, |columns| {
                text::front(&instance, &objective, &answer, columns)
            })?;
            Ok(exit(answer.status))
        }
        Response::Refused(refusal) => Err(refused(refusal, &args.source.instance)),
        _ => Err(unexpected(&args.source.instance)),
    }
}

/// The limit is for the whole command: reading has taken its part.
fn limits(args: &Solve, clock: Clock) -> Limits {
    let left = |limit: f64| (limit - clock.wall_seconds()).max(0.0);
    Limits {
        seconds: args.time_limit.map(left),
        work: args.work_limit,
        ..Limits::default()
    }
}

/// Fronts are of two or three costs.
fn check_front(objective: &Objective) -> Result<(), Failure> {
    match objective.costs().len() {
        2 | 3 => Ok(()),
        _ => Err(Failure::Usage(format!(
            "found the objective {objective}, expected two or three costs for --pareto"
        ))),
    }
}

fn exit(status: Status) -> Exit {
    match status {
        Status::Optimal | Status::Feasible | Status::Impossible => Exit::Answered,
        Status::Unknown => Exit::Unknown,
    }
}
