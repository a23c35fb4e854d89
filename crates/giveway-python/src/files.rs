//! Scenes and plans from the texts of files.

use std::collections::BTreeMap;

use giveway_formats::{Conventions, ForeignPlan, Options, Source, movingai};
use giveway_model::format::decode;
use giveway_model::{AtGoal, Fault, Instance, Scene};
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
    #[serde(default)]
    at_goal: Option<AtGoal>,
    #[serde(default)]
    battery_floor: Option<u32>,
}

/// A scene and the plans for it.
#[derive(Serialize)]
pub(crate) struct Files {
    scene: Scene,
    plans: Vec<ForeignPlan>,
    notes: Vec<String>,
}

/// Reads files by what they hold.
pub(crate) fn combined(request: &FilesRequest) -> Result<Files, Failure> {
    let options = Options {
        agents: request.agents,
        conventions: request.conventions,
        at_goal: request.at_goal,
        battery_floor: request.battery_floor,
    };
    let files = request.files.iter();
    let sources: Vec<Source<'_>> = files.map(|(name, text)| Source { name, text }).collect();
    let combined = giveway_formats::combine(&sources, &options)
        .map_err(|refused| Failure::new(Code::BadText, refused.faults()))?;
    Ok(Files {
        scene: combined.instance.to_scene(),
        plans: combined.plans,
        notes: combined.notes,
    })
}

/// The bytes of a file, each the letter of its number.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DecodeRequest {
    bytes: String,
    file: String,
}

/// A text, and what a person should know of how its bytes were read.
#[derive(Serialize)]
pub(crate) struct Decoded {
    text: String,
    note: Option<String>,
}

/// The text of bytes in any encoding that is known.
pub(crate) fn decoded(request: &DecodeRequest) -> Result<Decoded, Failure> {
    let bytes = request
        .bytes
        .chars()
        .map(|c| u8::try_from(c).unwrap_or(b'?'));
    let bytes: Vec<u8> = bytes.collect();
    let (text, encoding) =
        decode(&bytes).map_err(|fault| Failure::new(Code::BadText, vec![fault]))?;
    Ok(Decoded {
        text: text.into_owned(),
        note: encoding.note(&request.file),
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
