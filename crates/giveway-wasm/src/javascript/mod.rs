//! The package's functions for JavaScript: plain objects in, plain objects out.
//!
//! Objects have the shapes of the project's own JSON; `package/types.d.ts` tells
//! them. Whatever is handed in, a function returns or throws an `Error` with a
//! `code`, the place of each fault, and a sentence.

mod callbacks;
mod convert;
mod error;
mod export;
mod files;
mod objects;
mod texts;
mod zip;

use std::collections::BTreeMap;

use giveway_model::{Fault, Instance, Plan, Scene, compare, format};
use giveway_proof::Bundle;
use giveway_solve::audit::AuditRequest;
use giveway_solve::change::ChangeRequest;
use giveway_solve::delays::DelaysRequest;
use giveway_solve::freedom::FreedomRequest;
use giveway_solve::order::OrderRequest;
use giveway_solve::plan::PlanRequest;
use giveway_solve::price::PriceRequest;
use giveway_solve::sizing::SizingRequest;
use giveway_solve::together::TogetherRequest;
use giveway_solve::{
    CertifyRequest, CheckRequest, Host, Limits, Progress, Refusal, Request, Response, SolveRequest,
    explain::ExplainRequest, serve,
};
use js_sys::JSON;
use serde::{Deserialize, de::DeserializeOwned};
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use crate::{
    budget::{MEMORY_BYTES, within_budget},
    host::WebHost,
};
use callbacks::Callbacks;
pub use convert::convert;
use error::{Code, error};
pub use export::export_certificates;
pub use files::read_files;
pub use texts::{read_moving_ai, read_plan, read_scene};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("../../package/types.d.ts");

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
#[wasm_bindgen(skip_typescript)]
pub fn solve(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Solve as fn(SolveRequest) -> Request,
    )
}

/// Answers a question about a plan, or about there being none.
///
/// # Errors
/// As [`solve`]; also where the question does not fit the plan.
#[wasm_bindgen(skip_typescript)]
pub fn explain(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Explain as fn(ExplainRequest) -> Request,
    )
}

/// Goes on with a plan around which the world changes.
///
/// # Errors
/// As [`solve`]; also where the changes do not fit.
#[wasm_bindgen(skip_typescript)]
pub fn change(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Change as fn(ChangeRequest) -> Request,
    )
}

/// Judges a plan, and tells how far it is from the best.
///
/// # Errors
/// As [`solve`].
#[wasm_bindgen(skip_typescript)]
pub fn audit(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Audit as fn(AuditRequest) -> Request,
    )
}

/// Tells what must be so in every best plan, and what is free to choose.
///
/// # Errors
/// As [`solve`]; also where the plan breaks a rule.
#[wasm_bindgen(skip_typescript)]
pub fn freedom(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Freedom as fn(FreedomRequest) -> Request,
    )
}

/// Tells what each rule of the scene's own costs.
///
/// # Errors
/// As [`solve`].
#[wasm_bindgen(skip_typescript)]
pub fn price(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Price as fn(PriceRequest) -> Request,
    )
}

/// Tells who costs whom in a plan: each delay, split by whom the robot lets pass.
///
/// # Errors
/// As [`solve`].
#[wasm_bindgen(skip_typescript)]
pub fn delays(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Delays as fn(DelaysRequest) -> Request,
    )
}

/// Tells who must begin to leave each cell before who begins to come, and who is pushed if
/// robots are late; writes that as way-points, as DOT and as VDA 5050 orders.
///
/// # Errors
/// As [`solve`]; also where the plan breaks a rule.
#[wasm_bindgen(skip_typescript)]
pub fn order(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Order as fn(OrderRequest) -> Request,
    )
}

/// Tells how many robots a floor bears: the best plan of the first robots, for several numbers.
///
/// # Errors
/// As [`solve`].
#[wasm_bindgen(skip_typescript)]
pub fn sizing(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Sizing as fn(SizingRequest) -> Request,
    )
}

/// Finds a plan with a planner of the textbook.
///
/// # Errors
/// As [`solve`]; also where the order names an agent that is none.
#[wasm_bindgen(skip_typescript)]
pub fn plan(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Plan as fn(PlanRequest) -> Request,
    )
}

/// Tells why some agents cannot all keep their limits.
///
/// # Errors
/// As [`solve`]; also where an agent is none.
#[wasm_bindgen(skip_typescript)]
pub fn together(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Together as fn(TogetherRequest) -> Request,
    )
}

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

/// Proves again what was answered, and checks the proofs.
///
/// # Errors
/// As [`solve`].
#[wasm_bindgen(skip_typescript)]
pub fn certify(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    serve_with(
        request,
        options,
        Request::Certify as fn(CertifyRequest) -> Request,
    )
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

/// The JSON Schema of all objects.
///
/// # Errors
/// Only where there is no more memory.
#[wasm_bindgen(skip_typescript)]
pub fn schema() -> Result<JsValue, JsValue> {
    JSON::parse(format::schema())
}

/// Reads a request and has it served.
fn serve_with<T: DeserializeOwned>(
    request: &JsValue,
    options: &JsValue,
    kind: fn(T) -> Request,
) -> Result<JsValue, JsValue> {
    with_callbacks(options, |host| respond(kind(objects::read(request)?), host))
}

/// Works with a host that has the callbacks of the options; what one of them
/// throws is thrown on.
fn with_callbacks(
    options: &JsValue,
    work: impl FnOnce(&dyn Host) -> Result<JsValue, JsValue>,
) -> Result<JsValue, JsValue> {
    let callbacks = Callbacks::new(options)?;
    let listen = |event: &Progress| callbacks.hear(event);
    let should_stop = || callbacks.say_stop();
    let host = WebHost::new(&listen, Some(&should_stop));
    let answer = work(&host);
    match callbacks.thrown() {
        Some(thrown) => Err(thrown),
        None => answer,
    }
}

fn respond(request: Request, host: &dyn Host) -> Result<JsValue, JsValue> {
    answered(serve(&within_budget(request), host))
}

fn answered(response: Response) -> Result<JsValue, JsValue> {
    match response {
        Response::Solved(answer) => objects::write(&answer),
        Response::Front(answer) => objects::write(&answer),
        Response::Checked(answer) => objects::write(&answer),
        Response::Explained(answer) => objects::write(&answer),
        Response::Certified(report) => objects::write(&report),
        // Only `exportCertificates` asks for it, and packs it.
        Response::Exported(_) => Ok(JsValue::UNDEFINED),
        Response::Changed(answer) => objects::write(&answer),
        Response::Audited(answer) => objects::write(&answer),
        Response::Planned(answer) => objects::write(&answer),
        Response::Together(answer) => objects::write(&answer),
        Response::Freedom(answer) => objects::write(&answer),
        Response::Priced(answer) => objects::write(&answer),
        Response::Delays(answer) => objects::write(&answer),
        Response::Order(answer) => objects::write(&answer),
        Response::Sized(answer) => objects::write(&answer),
        Response::Refused(refusal) => Err(refused(refusal)),
    }
}

fn refused(refusal: Refusal) -> JsValue {
    let code = match refusal {
        Refusal::Scene { .. } => Code::BadScene,
        _ => Code::BadInput,
    };
    error(code, &refusal.faults())
}
