//! A MovingAI scenario and the map that belongs to it.

use std::path::{Path, PathBuf};

use giveway_model::{
    Fault, Grid, Instance,
    format::movingai::{self, Scenario},
};

use super::Source;
use crate::failure::Failure;

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
        match movingai::read_map(&source.text) {
            Ok(grid) => Ok(Self { source, grid }),
            Err(fault) => Err(source.fault(fault)),
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

    /// Its instance on a map, with the first agents or all of them.
    ///
    /// # Errors
    /// When the map has another size than the scenario says, the scenario has
    /// too few lines, or two of its agents exclude each other.
    pub(crate) fn instance(&self, map: &Map, first: Option<usize>) -> Result<Instance, Failure> {
        let name = self.source.stem().unwrap_or_default();
        let scene = movingai::to_scene(&name, &map.grid, &self.scenario, first)
            .map_err(|fault| self.source.fault(fault))?;
        Instance::new(scene).map_err(|faults| self.source.faults(faults))
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
