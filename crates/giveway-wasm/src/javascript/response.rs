//! Requests served, and their responses as objects or as errors that are thrown.

use std::cell::RefCell;

use giveway_solve::{Host, Progress, Proofs, Refusal, Request, Response, serve};
use serde::de::DeserializeOwned;
use wasm_bindgen::JsValue;

use super::callbacks::Callbacks;
use super::error::{Code, error};
use super::objects;
use crate::{budget::within_budget, host::WebHost};

/// Reads a request and has it served.
pub(super) fn serve_with<T: DeserializeOwned>(
    request: &JsValue,
    options: &JsValue,
    kind: fn(T) -> Request,
) -> Result<JsValue, JsValue> {
    with_callbacks(options, |host| respond(kind(objects::read(request)?), host))
}

/// Works with a host that has the callbacks of the options; what one of them
/// throws is thrown on.
pub(super) fn with_callbacks(
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

thread_local! {
    /// What this program proved so far, for questions about its plans.
    static PROOFS: RefCell<Proofs> = const { RefCell::new(Proofs::new()) };
}

pub(super) fn respond(request: Request, host: &dyn Host) -> Result<JsValue, JsValue> {
    let request = PROOFS.with_borrow(|proofs| proofs.completed(within_budget(request)));
    let response = serve(&request, host);
    PROOFS.with_borrow_mut(|proofs| proofs.keep(request, &response));
    answered(response)
}

pub(super) fn answered(response: Response) -> Result<JsValue, JsValue> {
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

pub(super) fn refused(refusal: Refusal) -> JsValue {
    let code = match refusal {
        Refusal::Scene { .. } => Code::BadScene,
        _ => Code::BadInput,
    };
    error(code, &refusal.faults())
}
