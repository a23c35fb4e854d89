//! `giveway sizing`: how many robots a floor bears.

use giveway_model::{Instance, Scene, fleet::Fleet, format::native};
use giveway_solve::sizing::{SizingRequest, csv};
use giveway_solve::{Limits, Request, Response, serve};

use super::{one_standard_input, refused, unexpected};
use crate::{
    args::{Common, Ruling, Sizing, Source},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{self, Said, files, text},
    progress::CommandHost,
};

pub(crate) fn run(args: &Sizing, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input([&args.source.instance].into_iter().chain(&args.beside))?;
    let mut said = Said::default();
    let instance = input::instance(&args.source, None, common, &mut said)?;
    let scene = peopled(instance.to_scene(), args, &mut said)?;
    if let Some(path) = &args.save {
        files::write(path, native::write_scene(&scene).as_bytes())?;
    }
    let beside = args.beside.as_ref().map(|file| {
        let source = Source {
            instance: file.clone(),
            first: args.source.first,
            ruling: Ruling::default(),
            constraints: Vec::new(),
        };
        let floor = input::instance(&source, None, common, &mut Said::default())?;
        let mut floor = peopled(floor.to_scene(), args, &mut Said::default())?;
        floor.agents.clone_from(&scene.agents);
        Ok::<Scene, Failure>(floor)
    });
    let request = SizingRequest {
        beside: beside.transpose()?,
        counts: args.robots.all(),
        objective: args.objective.clone(),
        within: args.within,
        limits: Limits {
            seconds: Some(args.seconds),
            ..Limits::default()
        },
        scene,
    };
    let host = CommandHost::new(clock, common.quiet, instance.objective().clone());
    let response = serve(&Request::Sizing(request), &host);
    host.finish();
    match response {
        Response::Sized(answer) if args.csv => {
            output::stream::result(&csv(&answer, ("this floor", "beside")))?;
            Ok(Exit::Answered)
        }
        Response::Sized(answer) => {
            output::answer(common.format, &said, &answer, |_| {
                text::sizing(&instance, &answer)
            })?;
            Ok(if answer.points.is_empty() {
                Exit::Unknown
            } else {
                Exit::Answered
            })
        }
        Response::Refused(refusal) => Err(refused(refusal, &args.source.instance)),
        _ => Err(unexpected(&args.source.instance)),
    }
}

/// The floor with the robots that are drawn onto it, where they are said; rules that name a
/// robot go with the robots that were there.
fn peopled(scene: Scene, args: &Sizing, said: &mut Said) -> Result<Scene, Failure> {
    let Some((starts, goals)) = args.starts.zip(args.goals) else {
        return Ok(scene);
    };
    let mut floor = Scene {
        agents: Vec::new(),
        ..scene
    };
    let before = floor.constraints.len();
    floor
        .constraints
        .retain(|rule| rule.named_agents().next().is_none());
    let gone = before - floor.constraints.len();
    if gone > 0 {
        said.add([format!(
            "Rules that name a robot of the instance do not count: {gone}."
        )]);
    }
    let grid = Instance::new(floor.clone()).map_err(|faults| Failure::Input {
        file: args.source.instance.to_string_lossy().into_owned(),
        faults,
    })?;
    let fleet = Fleet {
        goals: Some((goals.0, goals.1)),
        back: args.back,
        waypoints: args.waypoints,
        battery: args.battery.map(|charge| charge.0),
        draw: args.draw,
        ..Fleet::along(starts.0, starts.1)
    };
    floor.agents = fleet.mixed(grid.grid());
    Ok(floor)
}
