//! What a browser may lack: asked for before it is called, since a call of what is
//! not there is an exception that nothing here can catch.

use js_sys::Reflect;
use wasm_bindgen::JsValue;
use web_sys::Clipboard;

/// Whether an object has a property of this name that is not `undefined`.
pub(crate) fn has(object: &JsValue, name: &str) -> bool {
    let value = Reflect::get(object, &name.into());
    value.is_ok_and(|value| !value.is_undefined())
}

/// The clipboard with this function. There is none over plain http, and some
/// browsers have one that cannot be read.
pub(crate) fn clipboard(function: &str) -> Option<Clipboard> {
    let navigator = gloo::utils::window().navigator();
    let clipboard = has(&navigator, "clipboard").then(|| navigator.clipboard())?;
    has(&clipboard, function).then_some(clipboard)
}
