//! Files of other people's planners: a scene and the plans for it.

use std::collections::BTreeMap;

use giveway_model::format::foreign::{
    self, Conventions, ForeignPlan, Gathered, Missing, Options, Refused, Source,
};
use giveway_model::{Fault, Scene};
use serde::{Deserialize, Serialize};
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::objects;

/// What a person may say of files.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct ReadOptions {
    agents: Option<usize>,
    conventions: Option<Conventions>,
}

/// A scene and the plans for it.
#[derive(Serialize)]
struct Files {
    scene: Scene,
    plans: Vec<ForeignPlan>,
    notes: Vec<String>,
}

/// Reads files that belong together, by what they hold.
///
/// # Errors
/// An `Error` with the file and the line of each fault, or the file that is missing.
#[wasm_bindgen(js_name = readFiles, skip_typescript)]
pub fn read_files(files: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let files: BTreeMap<String, String> = objects::read(files)?;
    let options = if options.is_undefined() {
        ReadOptions::default()
    } else {
        objects::read(options)?
    };
    let options = Options {
        agents: options.agents,
        conventions: options.conventions,
    };
    let gathered = gather(&files, &options).map_err(|faults| error(Code::BadText, &faults))?;
    objects::write(&Files {
        scene: gathered.instance.to_scene(),
        plans: gathered.plans,
        notes: gathered.notes,
    })
}

/// Matches texts to each other, in the order of their names.
pub(super) fn gather(
    files: &BTreeMap<String, String>,
    options: &Options,
) -> Result<Gathered, Vec<Fault>> {
    let sources: Vec<Source<'_>> = files
        .iter()
        .map(|(name, text)| Source { name, text })
        .collect();
    foreign::gather(&sources, options).map_err(faults)
}

/// Why files make no scene, as faults whose place is a file.
fn faults(refused: Refused) -> Vec<Fault> {
    match refused {
        Refused::File { file, faults } => {
            let faults = faults.into_iter();
            faults.map(|fault| in_file(&file, fault)).collect()
        }
        Refused::Missing { file, what, .. } => {
            let found = match &what {
                Missing::Map(Some(map)) => format!("a file for the map {map}"),
                Missing::Map(None) => "a file for a map".to_owned(),
                Missing::Scenario => "a plan without the starts of its robots".to_owned(),
                Missing::Problem => "a solution without its problem".to_owned(),
            };
            let expected = match what {
                Missing::Map(_) => "that map among the files",
                Missing::Scenario => "its scenario (.scen) among the files",
                Missing::Problem => "the file of its problem, with map and robots, among the files",
            };
            vec![Fault::at(file, found, expected)]
        }
        Refused::Apart(sentence) => {
            vec![Fault::at(
                "",
                sentence.trim_end_matches('.'),
                "files that belong together",
            )]
        }
    }
}

/// A fault with the name of its file before its place.
pub(super) fn in_file(name: &str, fault: Fault) -> Fault {
    let place = match fault.place.as_str() {
        "" => name.to_owned(),
        place => format!("{name}: {place}"),
    };
    Fault { place, ..fault }
}
