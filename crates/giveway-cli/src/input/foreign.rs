//! Files of other people's planners, with the map that they need looked for.

use std::path::{Path, PathBuf};

use giveway_formats::{Combined, Conventions, ForeignPlan, Missing, Options, Refused};
use giveway_model::constraint::ConstraintKind;
use giveway_model::format::{base_name, native};
use giveway_model::{Assumption, Instance, LeftOutRule, Plan, assumption};

use super::{Source, instance::without_robots, is_standard_input};
use crate::{
    args::{self, Common, Reading, Ruling},
    failure::Failure,
    output::{Said, stream},
};

/// How files of a command line are combined.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Wanted<'a> {
    /// The file of `--map`.
    pub(crate) map: Option<&'a Path>,
    /// The first agents of a scenario.
    pub(crate) agents: Option<usize>,
    /// How plans are to be read.
    pub(crate) reading: Reading,
    /// The rules of the problem.
    pub(crate) ruling: Ruling,
}

/// Matches files to each other. A map that is missing is the one of `--map`, or the
/// file beside the others that has its name.
///
/// # Errors
/// When a file is wrong, a map is still missing, or they do not belong together.
pub(crate) fn combine(sources: &[Source], wanted: Wanted<'_>) -> Result<Combined, Failure> {
    let mut options = Options {
        agents: wanted.agents,
        conventions: None,
        at_goal: wanted.ruling.at_goal(),
        battery_floor: wanted.ruling.floor,
    };
    let mut sources = sources.to_vec();
    let mut combined = try_combine(&sources, &options);
    if let Err(Refused::Missing {
        what: Missing::Map(name),
        ..
    }) = &combined
        && let Some(path) = map_for(&sources, name.as_deref(), wanted.map)
    {
        sources.push(Source::read(&path)?);
        combined = try_combine(&sources, &options);
    }
    if let Err(Refused::Missing {
        what: Missing::Files(names),
        ..
    }) = &combined
    {
        for path in beside(&sources, names) {
            sources.push(Source::read(&path)?);
        }
        combined = try_combine(&sources, &options);
    }
    let first = combined.as_ref().ok().and_then(|all| all.plans.first());
    if let Some(chosen) = first.and_then(|plan| wanted.reading.over(plan.conventions)) {
        options.conventions = Some(chosen);
        combined = try_combine(&sources, &options);
    }
    let mut combined = combined.map_err(|refused| failure(&sources, refused))?;
    let notes = sources.iter().filter_map(|source| source.note.clone());
    combined.notes.extend(notes);
    Ok(combined)
}

fn try_combine(sources: &[Source], options: &Options) -> Result<Combined, Refused> {
    let texts: Vec<giveway_formats::Source<'_>> = sources
        .iter()
        .map(|source| giveway_formats::Source {
            name: &source.name,
            text: &source.text,
        })
        .collect();
    giveway_formats::combine(&texts, options)
}

/// The map of `--map`, else the file beside one of the files that has its name.
fn map_for(sources: &[Source], name: Option<&str>, given: Option<&Path>) -> Option<PathBuf> {
    if let Some(given) = given {
        return Some(given.to_owned());
    }
    let name = name?;
    let names = [name.to_owned(), format!("{name}.map")];
    let folders = sources
        .iter()
        .filter_map(|source| source.path.as_ref()?.parent());
    let mut paths = folders.flat_map(|folder| names.iter().map(|name| folder.join(name)));
    paths.find(|path| path.is_file())
}

/// Those of some files that are beside one of the sources, by their names with their
/// folders or without.
fn beside(sources: &[Source], names: &[String]) -> Vec<PathBuf> {
    let find = |name: &String| {
        let folders = sources
            .iter()
            .filter_map(|source| source.path.as_ref()?.parent());
        let mut paths =
            folders.flat_map(|folder| [folder.join(name), folder.join(base_name(name))]);
        paths.find(|path| path.is_file())
    };
    names.iter().filter_map(find).collect()
}

/// A refusal as a failure that names the files as the person wrote them.
fn failure(sources: &[Source], refused: Refused) -> Failure {
    match refused {
        Refused::File { file, faults } => {
            let is_it = |source: &&Source| {
                let name = source.path.as_deref().and_then(Path::file_name);
                name.is_some_and(|name| *name == *file) || source.name == file
            };
            let name = sources.iter().find(is_it).map(|source| source.name.clone());
            Failure::Input {
                file: name.unwrap_or(file),
                faults,
            }
        }
        Refused::Missing {
            sentence,
            what: Missing::Map(_),
            ..
        } => Failure::Refused(vec![format!("{sentence} Or give it with --map.")]),
        Refused::Missing { sentence, .. } | Refused::Apart(sentence) => {
            Failure::Refused(vec![sentence])
        }
    }
}

