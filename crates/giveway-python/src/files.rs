//! Scenes and plans from the texts of files.

use std::collections::BTreeMap;

use giveway_model::format::foreign::{self, Conventions, ForeignPlan, Options, Source};
use giveway_model::format::movingai;
use giveway_model::{Fault, Instance, Scene};
use serde::{Deserialize, Serialize};

use crate::call::{Code, Failure};

/// Files that belong together, and what a person may say of them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FilesRequest {
    files: BTreeMap<String, String>,
    #[serde(default)]
    agents: Option<usize>,
    #[serde(default)]
    conventions: Option<Conventions>,
}

/// A scene and the plans for it.
#[derive(Serialize)]
pub(crate) struct Files {
    scene: Scene,
    plans: Vec<ForeignPlan>,
    notes: Vec<String>,
}

/// Reads files by what they hold.
pub(crate) fn gathered(request: &FilesRequest) -> Result<Files, Failure> {
    let options = Options {
        agents: request.agents,
        conventions: request.conventions,
    };
    let files = request.files.iter();
    let sources: Vec<Source<'_>> = files.map(|(name, text)| Source { name, text }).collect();
    let gathered = foreign::gather(&sources, &options)
        .map_err(|refused| Failure::new(Code::BadText, refused.faults()))?;
    Ok(Files {
        scene: gathered.instance.to_scene(),
        plans: gathered.plans,
        notes: gathered.notes,
    })
}

/// A scene of the standard benchmark, in two texts.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MovingAiRequest {
    map: String,
    scenario: String,
    #[serde(default)]
    name: String,
    #[serde(default)]
    agents: Option<usize>,
}

/// The scene of a map and the first agents of a scenario.
pub(crate) fn moving_ai(request: &MovingAiRequest) -> Result<Scene, Failure> {
    let of = |part: &'static str| {
        move |fault: Fault| Failure::new(Code::BadText, vec![fault.in_file(part)])
    };
    let grid = movingai::read_map(&request.map).map_err(of("map"))?;
    let scenario = movingai::read_scenario(&request.scenario).map_err(of("scenario"))?;
    let scene = movingai::to_scene(&request.name, &grid, &scenario, request.agents)
        .map_err(of("scenario"))?;
    match Instance::new(scene) {
        Ok(instance) => Ok(instance.to_scene()),
        Err(faults) => Err(Failure::new(Code::BadScene, faults)),
    }
}
