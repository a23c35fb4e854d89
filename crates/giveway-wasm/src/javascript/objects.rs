//! Between JavaScript's objects and ours, by way of JSON.
//!
//! JavaScript's own writer copes with whatever an object may be (a getter that
//! throws, a proxy, a circle), and our reader tells the place of each fault.

use giveway_model::Fault;
use giveway_model::format::{from_object, native};
use js_sys::{BigInt, JSON, JsString, Map, Set};
use serde::{Deserialize, Deserializer, Serialize, de::DeserializeOwned};
use wasm_bindgen::{JsCast as _, JsValue, closure::Closure};

use super::error::{Code, error};

/// The longest text that is read, in UTF-16 code units. The plans of a thousand
/// agents are shorter; one that is longer would fill a tab's memory.
const MAX_TEXT: u32 = 32 << 20;

/// Reads an object.
///
/// # Errors
/// An `Error` with the place of the fault.
pub(super) fn read<T: DeserializeOwned>(object: &JsValue) -> Result<T, JsValue> {
    struct Object<T>(T);

    impl<'de, T: Deserialize<'de>> Deserialize<'de> for Object<T> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            from_object(deserializer).map(Self)
        }
    }

    let text = to_json(object)?;
    native::read_object::<Object<T>>(&text)
        .map(|object| object.0)
        .map_err(|fault| {
            // It is a place in a text that nobody sees.
            let (line, column) = (None, None);
            let fault = Fault {
                line,
                column,
                ..fault
            };
            error(Code::BadInput, &[fault])
        })
}

fn to_json(object: &JsValue) -> Result<String, JsValue> {
    let plain =
        Closure::<dyn Fn(JsValue, JsValue) -> JsValue>::new(|_: JsValue, value| plain(value));
    let written = JSON::stringify_with_replacer(object, plain.as_ref());
    match written {
        Ok(text) if text.is_string() => limited(&text, ""),
        Ok(_) => Err(bad("", kind(object), "an object")),
        Err(thrown) => {
            let reason = thrown
                .dyn_ref::<js_sys::Error>()
                .and_then(|error| JsValue::from(error.message()).as_string())
                .map_or(String::new(), |message| format!(": {message}"));
            let found = format!("an object that cannot be read{reason}");
            Err(bad("", found, "a plain object"))
        }
    }
}

/// A value as JSON can hold it, so that nothing is silently taken for `null` or
/// for an empty object.
fn plain(value: JsValue) -> JsValue {
    if value.as_f64().is_some_and(f64::is_nan) {
        return "NaN".into();
    }
    if let Some(number) = value.dyn_ref::<BigInt>() {
        let digits = number.to_string(10).ok().and_then(|text| text.as_string());
        return format!("{}n", digits.unwrap_or_default()).into();
    }
    if value.is_instance_of::<Map>() {
        return "[object Map]".into();
    }
    if value.is_instance_of::<Set>() {
        return "[object Set]".into();
    }
    value
}

/// Writes data as a plain object.
///
/// # Errors
/// Only where the browser has no more memory.
pub(super) fn write<T: Serialize>(data: &T) -> Result<JsValue, JsValue> {
    // Maps by text, numbers and lists always have a JSON form.
    JSON::parse(&serde_json::to_string(data).unwrap_or_default())
}

/// A text that was handed in.
///
/// # Errors
/// An `Error` when it is none, or too long.
pub(super) fn text(value: &JsValue, place: &str) -> Result<String, JsValue> {
    match value.dyn_ref::<JsString>() {
        Some(text) => limited(text, place),
        None => Err(bad(place, kind(value), "a text")),
    }
}

fn limited(text: &JsString, place: &str) -> Result<String, JsValue> {
    let length = text.length();
    if length > MAX_TEXT {
        let found = format!("{length} characters");
        return Err(bad(place, found, format!("at most {MAX_TEXT}")));
    }
    Ok(text.into())
}

/// What kind of value was found, as a phrase.
pub(super) fn kind(value: &JsValue) -> String {
    if value.is_null() {
        return "null".to_owned();
    }
    match value.js_typeof().as_string().as_deref() {
        None | Some("undefined") => "nothing".to_owned(),
        Some("object") => "an object".to_owned(),
        Some("string") => "a text".to_owned(),
        Some(other) => format!("a {other}"),
    }
}

/// The error of one fault of what was handed in.
pub(super) fn bad(place: &str, found: String, expected: impl Into<String>) -> JsValue {
    error(Code::BadInput, &[Fault::at(place, found, expected)])
}
