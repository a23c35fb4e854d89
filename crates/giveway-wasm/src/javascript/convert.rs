//! Files in another format, as `giveway convert` writes them.

use std::collections::BTreeMap;

use giveway_model::format::foreign::{self, Format};
use giveway_model::format::{movingai, native, stem};
use giveway_model::{Fault, Grid, Instance, Plan, Scene};
use serde::{Deserialize, Serialize};
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::files::{self, in_file};
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
    let by_itself = matches!(request.to, Format::Giveway | Format::MovingAi);
    let contents = if by_itself && request.files.values().all(|text| is_own(text)) {
        contents(request)?
    } else {
        gathered(request)?
    };
    let have_plan = contents
        .iter()
        .any(|(.., content)| matches!(content, Content::Plan(_)));
    let instance = contents.iter().find_map(|(.., content)| match content {
        Content::Instance(instance) => Some(instance),
        Content::Plan(_) => None,
    });
    for (stem, name, content) in &contents {
        let (instance, plan) = match content {
            Content::Instance(instance) if by_itself || !have_plan => (Some(instance), None),
            Content::Instance(_) => continue,
            Content::Plan(plan) if by_itself => (None, Some(plan)),
            Content::Plan(plan) => (instance, Some(plan)),
        };
        let written = foreign::write(request.to, stem, instance, plan)
            .map_err(|fault| vec![in_file(name, fault)])?;
        answer.files.extend(written.files);
        answer.notes.extend(written.losses);
    }
    Ok(answer)
}

/// Whether a text is of this project or of the standard benchmark, or of nobody.
fn is_own(text: &str) -> bool {
    let format = foreign::recognise(text);
    matches!(format, Ok(Format::Giveway | Format::MovingAi) | Err(_))
}

/// A scene and the plans for it, out of files that belong together.
fn gathered(request: &ConvertRequest) -> Result<Vec<(String, String, Content)>, Vec<Fault>> {
    let options = foreign::Options {
        agents: request.agents,
        conventions: None,
    };
    let gathered = files::gather(&request.files, &options)?;
    let name = match gathered.instance.name() {
        "" => "instance".to_owned(),
        name => name.to_owned(),
    };
    let scene = Content::Instance(gathered.instance);
    let mut contents = vec![(name.clone(), name.clone(), scene)];
    for plan in gathered.plans {
        let own = stem(&plan.file);
        let stem = if own == name {
            format!("{own}-plan")
        } else {
            own.to_owned()
        };
        contents.push((stem, plan.file, Content::Plan(plan.plan)));
    }
    Ok(contents)
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
