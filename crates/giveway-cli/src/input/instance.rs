//! An instance from any of the formats that hold one.

use giveway_model::{Fault, Instance, format::native, words::count};

use super::{Kind, Maps, Scen, Source, foreign};
use crate::{args, failure::Failure, output::stream};

/// Reads the instance of a command line, and tells its notes on standard error
/// unless `quiet`.
///
/// # Errors
/// When a file cannot be read or is no instance, or `--map` has no use.
pub(crate) fn instance(source: &args::Source, common: &args::Common) -> Result<Instance, Failure> {
    let first = source.first.agents;
    let text = Source::read(&source.instance)?;
    match Kind::of(&text) {
        Kind::Scenario => {
            let maps = Maps::new(&[], common.map.as_deref())?;
            let scen = Scen::read(text)?;
            let map = maps.of(&scen)?;
            if let Some(note) = map.note(&scen).filter(|_| !common.quiet) {
                stream::note(&note);
            }
            scen.instance(&map, first)
        }
        Kind::Foreign => foreign::instance_in(text, first, common),
        Kind::Map => Err(text.fault(Fault::at(
            "",
            "a map, which has no robots",
            "an instance, such as a scenario of this map",
        ))),
        Kind::Scene | Kind::Plan | Kind::Answer if common.map.is_none() => native(&text, first),
        Kind::Scene | Kind::Plan | Kind::Answer => Err(Failure::Usage(format!(
            "--map is for a scenario, and {} is not one",
            text.name
        ))),
    }
}

/// Reads a native instance, and keeps its first agents.
///
/// # Errors
/// Every fault of the whole file, or too few agents.
pub(crate) fn native(source: &Source, first: Option<usize>) -> Result<Instance, Failure> {
    let mut instance =
        native::read_instance(&source.text).map_err(|faults| source.faults(faults))?;
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
