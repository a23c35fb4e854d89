//! Files of other people's planners, with the map that they need looked for.

use std::path::{Path, PathBuf};

use giveway_model::format::foreign::{
    self, Conventions, ForeignPlan, Gathered, Missing, Options, Refused,
};
use giveway_model::{Instance, Plan, format::native};

use super::Source;
use crate::{
    args::{Common, Reading},
    failure::Failure,
    output::stream,
};

/// How files of a command line are gathered.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Wanted<'a> {
    /// The file of `--map`.
    pub(crate) map: Option<&'a Path>,
    /// The first agents of a scenario.
    pub(crate) agents: Option<usize>,
    /// How plans are to be read.
    pub(crate) reading: Reading,
}

/// Matches files to each other. A map that is missing is the one of `--map`, or the
/// file beside the others that has its name.
///
/// # Errors
/// When a file is wrong, a map is still missing, or they do not belong together.
pub(crate) fn gather(sources: &[Source], wanted: Wanted<'_>) -> Result<Gathered, Failure> {
    let mut options = Options {
        agents: wanted.agents,
        conventions: None,
    };
    let mut sources = sources.to_vec();
    let mut gathered = try_gather(&sources, &options);
    if let Err(Refused::Missing {
        what: Missing::Map(name),
        ..
    }) = &gathered
        && let Some(path) = map_for(&sources, name.as_deref(), wanted.map)
    {
        sources.push(Source::read(&path)?);
        gathered = try_gather(&sources, &options);
    }
    let first = gathered.as_ref().ok().and_then(|all| all.plans.first());
    if let Some(chosen) = first.and_then(|plan| wanted.reading.over(plan.conventions)) {
        options.conventions = Some(chosen);
        gathered = try_gather(&sources, &options);
    }
    gathered.map_err(|refused| failure(&sources, refused))
}

fn try_gather(sources: &[Source], options: &Options) -> Result<Gathered, Refused> {
    let texts: Vec<foreign::Source<'_>> = sources
        .iter()
        .map(|source| foreign::Source {
            name: &source.name,
            text: &source.text,
        })
        .collect();
    foreign::gather(&texts, options)
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

/// The instance in a file of others, and what is to be noted of it.
///
/// # Errors
/// As [`gather`].
pub(crate) fn instance_in(
    source: Source,
    agents: Option<usize>,
    common: &Common,
) -> Result<Instance, Failure> {
    let wanted = Wanted {
        map: common.map.as_deref(),
        agents,
        ..Wanted::default()
    };
    let gathered = gather(&[source], wanted)?;
    for note in gathered.notes.iter().filter(|_| !common.quiet) {
        stream::note(&format!("note: {note}"));
    }
    Ok(gathered.instance)
}

/// The plan in a file of others, read for an instance; how it was read is noted.
///
/// # Errors
/// As [`gather`].
pub(crate) fn plan_for(
    instance: &Instance,
    source: &Source,
    common: &Common,
) -> Result<Plan, Failure> {
    let scene = Source {
        path: None,
        name: "the instance".to_owned(),
        text: native::write_scene(&instance.to_scene()),
    };
    let with_instance = gather(&[scene, source.clone()], Wanted::default());
    let gathered = match with_instance {
        // A file with an instance of its own: its plan is by names, too.
        Err(refused @ Failure::Refused(_)) => {
            gather(std::slice::from_ref(source), Wanted::default()).map_err(|_| refused)?
        }
        gathered => gathered?,
    };
    let plan = gathered.plans.into_iter().next();
    let plan = plan.ok_or_else(|| Failure::Refused(vec![no_plan(&source.name)]))?;
    if !common.quiet {
        stream::note(&format!("note: {}", how(&source.name, &plan)));
    }
    Ok(plan.plan)
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
