//! Files of other people's planners: a scene and the plans for it.

use std::collections::BTreeMap;

use giveway_formats::{Conventions, ForeignPlan, Options, Source};
use giveway_model::format::decode;
use giveway_model::{AtGoal, Scene};
use js_sys::{Object, Reflect, Uint8Array};
use serde::{Deserialize, Serialize};
use wasm_bindgen::{JsCast as _, JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::objects;

/// What a person may say of files.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct ReadOptions {
    agents: Option<usize>,
    conventions: Option<Conventions>,
    at_goal: Option<AtGoal>,
    battery_floor: Option<u32>,
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
    let (files, encodings) = decoded(files)?;
    let files: BTreeMap<String, String> = objects::read(&files)?;
    let options = if options.is_undefined() {
        ReadOptions::default()
    } else {
        objects::read(options)?
    };
    let options = Options {
        agents: options.agents,
        conventions: options.conventions,
        at_goal: options.at_goal,
        battery_floor: options.battery_floor,
    };
    let sources: Vec<Source<'_>> = files
        .iter()
        .map(|(name, text)| Source { name, text })
        .collect();
    let mut combined = giveway_formats::combine(&sources, &options)
        .map_err(|refused| error(Code::BadText, &refused.faults()))?;
    combined.notes.extend(encodings);
    objects::write(&Files {
        scene: combined.instance.to_scene(),
        plans: combined.plans,
        notes: combined.notes,
    })
}

/// The files with texts instead of bytes, and what a person should know of how those
/// were read. What is no object is told by the reader of objects.
fn decoded(files: &JsValue) -> Result<(JsValue, Vec<String>), JsValue> {
    let mut notes = Vec::new();
    let names = Reflect::own_keys(files).unwrap_or_default();
    let copy = Object::new();
    let mut has_bytes = false;
    for name in names.iter() {
        // A getter that throws is told by the reader of objects.
        let Ok(mut value) = Reflect::get(files, &name) else {
            return Ok((files.clone(), notes));
        };
        if let Some(bytes) = value.dyn_ref::<Uint8Array>() {
            let file = name.as_string().unwrap_or_default();
            let bytes = bytes.to_vec();
            let (text, encoding) =
                decode(&bytes).map_err(|fault| error(Code::BadText, &[fault.in_file(&file)]))?;
            notes.extend(encoding.note(&file));
            value = JsValue::from_str(&text);
            has_bytes = true;
        }
        Reflect::set(&copy, &name, &value)?;
    }
    let files = if has_bytes {
        copy.into()
    } else {
        files.clone()
    };
    Ok((files, notes))
}
