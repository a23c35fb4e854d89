//! Files of other people's planners: a scene and the plans for it.

use std::collections::BTreeMap;

use giveway_model::Scene;
use giveway_model::format::foreign::{self, Conventions, ForeignPlan, Options, Source};
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
    let sources: Vec<Source<'_>> = files
        .iter()
        .map(|(name, text)| Source { name, text })
        .collect();
    let gathered = foreign::gather(&sources, &options)
        .map_err(|refused| error(Code::BadText, &refused.faults()))?;
    objects::write(&Files {
        scene: gathered.instance.to_scene(),
        plans: gathered.plans,
        notes: gathered.notes,
    })
}
