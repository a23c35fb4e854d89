//! Where a sweep's files lie.

use std::fs;
use std::path::{Path, PathBuf};

use giveway_formats::movingai;
use giveway_model::format::{native, read_text};
use giveway_model::{Fault, Instance};
use giveway_solve::Host;

use crate::{Row, Task, run};

/// The folder of a spec: paths in the spec start from it.
#[derive(Clone, Debug)]
pub struct Folder(PathBuf);

/// An instance, with the name of its map if it has one.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The instance, with the agents of its task.
    pub instance: Instance,
    /// The name of its map's file, without the ending.
    pub map: Option<String>,
    /// The folder from which paths start, and in which planners of others run.
    pub folder: PathBuf,
}

impl Loaded {
    /// An instance that is in no file.
    pub const fn of(instance: Instance) -> Self {
        Self {
            instance,
            map: None,
            folder: PathBuf::new(),
        }
    }
}

impl Folder {
    /// A folder.
    pub fn new(path: &Path) -> Self {
        Self(path.to_owned())
    }

    /// The folder in which a spec lies.
    pub fn of(spec: &Path) -> Self {
        Self(spec.parent().map(Path::to_owned).unwrap_or_default())
    }

    /// The files that a pattern stands for, in the order of their names. An absolute path
    /// starts from no folder.
    ///
    /// # Errors
    /// When it is no pattern, or a folder cannot be read.
    pub fn files(&self, pattern: &str) -> Result<Vec<String>, Fault> {
        let base = self.0.to_string_lossy();
        let whole = match base.as_ref() {
            "" => pattern.to_owned(),
            _ if Path::new(pattern).is_absolute() => pattern.to_owned(),
            base => format!("{}/{pattern}", glob::Pattern::escape(base)),
        };
        let wrong = |found: String| Fault::at("files", found, "a path, or a pattern with *");
        let paths =
            glob::glob(&whole).map_err(|error| wrong(format!("\"{pattern}\" ({error})")))?;
        let mut files = Vec::new();
        for path in paths {
            let path = path.map_err(|error| wrong(error.to_string()))?;
            if path.is_file() {
                let own = path.strip_prefix(&self.0).unwrap_or(&path);
                files.push(own.to_string_lossy().replace('\\', "/"));
            }
        }
        if files.is_empty() && self.0.join(pattern).is_file() {
            files.push(pattern.to_owned()); // a name with [ and ] that is meant as it stands
        }
        files.sort();
        Ok(files)
    }

    /// How many agents a scenario has.
    ///
    /// # Errors
    /// When it cannot be read, or is no scenario.
    pub fn agents(&self, path: &str) -> Result<usize, Fault> {
        let wrong = |found: String| {
            Fault::at(
                "agents",
                found,
                "a scenario (.scen), or a last number of agents",
            )
        };
        if Path::new(path)
            .extension()
            .is_none_or(|ending| ending != "scen")
        {
            return Err(wrong(format!("no last number for {path}")));
        }
        let text = read(&self.0.join(path)).map_err(wrong)?;
        let scenario = movingai::read_scenario(&text).map_err(|fault| fault.in_file(path))?;
        Ok(scenario.routes.len())
    }

    /// Does a task: reads its instance, and lets its planner work. `None` where somebody
    /// stopped it: then nothing is known of it.
    pub fn row(&self, task: &Task, host: &dyn Host) -> Option<Row> {
        let row = match self.load(task) {
            Ok(loaded) => run(task, &loaded, host),
            Err(reason) => Row::error(task, reason),
        };
        (!host.cancelled()).then_some(row)
    }

    /// Reads the instance of a task.
    ///
    /// # Errors
    /// Why it is none, as a sentence with the place.
    pub fn load(&self, task: &Task) -> Result<Loaded, String> {
        let path = self.0.join(&task.instance);
        let text = read(&path)?;
        if path.extension().is_some_and(|ending| ending == "scen") {
            let (instance, map) = scenario(&path, &text, task.agents)?;
            let folder = self.0.clone();
            return Ok(Loaded {
                instance,
                map,
                folder,
            });
        }
        if task.agents.is_some() {
            return Err(format!(
                "{}: found a number of agents, expected a scenario (.scen), of which some may be taken",
                path.display()
            ));
        }
        let instance = native::read_instance(&text).map_err(|faults| {
            let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
            format!("{}: {}", path.display(), faults.join("; "))
        })?;
        Ok(Loaded {
            instance,
            map: None,
            folder: self.0.clone(),
        })
    }
}

/// The instance of a scenario, and the name of its map.
fn scenario(
    path: &Path,
    text: &str,
    agents: Option<usize>,
) -> Result<(Instance, Option<String>), String> {
    let at = |fault: Fault| format!("{}: {fault}", path.display());
    let scenario = movingai::read_scenario(text).map_err(at)?;
    let named = scenario.map_name().unwrap_or_default();
    let name = named.rsplit(['/', '\\']).next().unwrap_or(named);
    let beside = path.with_file_name(name);
    let grid = movingai::read_map(&read(&beside)?)
        .map_err(|fault| format!("{}: {fault}", beside.display()))?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let scene = movingai::to_scene(&stem, &grid, &scenario, agents).map_err(at)?;
    let instance = Instance::new(scene).map_err(|faults| {
        let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
        format!("{}: {}", path.display(), faults.join("; "))
    })?;
    let map = beside
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned());
    Ok((instance, map))
}

fn read(path: &Path) -> Result<String, String> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let text = read_text(&bytes).map_err(|fault| format!("{}: {fault}", path.display()))?;
    Ok(text.into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_found_by_pattern_by_absolute_path_and_by_an_odd_name() {
        let place = tempfile::tempdir().unwrap();
        for name in ["b.scen", "a.scen", "c[1].scen"] {
            fs::write(place.path().join(name), "").unwrap();
        }
        let folder = Folder::new(place.path());
        let files = |pattern: &str| folder.files(pattern).unwrap();
        assert_eq!(files("?.scen"), ["a.scen", "b.scen"]);
        assert_eq!(files("./a.scen"), ["a.scen"]);
        assert_eq!(files("c[1].scen"), ["c[1].scen"]);
        assert!(files("none.scen").is_empty());
        let absolute = place.path().join("a.scen").to_string_lossy().into_owned();
        assert_eq!(
            Folder::of(Path::new("specs/x.toml"))
                .files(&absolute)
                .unwrap(),
            [absolute]
        );
        assert!(folder.files("***").is_err());
    }
}
