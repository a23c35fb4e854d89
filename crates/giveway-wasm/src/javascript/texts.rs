//! Scenes and plans from texts.

use giveway_formats::movingai;
use giveway_model::format::native;
use giveway_model::{Fault, Instance};
use serde::Deserialize;
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::objects;

/// Reads a scene in the project's own JSON, and checks it.
///
/// # Errors
/// An `Error` with the line and column of each fault.
#[wasm_bindgen(js_name = readScene, skip_typescript)]
pub fn read_scene(text: &JsValue) -> Result<JsValue, JsValue> {
    let text = objects::text(text, "text")?;
    match native::read_instance(&text) {
        Ok(instance) => objects::write(&instance.to_scene()),
        Err(faults) => Err(error(Code::BadText, &faults)),
    }
}

/// Reads a plan in the project's own JSON, without judging it.
///
/// # Errors
/// An `Error` with the line and column of the fault.
#[wasm_bindgen(js_name = readPlan, skip_typescript)]
pub fn read_plan(text: &JsValue) -> Result<JsValue, JsValue> {
    let text = objects::text(text, "text")?;
    let plan = native::read_plan(&text).map_err(|fault| error(Code::BadText, &[fault]))?;
    objects::write(&plan)
}

/// What a person may say of a scene that comes in two files.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Named {
    name: String,
    agents: Option<usize>,
}

/// The scene of a `MovingAI` `.map` and the first agents of a `.scen`.
///
/// # Errors
/// An `Error` with the line of the fault, whose place is `map` or `scenario`.
#[wasm_bindgen(js_name = readMovingAi, skip_typescript)]
pub fn read_moving_ai(
    map: &JsValue,
    scenario: &JsValue,
    options: &JsValue,
) -> Result<JsValue, JsValue> {
    let place = |place: &'static str| {
        move |fault: Fault| {
            let place = place.to_owned();
            error(Code::BadText, &[Fault { place, ..fault }])
        }
    };
    let map = objects::text(map, "map")?;
    let scenario = objects::text(scenario, "scenario")?;
    let Named { name, agents } = if options.is_undefined() {
        Named::default()
    } else {
        objects::read(options)?
    };
    let grid = movingai::read_map(&map).map_err(place("map"))?;
    let scenario = movingai::read_scenario(&scenario).map_err(place("scenario"))?;
    let scene = movingai::to_scene(&name, &grid, &scenario, agents).map_err(place("scenario"))?;
    match Instance::new(scene) {
        Ok(instance) => objects::write(&instance.to_scene()),
        Err(faults) => Err(error(Code::BadScene, &faults)),
    }
}
