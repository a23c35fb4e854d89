//! The functions that ask the solver's service.

use giveway_solve::audit::AuditRequest;
use giveway_solve::change::ChangeRequest;
use giveway_solve::delays::DelaysRequest;
use giveway_solve::explain::ExplainRequest;
use giveway_solve::freedom::FreedomRequest;
use giveway_solve::order::OrderRequest;
use giveway_solve::plan::PlanRequest;
use giveway_solve::price::PriceRequest;
use giveway_solve::sizing::SizingRequest;
use giveway_solve::together::TogetherRequest;
use giveway_solve::{CertifyRequest, Request, SolveRequest};
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::response::serve_with;

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
