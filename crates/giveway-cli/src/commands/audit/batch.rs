//! Many plans, one line of JSON each. A file that is wrong has a line, too, and the
//! others go on.

use giveway_formats::Held;
use giveway_model::Version;
use giveway_model::format::{base_name, stem};
use serde::Serialize;

use super::{exit, only_plan, plan::audited, wanted};
use crate::{
    args::{Audit, Common},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input::{Source, foreign::combine},
    output::stream,
};

/// A file of the command line.
enum File {
    /// Maps, scenarios and instances: what plans are for.
    Base(Base),
    Plan {
        source: Source,
        /// The name of its map, where it says so.
        map: Option<String>,
    },
    /// What is wrong with it.
    Wrong { name: String, failure: Failure },
}

/// What plans are for.
struct Base {
    part: Part,
    source: Source,
    /// The name of its map, where it is a scenario that says so.
    map: Option<String>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Map,
    Scenario,
    Scene,
}

/// A line about a file that is wrong.
#[derive(Serialize)]
struct ErrorLine {
    giveway: Version,
    file: String,
    error: String,
}

pub(super) fn run(args: &Audit, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    let files: Vec<File> = args.files.iter().map(|path| read(path)).collect();
    if files.iter().all(|file| matches!(file, File::Base(_))) {
        return Err(Failure::Refused(vec![
            "There is no plan in these files.".to_owned(),
        ]));
    }
    let bases = || {
        files.iter().filter_map(|file| match file {
            File::Base(base) => Some(base),
            _ => None,
        })
    };
    let mut worst = Exit::Answered;
    for file in &files {
        let (name, line) = match file {
            File::Base(_) => continue,
            File::Wrong { name, failure } => (name, Err(failure.lines())),
            File::Plan { source, map } => {
                let audited = chosen(bases(), source, map.as_deref())
                    .and_then(|mut sources| {
                        sources.push(source.clone());
                        combine(&sources, wanted(args, common))
                    })
                    .and_then(|combined| only_plan(combined, args.ruling))
                    .and_then(|subject| audited(subject, args, common, clock));
                (&source.name, audited.map_err(|failure| failure.lines()))
            }
        };
        let ended = match line {
            Ok(audited) => {
                write(&audited.object())?;
                exit(audited.answer.status)
            }
            Err(lines) => {
                write(&ErrorLine {
                    giveway: Version,
                    file: name.clone(),
                    error: lines.join("; "),
                })?;
                Exit::Wrong
            }
        };
        worst = match (worst, ended) {
            (Exit::Wrong, _) | (_, Exit::Answered) => worst,
            (_, ended) => ended,
        };
    }
    Ok(worst)
}

/// Reads a file, and tells what it is.
fn read(path: &std::path::Path) -> File {
    let wrong = |failure| File::Wrong {
        name: path.to_string_lossy().into_owned(),
        failure,
    };
    let source = match Source::read(path) {
        Ok(source) => source,
        Err(failure) => return wrong(failure),
    };
    let held = match giveway_formats::read(&source.text) {
        Ok((_, held)) => held,
        Err(faults) => return wrong(source.faults(faults)),
    };
    let base = |part, source| {
        File::Base(Base {
            part,
            source,
            map: None,
        })
    };
    match held {
        Held::Map(..) => base(Part::Map, source),
        Held::Scenario(scenario) => File::Base(Base {
            part: Part::Scenario,
            source,
            map: scenario.map_name().map(str::to_owned),
        }),
        Held::Scene(..) | Held::Problem(_) => base(Part::Scene, source),
        Held::OwnPlan(..)
        | Held::Both(..)
        | Held::NoPlan(_)
        | Held::Changes(_)
        | Held::Asked(_) => File::Plan { source, map: None },
        Held::Plan(plan) => File::Plan {
            source,
            map: plan.map,
        },
    }
}

/// What a plan is for. Of several maps, that of the plan's own word; else, and of
/// several scenarios and scenes, the one whose name the name of the plan begins with.
fn chosen<'a>(
    bases: impl Iterator<Item = &'a Base>,
    plan: &Source,
    map: Option<&str>,
) -> Result<Vec<Source>, Failure> {
    let all: Vec<&Base> = bases.collect();
    let of = |part: Part| -> Vec<&Base> {
        let those = all.iter().copied();
        those.filter(|base| base.part == part).collect()
    };
    let name = base_name(&plan.name);
    let fits = |base: &Base, map: Option<&str>| {
        let own = stem(base_name(&base.source.name)).to_owned();
        let named = map.is_some_and(|map| stem(base_name(map)) == own);
        (named || name.starts_with(&own)).then_some((named, own.len()))
    };
    let mut sources = Vec::new();
    // A plan that does not name its map has that of its scenario.
    let mut map = map.map(str::to_owned);
    for part in [Part::Scenario, Part::Map, Part::Scene] {
        let there = of(part);
        let best = match there.as_slice() {
            [only] => Some(*only),
            several => {
                let fitting = several.iter();
                let fitting = fitting.filter_map(|base| Some((fits(base, map.as_deref())?, *base)));
                fitting.max_by_key(|(fit, _)| *fit).map(|(_, base)| base)
            }
        };
        if best.is_none() && part == Part::Map && !there.is_empty() {
            let maps: Vec<String> = there.iter().map(|base| base.source.name.clone()).collect();
            return Err(Failure::Refused(vec![format!(
                "It is open which map {} is for: {}. Name the plan after its map, or give it alone with its map.",
                plan.name,
                maps.join(", ")
            )]));
        }
        if let (None, Some(Base { map: own, .. })) = (&map, best) {
            map.clone_from(own);
        }
        sources.extend(best.map(|base| base.source.clone()));
    }
    Ok(sources)
}

/// Writes an object in one line.
fn write(object: &impl Serialize) -> Result<(), Failure> {
    let mut line = serde_json::to_string(object)
        .map_err(|error| Failure::output("standard output", error.into()))?;
    line.push('\n');
    stream::file(line.as_bytes())
}
