//! The functions that judge what is there: plans, and the files of certificates.

use std::collections::BTreeMap;

use giveway_model::{Instance, Plan, Scene, compare, format};
use giveway_proof::Bundle;
use giveway_solve::{CheckRequest, Limits, Refusal, Request};
use serde::Deserialize;
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::objects;
use super::response::{refused, respond, with_callbacks};
use crate::{budget::MEMORY_BYTES, host::WebHost};

/// Two plans of one scene.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CompareRequest {
    scene: Scene,
    plans: [Plan; 2],
}

/// Compares two plans of one scene.
///
/// # Errors
/// An `Error` where the request or its scene is wrong.
#[wasm_bindgen(js_name = compare, skip_typescript)]
pub fn compare_plans(request: &JsValue) -> Result<JsValue, JsValue> {
    let CompareRequest { scene, plans } = objects::read(request)?;
    let instance = Instance::new(scene).map_err(|faults| refused(Refusal::Scene { faults }))?;
    let [one, other] = &plans;
    objects::write(&compare::compare(&instance, one, other))
}

/// Judges a plan.
///
/// # Errors
/// An `Error` where the request or its scene is wrong.
#[wasm_bindgen(skip_typescript)]
pub fn check(request: &JsValue) -> Result<JsValue, JsValue> {
    let request: CheckRequest = objects::read(request)?;
    respond(Request::Check(request), &WebHost::new(&|_| {}, None))
}

/// What is checked again: the files of a certificate, and how long that may take.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VerifyRequest {
    files: BTreeMap<String, String>,
    #[serde(default, deserialize_with = "format::from_object")]
    limits: Limits,
}

/// Checks the files of a certificate again, as `giveway verify` does.
///
/// # Errors
/// An `Error` where the request or the options are wrong; what a callback throws.
/// A certificate that does not hold is no error: its report says so.
#[wasm_bindgen(skip_typescript)]
pub fn verify(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let VerifyRequest { files, mut limits } = objects::read(request)?;
    limits.memory_bytes.get_or_insert(MEMORY_BYTES);
    let files: Bundle = files
        .into_iter()
        .map(|(name, text)| (name, text.into_bytes()))
        .collect();
    with_callbacks(options, |host| {
        objects::write(&giveway_solve::verify(&files, limits, host))
    })
}
