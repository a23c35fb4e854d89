//! The files that a planner gets: a map and a scenario, written from the instance that
//! judges its plan.

use std::fs;
use std::path::{Path, PathBuf};

use giveway_formats::{Loss, Part, movingai};
use giveway_model::Instance;
use tempfile::TempDir;

/// The files of one run, in a folder of their own that is gone with them.
pub(super) struct Given {
    folder: TempDir,
}

const MAP: &str = "instance.map";
const SCEN: &str = "instance.scen";
const OUT: &str = "plan.txt";

impl Given {
    /// Writes the files of an instance.
    ///
    /// # Errors
    /// Why they cannot be written, as a sentence.
    pub(super) fn write(instance: &Instance) -> Result<Self, String> {
        let folder = tempfile::Builder::new().prefix("giveway-").tempdir();
        let folder = folder
            .map_err(|error| format!("There is no folder for files of a moment: {error}."))?;
        let scenario = movingai::write_scenario(MAP, instance);
        let scenario = scenario.map_err(|fault| fault.to_string())?;
        for (name, text) in [
            (MAP, movingai::write_map(instance.grid())),
            (SCEN, scenario),
        ] {
            let path = folder.path().join(name);
            fs::write(&path, text)
                .map_err(|error| format!("{} cannot be written: {error}.", path.display()))?;
        }
        Ok(Self { folder })
    }

    /// The folder of the files.
    pub(super) fn folder(&self) -> &Path {
        self.folder.path()
    }

    pub(super) fn map(&self) -> PathBuf {
        self.folder().join(MAP)
    }

    pub(super) fn scen(&self) -> PathBuf {
        self.folder().join(SCEN)
    }

    /// The file that the planner writes.
    pub(super) fn out(&self) -> PathBuf {
        self.folder().join(OUT)
    }
}

/// What of an instance a planner would not know, as a sentence; `None` where it knows all
/// that its plan is judged by.
pub(super) fn unknown(instance: &Instance) -> Option<String> {
    let lost = movingai::losses(instance).into_iter().filter(matters);
    let lost: Vec<String> = lost.map(|loss| loss.to_string()).collect();
    (!lost.is_empty()).then(|| {
        format!(
            "A map and a scenario of MovingAI cannot hold {}: the planner would not know it.",
            lost.join(", ")
        )
    })
}

/// Whether what is lost changes which plans are legal, or what is asked for. Plans name
/// their robots by numbers, the objective only tells what is measured, and without
/// batteries a charger is a free cell.
fn matters(loss: &Loss) -> bool {
    match loss.part {
        Part::Names | Part::Objective | Part::Chargers | Part::Zones => false,
        Part::SlowZone
        | Part::Waypoints
        | Part::Batteries
        | Part::NoGoal
        | Part::Vanish
        | Part::Moving
        | Part::Constraints
        | Part::Headings
        | Part::Charges
        | Part::Joining
        | Part::Removal
        | Part::Knows
        | Part::Slept => true,
    }
}
