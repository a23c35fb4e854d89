//! The package's functions for JavaScript: plain objects in, plain objects out.
//!
//! Objects have the shapes of the project's own JSON, and `types.d.ts` tells
//! them. Whatever is handed in, a function returns or throws an `Error` with a
//! `code`, the place of each fault, and a sentence.

mod callbacks;
mod error;
mod objects;

use giveway_model::format::{movingai, native};
use giveway_model::{Fault, Instance};
use giveway_solve::{
    CheckRequest, Host, Progress, Refusal, Request, Response, SolveRequest, serve,
};
use serde::Deserialize;
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use crate::{budget::within_budget, host::WebHost};
use callbacks::Callbacks;
use error::{Code, error};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

/// Lets a fault of the program be an `Error` with a sentence, too.
#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| {
        let found = format!("a fault of this program, {panic}");
        let fault = Fault::at("", found, "none; what follows may be wrong");
        wasm_bindgen::throw_val(error(Code::Broken, &[fault]));
    }));
}

/// Finds and proves the best plan, or the Pareto front.
///
/// # Errors
/// An `Error` where the request, its scene or the options are wrong; what a
/// callback throws.
#[wasm_bindgen]
pub fn solve(
    #[wasm_bindgen(unchecked_param_type = "SolveRequest")] request: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "SolveOptions")] options: &JsValue,
) -> Result<JsValue, JsValue> {
    let callbacks = Callbacks::new(options)?;
    let request: SolveRequest = objects::read(request)?;
    let listen = |event: &Progress| callbacks.hear(event);
    let should_stop = || callbacks.say_stop();
    let host = WebHost::new(&listen, Some(&should_stop));
    let response = respond(Request::Solve(request), &host);
    match callbacks.thrown() {
        Some(thrown) => Err(thrown),
        None => response,
    }
}

/// Judges a plan.
///
/// # Errors
/// An `Error` where the request or its scene is wrong.
#[wasm_bindgen]
pub fn check(
    #[wasm_bindgen(unchecked_param_type = "CheckRequest")] request: &JsValue,
) -> Result<JsValue, JsValue> {
    let request: CheckRequest = objects::read(request)?;
    respond(Request::Check(request), &WebHost::new(&|_| {}, None))
}

fn respond(request: Request, host: &dyn Host) -> Result<JsValue, JsValue> {
    match serve(&within_budget(request), host) {
        Response::Solved(answer) => objects::write(&answer),
        Response::Front(answer) => objects::write(&answer),
        Response::Checked(answer) => objects::write(&answer),
        Response::Explained(answer) => objects::write(&answer),
        Response::Certified(report) => objects::write(&report),
        Response::Refused(Refusal::Scene { faults }) => {
            let in_request = |mut fault: Fault| {
                fault.place = format!("scene.{}", fault.place);
                fault
            };
            let faults: Vec<Fault> = faults.into_iter().map(in_request).collect();
            Err(error(Code::BadScene, &faults))
        }
        Response::Refused(Refusal::Request { fault }) => Err(error(Code::BadInput, &[fault])),
        Response::Refused(refusal) => {
            let found = refusal.sentences().join(" ");
            let fault = Fault::at("question", found, "what can be asked of the plan");
            Err(error(Code::BadInput, &[fault]))
        }
    }
}

/// Reads a scene in the project's own JSON, and checks it.
///
/// # Errors
/// An `Error` with the line and column of each fault.
#[wasm_bindgen(js_name = readScene)]
pub fn read_scene(
    #[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue,
) -> Result<JsValue, JsValue> {
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
#[wasm_bindgen(js_name = readPlan)]
pub fn read_plan(
    #[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue,
) -> Result<JsValue, JsValue> {
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
#[wasm_bindgen(js_name = readMovingAi)]
pub fn read_moving_ai(
    #[wasm_bindgen(unchecked_param_type = "string")] map: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "string")] scenario: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "MovingAiOptions")] options: &JsValue,
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
