//! An instance from any of the formats that hold one.

use std::path::Path;

use giveway_model::format::native;
use giveway_model::{Fault, Instance, words::count};

use super::{Kind, Maps, Scen, Source, foreign, is_standard_input, rules};
use crate::{
    args,
    failure::Failure,
    output::{Said, stream},
};

/// Reads the instance of a command line, and adds its notes to what is said. Goals that its
/// file leaves open are decided by the plan beside it.
///
/// # Errors
/// When a file cannot be read or is no instance, or `--map` has no use.
pub(crate) fn instance(
    source: &args::Source,
    plan: Option<&Path>,
    common: &args::Common,
    said: &mut Said,
) -> Result<Instance, Failure> {
    let mut read = read(source, plan, common, said)?;
    for text in &source.constraints {
        let (with, note) = rules::with_rule(&read, text)?;
        read = with;
        said.add([note]);
    }
    said.add(source.ruling.notes());
    said.assume(&read);
    Ok(read)
}

fn read(
    source: &args::Source,
    plan: Option<&Path>,
    common: &args::Common,
    said: &mut Said,
) -> Result<Instance, Failure> {
    let (first, ruling) = (source.first.agents, source.ruling);
    let text = Source::read(&source.instance)?;
    said.add(text.note.clone());
    match Kind::of(&text) {
        Kind::Scenario => {
            let maps = Maps::new(&[], common.map.as_deref())?;
            let scen = Scen::read(text)?;
            said.add(scen.note());
            let map = maps.of(&scen)?;
            if let Some(note) = map.note(&scen).filter(|_| !common.quiet) {
                stream::note(&note);
            }
            let alone = scen.instance(&map, first, ruling);
            match (alone, plan.filter(|path| !is_standard_input(path))) {
                // The plan may tell which lines count.
                (Err(_), Some(plan)) => {
                    let sources = [map.source, scen.source().clone(), Source::read(plan)?];
                    let wanted = foreign::Wanted {
                        agents: first,
                        ruling,
                        ..foreign::Wanted::default()
                    };
                    let together = foreign::combine(&sources, wanted)?;
                    said.add(together.notes);
                    Ok(together.instance)
                }
                (alone, _) => alone,
            }
        }
        Kind::Foreign => foreign::instance_in(text, plan, source, common, said),
        Kind::Map => Err(text.fault(without_robots())),
        Kind::Native if common.map.is_none() => native(&text, first, ruling),
        Kind::Native => Err(Failure::Usage(format!(
            "--map is for a scenario, and {} is not one",
            text.name
        ))),
    }
}

/// A map alone where an instance is expected.
pub(super) fn without_robots() -> Fault {
    Fault::at(
        "",
        "a map, which has no robots",
        "an instance, such as a scenario of this map",
    )
}

/// Reads a native instance, and keeps its first agents.
///
/// # Errors
/// Every fault of the whole file, or too few agents.
pub(crate) fn native(
    source: &Source,
    first: Option<usize>,
    ruling: args::Ruling,
) -> Result<Instance, Failure> {
    giveway_formats::read(&source.text).map_err(|faults| source.faults(faults))?;
    // What is no instance is named by the reader of one.
    let mut scene = native::read_scene(&source.text).map_err(|fault| source.fault(fault))?;
    ruling.set(&mut scene.rules);
    let mut instance = Instance::new(scene)
        .map_err(|faults| source.faults(native::in_text(&source.text, faults)))?;
    let Some(first) = first else {
        return Ok(instance);
    };
    let there = instance.agents().len();
    if there < first {
        let found = count(there, "robot");
        let fault = Fault::at("agents", found, format!("{first}, as asked with --agents"));
        return Err(source.faults(native::in_text(&source.text, vec![fault])));
    }
    instance.truncate_agents(first);
    Ok(instance)
}
