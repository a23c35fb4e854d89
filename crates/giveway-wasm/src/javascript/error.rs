//! What is thrown: an `Error` with a code, the faults, and a sentence.

use giveway_model::Fault;
use js_sys::{Error, Reflect};
use wasm_bindgen::JsValue;

use super::objects;

/// What kind of thing is wrong; its name is the error's `code`.
#[derive(Clone, Copy, Debug)]
pub(super) enum Code {
    /// An object is not of the type that it should be.
    BadInput,
    /// A scene is no instance of the problem.
    BadScene,
    /// A text is not of the format.
    BadText,
    /// The program has a fault.
    Broken,
}

impl Code {
    const fn name(self) -> &'static str {
        match self {
            Self::BadInput => "bad-input",
            Self::BadScene => "bad-scene",
            Self::BadText => "bad-text",
            Self::Broken => "broken",
        }
    }
}

/// The error of at least one fault; the first is also told by itself.
pub(super) fn error(code: Code, faults: &[Fault]) -> JsValue {
    let error = Error::new(&sentence(faults));
    error.set_name("GivewayError");
    // A property of an error just made can always be set.
    let set = |key: &str, value: &JsValue| {
        let _ = Reflect::set(&error, &key.into(), value);
    };
    set("code", &code.name().into());
    if let Some(first) = faults.first() {
        set("place", &first.place.as_str().into());
        set("found", &first.found.as_str().into());
        set("expected", &first.expected.as_str().into());
    }
    set("faults", &objects::write(&faults).unwrap_or_default());
    error.into()
}

fn sentence(faults: &[Fault]) -> String {
    let first = faults.first().map(Fault::to_string).unwrap_or_default();
    match faults.len() {
        0 | 1 => first,
        2 => format!("{first} (and one more fault)"),
        count => format!("{first} (and {} more faults)", count - 1),
    }
}
