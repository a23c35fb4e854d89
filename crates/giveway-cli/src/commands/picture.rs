//! `giveway picture`: a plan as a picture, still or moving.

use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

use giveway_model::words::grouped;
use giveway_model::{Instance, Plan};
use giveway_picture::gif::{Failure as NoGif, gif};
use giveway_picture::{Letters, Look, moving, still};

use super::one_standard_input;
use crate::{
    args::{Common, Picture},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{Said, files, raster::Raster, stream},
    progress::StepLine,
};

/// The longest side of a picture where nobody says how large a cell is, in pixels.
const LONGEST: u32 = 2048;
/// The same of a GIF, which has many frames.
const LONGEST_GIF: u32 = 960;
/// The most pixels of a PNG.
const MOST_PIXELS: u64 = 100_000_000;

/// What is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Svg,
    Png,
    Gif,
}

pub(crate) fn run(args: &Picture, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input([&args.source.instance, &args.plan])?;
    let kind = kind(args)?;
    if let Some(output) = &args.output {
        spare([&args.source.instance, &args.plan], output)?;
    }
    let mut said = Said::default();
    let instance = input::instance(&args.source, Some(&args.plan), common, &mut said)?;
    let plan = input::plan(&args.plan, &instance, common, &mut said)?;
    for note in said.notes() {
        stream::note(&format!("note: {note}"));
    }
    known(&instance, &plan, &args.plan)?;
    let look = look(args, &instance, kind);
    let bytes = match kind {
        Kind::Svg if args.animate => moving(&instance, &plan, &look).into_bytes(),
        Kind::Svg => still(&instance, &plan, args.at, &look).into_bytes(),
        Kind::Png => png(&instance, &plan, args.at, &look)?,
        Kind::Gif => frames(&instance, &plan, &look, StepLine::new(clock, common.quiet))?,
    };
    match &args.output {
        Some(path) => files::write(path, &bytes)?,
        None => stream::file(&bytes)?,
    }
    Ok(Exit::Answered)
}

/// What the name of the file asks for.
fn kind(args: &Picture) -> Result<Kind, Failure> {
    let Some(path) = &args.output else {
        return Ok(Kind::Svg);
    };
    let ending = path
        .extension()
        .map(|it| it.to_string_lossy().to_ascii_lowercase());
    let expected = match (ending.as_deref(), args.animate) {
        (Some("svg"), _) => return Ok(Kind::Svg),
        (Some("png"), false) => return Ok(Kind::Png),
        (Some("gif"), true) => return Ok(Kind::Gif),
        (Some("png"), true) => "a name that ends in .svg or .gif, as a PNG does not move",
        (Some("gif"), false) => "a name that ends in .svg or .png, or --animate",
        _ => "a name that ends in .svg, .png or .gif",
    };
    let name = path.display();
    Err(Failure::Usage(format!(
        "found {name} to write to, expected {expected}"
    )))
}

/// A file that was read is not written over.
fn spare<'a>(
    read: impl IntoIterator<Item = &'a std::path::PathBuf>,
    output: &Path,
) -> Result<(), Failure> {
    let real = |path: &Path| fs::canonicalize(path).ok();
    let target = real(output);
    if target.is_some() && read.into_iter().any(|path| real(path) == target) {
        let name = output.display();
        return Err(Failure::Usage(format!(
            "{name} is an input file and would be overwritten, expected another file for --output"
        )));
    }
    Ok(())
}

/// A plan for none of the robots is one for another instance.
fn known(instance: &Instance, plan: &Plan, file: &Path) -> Result<(), Failure> {
    let mut agents = instance.agents().iter();
    if plan.paths.is_empty() || agents.any(|agent| plan.paths.contains_key(&agent.name)) {
        return Ok(());
    }
    let name = plan.paths.keys().next().map_or("", String::as_str);
    let fault = giveway_model::Fault::at(
        format!("paths.{name}"),
        "a robot that the instance does not have, and none that it has",
        "paths of its robots",
    );
    Err(Failure::input(file.to_string_lossy(), fault))
}

fn look(args: &Picture, instance: &Instance, kind: Kind) -> Look {
    let longest = if kind == Kind::Gif {
        LONGEST_GIF
    } else {
        LONGEST
    };
    let fitting = Look::fitting(instance.grid(), longest);
    Look {
        theme: args.look.into(),
        cell: args.cell.unwrap_or(fitting.cell),
        letters: if kind == Kind::Svg {
            Letters::Text
        } else {
            Letters::Strokes
        },
        ..fitting
    }
}

fn png(instance: &Instance, plan: &Plan, time: f64, look: &Look) -> Result<Vec<u8>, Failure> {
    let grid = instance.grid();
    let pixels = |cells: u32| u64::from(cells) * u64::from(look.cell);
    let all = pixels(grid.width()) * pixels(grid.height());
    if all > MOST_PIXELS {
        return Err(Failure::Refused(vec![format!(
            "The picture is too large: {} pixels. Make the cells smaller with --cell.",
            grouped(all)
        )]));
    }
    let svg = still(instance, plan, time, look);
    let drawn = Raster::of(&svg).and_then(|raster| raster.png());
    drawn.map_err(|sentence| Failure::Refused(vec![sentence]))
}

/// A GIF of all frames.
fn frames(
    instance: &Instance,
    plan: &Plan,
    look: &Look,
    mut line: StepLine,
) -> Result<Vec<u8>, Failure> {
    let mut ground = None;
    let made = gif(
        instance,
        plan,
        look,
        |shot| {
            if let Some(svg) = &shot.ground {
                ground = Some(Raster::of(svg)?);
            }
            let ground = ground.as_ref().ok_or("The first frame has no ground.")?;
            ground.under(&shot.over).map(Raster::pixels)
        },
        |done, all| {
            line.show(|| format!("Drawing frame {} of {all} ...", done + 1));
            ControlFlow::Continue(())
        },
    );
    line.clear();
    made.map_err(|failure| {
        Failure::Refused(vec![match failure {
            NoGif::TooLarge(large) => large.to_string(),
            NoGif::Draw(sentence) => sentence,
            NoGif::Broken(broken) => broken.to_string(),
            NoGif::Stopped => "The GIF was stopped.".to_owned(),
        }])
    })
}