/// The instance in a file of others. Goals that the file leaves open are decided by the
/// plan beside it, where that is a file.
///
/// # Errors
/// As [`combine`].
pub(crate) fn instance_in(
    source: Source,
    plan: Option<&Path>,
    args: &args::Source,
    common: &Common,
    said: &mut Said,
) -> Result<Instance, Failure> {
    let wanted = Wanted {
        map: common.map.as_deref(),
        agents: args.first.agents,
        ruling: args.ruling,
        ..Wanted::default()
    };
    // Its note on the encoding was told when it was read.
    let source = Source {
        note: None,
        ..source
    };
    let alone = combine(std::slice::from_ref(&source), wanted)?;
    if alone.instance.agents().is_empty() {
        return Err(source.fault(without_robots()));
    }
    let is_open = alone
        .instance
        .assumptions()
        .contains(&Assumption::GoalsChosen);
    let plan = plan.filter(|path| is_open && !is_standard_input(path));
    if let Some(plan) = plan.and_then(|path| Source::read(path).ok())
        && let Ok(together) = combine(&[source, plan], wanted)
    {
        said.add(together.notes);
        let objective = alone.instance.objective().clone();
        return Ok(together.instance.with_objective(objective));
    }
    said.add(alone.notes);
    Ok(alone.instance)
}

/// The plan in a file of others, read for an instance; how it was read is noted.
///
/// # Errors
/// As [`combine`].
pub(crate) fn plan_for(
    instance: &Instance,
    source: &Source,
    common: &Common,
    said: &mut Said,
) -> Result<Plan, Failure> {
    let scene = Source {
        path: None,
        name: "the instance".to_owned(),
        text: native::write_scene(&instance.to_scene()),
        note: None,
    };
    let with_instance = combine(&[scene, source.clone()], Wanted::default());
    let combined = match with_instance {
        // A file with an instance of its own: its plan is by names, too.
        Err(refused @ Failure::Refused(_)) => {
            combine(std::slice::from_ref(source), Wanted::default()).map_err(|_| refused)?
        }
        combined => combined?,
    };
    let plan = combined.plans.into_iter().next();
    let plan = plan.ok_or_else(|| Failure::Refused(vec![no_plan(&source.name)]))?;
    if !common.quiet {
        stream::note(&format!("note: {}", how(&source.name, &plan)));
    }
    said.add(plan.notes);
    let new = combined.instance.assumptions().iter();
    let new = new.filter(|one| !instance.assumptions().contains(one));
    let mut new: Vec<Assumption> = new.cloned().collect();
    // The plan is judged by the rules of the instance alone.
    if turns(&combined.instance) && !turns(instance) {
        let rule = LeftOutRule::Turning;
        new.push(Assumption::RuleLeftOut { rule });
    }
    said.add(assumption::sentences(&new));
    Ok(plan.plan)
}

/// Whether turns take time.
fn turns(instance: &Instance) -> bool {
    let mut rules = instance.constraints_in_force();
    rules.any(|rule| matches!(rule.constraint.kind, ConstraintKind::Turns { .. }))
}

fn no_plan(name: &str) -> String {
    format!("There is no plan in {name}.")
}

/// How a plan was read: `plan.txt is read as paths.txt (cells row first)`.
fn how(name: &str, plan: &ForeignPlan) -> String {
    let words = plan
        .words
        .iter()
        .map(|(about, how)| format!("{about} {how}"));
    let words: Vec<String> = words.collect();
    let read = if words.is_empty() {
        String::new()
    } else {
        format!(", {}", words.join(", "))
    };
    format!("{name} is read as {}{read}", plan.format)
}

impl Reading {
    /// These conventions with what a person chose of them; `None` where nothing was
    /// chosen.
    fn over(self, decided: Conventions) -> Option<Conventions> {
        let chosen = self.cells.is_some() || self.origin.is_some() || self.up.is_some();
        chosen.then(|| Conventions {
            cells: self.cells.map_or(decided.cells, Into::into),
            origin: self.origin.map_or(decided.origin, Into::into),
            up: self.up.map_or(decided.up, Into::into),
        })
    }
}
