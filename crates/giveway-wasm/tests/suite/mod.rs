//! The tests, the same in Node and in a browser.

mod bad_input;
mod cases;
mod changes;
mod export;
mod large;
mod limits;
mod noise;
mod plans;
mod progress;
mod questions;
mod random;
mod texts;

use js_sys::{JSON, Reflect};
use serde_json::{Value, json};
use wasm_bindgen::{JsCast as _, JsValue};

/// Data as JavaScript's objects.
pub(crate) fn object(value: &Value) -> JsValue {
    JSON::parse(&value.to_string()).unwrap()
}

/// JavaScript's objects as data.
pub(crate) fn data(value: &JsValue) -> Value {
    let text = JSON::stringify(value).unwrap();
    serde_json::from_str(&String::from(text)).unwrap()
}

/// What an expression of JavaScript gives.
pub(crate) fn js(code: &str) -> JsValue {
    js_sys::Function::new_no_args(&format!("return ({code});"))
        .call0(&JsValue::NULL)
        .unwrap()
}

/// What `solve` answers without options.
#[track_caller]
pub(crate) fn solve(request: &Value) -> Value {
    data(&giveway_wasm::solve(&object(request), &JsValue::UNDEFINED).unwrap())
}

/// A graded instance that takes long.
pub(crate) fn hard() -> Value {
    scene(include_str!(
        "../../../../tests/data/mmapf/A17_mm_20x20_o15_a30.json"
    ))
}

/// The warehouse of the literature.
pub(crate) fn warehouse() -> Value {
    scene(include_str!("../../../../tests/data/seed/warehouse.json"))
}

fn scene(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Fails unless the plan of an answer passes the judge.
#[track_caller]
pub(crate) fn expect_judged(scene: &Value, answer: &Value) {
    let request = object(&json!({ "scene": scene, "plan": answer["plan"] }));
    let verdict = data(&giveway_wasm::check(&request).unwrap());
    assert_eq!(verdict["violations"], json!([]));
    assert_eq!(verdict["valid"], true);
    assert_eq!(verdict["costs"], answer["costs"]);
}

/// What is told of an error that was thrown, which must be ours.
#[track_caller]
pub(crate) fn told(thrown: &JsValue) -> (String, String, String) {
    let error = thrown.dyn_ref::<js_sys::Error>().expect("an Error");
    assert_eq!(String::from(error.name()), "GivewayError");
    let get = |key: &str| {
        let value = Reflect::get(thrown, &key.into()).unwrap();
        value.as_string().expect(key)
    };
    let faults = Reflect::get(thrown, &"faults".into()).unwrap();
    assert_eq!(data(&faults)[0]["found"], get("found"));
    assert!(get("message").contains(&get("found")));
    (get("code"), get("place"), get("message"))
}
