//! Files in another format, as `giveway convert` writes them.

use giveway_formats::convert::{self, ConvertRequest};
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::objects;

/// Writes instances and plans in another format.
///
/// # Errors
/// An `Error` with the file and the line of each fault.
#[wasm_bindgen(skip_typescript)]
pub fn convert(request: &JsValue) -> Result<JsValue, JsValue> {
    let request: ConvertRequest = objects::read(request)?;
    let answer = convert::convert(&request).map_err(|faults| error(Code::BadText, &faults))?;
    objects::write(&answer)
}
