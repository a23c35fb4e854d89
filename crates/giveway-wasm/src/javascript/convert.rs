//! Files in another format, as `giveway convert` writes them.

use std::collections::BTreeMap;

use giveway_model::format::{movingai, native};
use giveway_model::{Fault, Grid, Instance, Plan, Scene};
use serde::{Deserialize, Serialize};
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::objects;

/// Texts by file names, and what they should become.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ConvertRequest {
    files: BTreeMap<String, String>,
    to: Format,
    #[serde(default)]
    agents: Option<usize>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Format {
    Giveway,
    Movingai,
}

/// Texts by file names, and what was lost.
#[derive(Default, Serialize)]
struct ConvertAnswer {
    files: BTreeMap<String, String>,
    notes: Vec<String>,
}

/// What a file holds.
enum Content {
    Instance(Instance),
    Plan(Plan),
}

/// Writes instances and plans in another format.
///
/// # Errors
/// An `Error` with the file and the line of each fault.
#[wasm_bindgen(skip_typescript)]
pub fn convert(request: &JsValue) -> Result<JsValue, JsValue> {
    let request: ConvertRequest = objects::read(request)?;
    let answer = converted(&request).map_err(|faults| error(Code::BadText, &faults))?;
    objects::write(&answer)
}

fn converted(request: &ConvertRequest) -> Result<ConvertAnswer, Vec<Fault>> {
    let mut answer = ConvertAnswer::default();
    for (stem, name, content) in contents(request)? {
        match (request.to, content) {
            (Format::Giveway, Content::Instance(instance)) => {
                let text = native::write_scene(&instance.to_scene());
                answer.files.insert(format!("{stem}.json"), text);
            }
            (Format::Giveway, Content::Plan(plan)) => {
                let text = native::write_plan(&plan);
                answer.files.insert(format!("{stem}.json"), text);
            }
            (Format::Movingai, Content::Instance(instance)) => {
                let map = format!("{stem}.map");
                let scenario = movingai::write_scenario(&map, &instance)
                    .map_err(|fault| vec![in_file(&name, fault)])?;
                answer.files.insert(format!("{stem}.scen"), scenario);
                answer
                    .files
                    .insert(map, movingai::write_map(instance.grid()));
                let losses = movingai::losses(&instance);
                answer.notes.extend(losses.iter().map(ToString::to_string));
            }
            (Format::Movingai, Content::Plan(_)) => {
                let fault = Fault::at(
                    "",
                    "a plan",
                    "an instance, since MovingAI files hold no plans",
                );
                return Err(vec![in_file(&name, fault)]);
            }
        }
    }
    Ok(answer)
}

/// What the files hold, each with the name of what is written and of its file.
fn contents(request: &ConvertRequest) -> Result<Vec<(String, String, Content)>, Vec<Fault>> {
    let mut maps: BTreeMap<&str, Grid> = BTreeMap::new();
    for (name, text) in &request.files {
        if let Some(stem) = name.strip_suffix(".map") {
            let grid = movingai::read_map(text).map_err(|fault| vec![in_file(name, fault)])?;
            maps.insert(stem, grid);
        }
    }
    let mut contents = Vec::new();
    let mut is_taken = false;
    for (name, text) in &request.files {
        let faults = |faults: Vec<Fault>| -> Vec<Fault> {
            faults
                .into_iter()
                .map(|fault| in_file(name, fault))
                .collect()
        };
        if let Some(stem) = name.strip_suffix(".scen") {
            let fault = |fault| vec![in_file(name, fault)];
            let scenario = movingai::read_scenario(text).map_err(fault)?;
            let named = scenario.map_name().and_then(|map| map.strip_suffix(".map"));
            let grid = named
                .and_then(|named| maps.get(named))
                .or_else(|| maps.get(stem))
                .or_else(|| (maps.len() == 1).then(|| maps.values().next()).flatten())
                .ok_or_else(|| fault(Fault::at("", "no map of it", "its .map among the files")))?;
            let scene = movingai::to_scene(stem, grid, &scenario, request.agents).map_err(fault)?;
            let instance = Instance::new(scene).map_err(faults)?;
            is_taken = true;
            contents.push((stem.to_owned(), name.clone(), Content::Instance(instance)));
        } else if name.strip_suffix(".map").is_none() {
            let stem = name.strip_suffix(".json").unwrap_or(name);
            let content = native_content(text, request.agents).map_err(faults)?;
            contents.push((stem.to_owned(), name.clone(), content));
        }
    }
    if !is_taken {
        for (stem, grid) in maps {
            let scene = Scene {
                name: stem.to_owned(),
                map: grid.rows(),
                ..Scene::default()
            };
            let name = format!("{stem}.map");
            let instance = Instance::new(scene).map_err(|all| {
                all.into_iter()
                    .map(|fault| in_file(&name, fault))
                    .collect::<Vec<_>>()
            })?;
            contents.push((stem.to_owned(), name, Content::Instance(instance)));
        }
    }
    Ok(contents)
}

/// A plan or an instance; where it is neither, the faults of what it looks like.
fn native_content(text: &str, agents: Option<usize>) -> Result<Content, Vec<Fault>> {
    let faults = match native::read_instance(text) {
        Ok(instance) => {
            let mut scene = instance.to_scene();
            scene.agents.truncate(agents.unwrap_or(usize::MAX));
            return Instance::new(scene).map(Content::Instance);
        }
        Err(faults) => faults,
    };
    match native::read_plan(text) {
        Ok(plan) => Ok(Content::Plan(plan)),
        Err(fault) if text.contains("\"paths\"") => Err(vec![fault]),
        Err(_) => Err(faults),
    }
}

/// A fault with the name of its file before its place.
fn in_file(name: &str, fault: Fault) -> Fault {
    let place = match fault.place.as_str() {
        "" => name.to_owned(),
        place => format!("{name}: {place}"),
    };
    Fault { place, ..fault }
}
