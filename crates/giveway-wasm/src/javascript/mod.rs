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
mod judge;
mod objects;
mod response;
mod service;
mod texts;
mod zip;

use giveway_model::{Fault, format};
use js_sys::JSON;
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

pub use convert::convert;
use error::{Code, error};
pub use export::export_certificates;
pub use files::read_files;
pub use judge::{check, compare_plans, verify};
pub use service::{
    audit, certify, change, delays, explain, freedom, order, plan, price, sizing, solve, together,
};
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

/// The JSON Schema of all objects.
///
/// # Errors
/// Only where there is no more memory.
#[wasm_bindgen(skip_typescript)]
pub fn schema() -> Result<JsValue, JsValue> {
    JSON::parse(format::schema())
}
