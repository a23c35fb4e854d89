//! A MovingAI scenario and the map that belongs to it.

use std::path::{Path, PathBuf};

use giveway_formats::movingai::{self, Route, Scenario};
use giveway_model::{Fault, Grid, Instance};

use super::Source;
use crate::{args::Ruling, failure::Failure};

/// A scenario as it was read.
pub(crate) struct Scen {
    source: Source,
    scenario: Scenario,
}

/// A map as it was read.
#[derive(Clone)]
pub(crate) struct Map {
    /// Where it came from.
    pub(crate) source: Source,
    /// The map itself.
    pub(crate) grid: Grid,
}

/// The maps that a command line gives.
pub(crate) struct Maps<'a> {
    /// Those that stand among the files.
    given: &'a [Map],
    /// That of `--map`.
    option: Option<Map>,
}

impl Map {
    /// Reads a map.
    ///
    /// # Errors
    /// When the text is no map.
    pub(crate) fn read(source: Source) -> Result<Self, Failure> {
        let grid = match giveway_formats::read(&source.text) {
            Ok((_, giveway_formats::Held::Map(grid, _))) => Ok(grid),
            // What is no map is named by the reader of one.
            Ok(_) => movingai::read_map(&source.text).map_err(|fault| vec![fault]),
            Err(faults) => Err(faults),
        };
        match grid {
            Ok(grid) => Ok(Self { source, grid }),
            Err(faults) => Err(source.faults(faults)),
        }
    }

    /// Whether its file has this name.
    fn bears(&self, name: &str) -> bool {
        let path = self.source.path.as_deref();
        path.and_then(Path::file_name)
            .is_some_and(|own| own == name)
    }

    /// A word of caution, where the map has another name than the scenario says.
    pub(crate) fn note(&self, scen: &Scen) -> Option<String> {
        let name = scen.map_name();
        (!name.is_empty() && !self.bears(name)).then(|| {
            format!(
                "note: {} is made for the map {name}; {} is used for it",
                scen.source.name, self.source.name
            )
        })
    }
}

impl Scen {
    /// Reads a scenario.
    ///
    /// # Errors
    /// When the text is no scenario.
    pub(crate) fn read(source: Source) -> Result<Self, Failure> {
        match movingai::read_scenario(&source.text) {
            Ok(scenario) => Ok(Self { source, scenario }),
            Err(fault) => Err(source.fault(fault)),
        }
    }

    /// What a person should know of the file, where there is something.
    pub(crate) fn note(&self) -> Option<String> {
        let note = self.scenario.note()?;
        Some(format!("{}: {note}", self.source.name))
    }

    /// Its instance on a map, with the first agents or all of them.
    ///
    /// # Errors
    /// When the map has another size than the scenario says, the scenario has
    /// too few lines, or two of its agents exclude each other.
    pub(crate) fn instance(
        &self,
        map: &Map,
        first: Option<usize>,
        ruling: Ruling,
    ) -> Result<Instance, Failure> {
        let name = self.source.stem().unwrap_or_default();
        let scene = movingai::to_scene(&name, &map.grid, &self.scenario, first);
        let mut scene =
            scene.map_err(|fault| self.source.faults(self.faults(map, first, fault)))?;
        ruling.set(&mut scene.rules);
        Instance::new(scene).map_err(|faults| self.source.faults(faults))
    }

    /// Every line that is no task on the map, else the one fault.
    fn faults(&self, map: &Map, first: Option<usize>, fault: Fault) -> Vec<Fault> {
        let alone = |route: &Route| {
            let one = Scenario {
                lacks_version: false,
                routes: vec![route.clone()],
            };
            movingai::to_scene("", &map.grid, &one, Some(1)).err()
        };
        let routes = self.scenario.routes.iter();
        let routes = routes.take(first.unwrap_or(usize::MAX));
        let faults: Vec<Fault> = routes.clone().filter_map(alone).collect();
        // All lines at once are wrong where the map is another one.
        if faults.is_empty() || faults.len() == routes.len() {
            vec![fault]
        } else {
            faults
        }
    }

    /// The text that it was read from.
    pub(crate) const fn source(&self) -> &Source {
        &self.source
    }

    /// The name of its map, without folders; empty where it has none.
    fn map_name(&self) -> &str {
        base(self.scenario.map_name().unwrap_or_default())
    }

    /// The file beside it that has the name of its map.
    fn map_beside(&self) -> Option<PathBuf> {
        let folder = self.source.path.as_ref()?.parent()?;
        let name = self.map_name();
        let path = folder.join(name);
        (!name.is_empty() && path.is_file()).then_some(path)
    }
}

impl<'a> Maps<'a> {
    /// The maps among the files of a command line, and that of `--map`.
    ///
    /// # Errors
    /// When the file of `--map` cannot be read or is no map.
    pub(crate) fn new(given: &'a [Map], option: Option<&Path>) -> Result<Self, Failure> {
        let option = option
            .map(Source::read)
            .transpose()?
            .map(Map::read)
            .transpose()?;
        Ok(Self { given, option })
    }

    /// The map of a scenario: the given one that bears its name, else that of
    /// `--map`, else the file beside the scenario.
    ///
    /// # Errors
    /// When there is none, or the file beside it is no map.
    pub(crate) fn of(&self, scen: &Scen) -> Result<Map, Failure> {
        if let Some(map) = self.given.iter().find(|map| map.bears(scen.map_name())) {
            return Ok(map.clone());
        }
        if let Some(map) = &self.option {
            return Ok(map.clone());
        }
        match scen.map_beside() {
            Some(path) => Map::read(Source::read(&path)?),
            None => Err(scen.source.fault(no_map(scen))),
        }
    }
}

fn no_map(scen: &Scen) -> Fault {
    let name = scen.map_name();
    if scen.source.path.is_some() {
        let found = format!("no map \"{name}\" beside the scenario");
        Fault::at("", found, "its map there or with --map")
    } else {
        let found = format!("a scenario for the map \"{name}\"");
        Fault::at("", found, "that map with --map as well")
    }
}

/// The last part of a path, whichever system wrote it.
fn base(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}
