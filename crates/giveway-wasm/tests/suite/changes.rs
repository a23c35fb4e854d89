//! Changes while a plan runs: Wasm goes on as the command does.

use js_sys::{Function, JSON};
use serde_json::{Value, json};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::cases::{CHANGING, METHODS};
use super::{data, js, object, told};

fn scene(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// An answer as text, without what a clock has told.
fn text(answer: &JsValue) -> String {
    let code = "(a) => JSON.stringify(a, (key, value) => key === 'cpu_seconds' ? 0 : value)";
    let write: Function = js(code).unchecked_into();
    let text = write.call1(&JsValue::NULL, answer).unwrap();
    text.as_string().unwrap()
}

#[wasm_bindgen_test]
fn the_plans_after_a_change_are_the_native_ones_byte_for_byte() {
    for case in CHANGING {
        let request = json!({ "scene": scene(case.scene), "plan": scene(case.plan),
            "changes": scene(case.changes), "methods": METHODS });
        let answer = giveway_wasm::change(&object(&request), &JsValue::UNDEFINED).unwrap();
        let expected = JSON::parse(case.expected).unwrap();
        assert_eq!(text(&answer), text(&expected), "{}", case.name);
        let answer = data(&answer);
        for method in METHODS {
            let plan = &answer["methods"][method]["plan"];
            let judged = json!({ "scene": scene(case.scene), "plan": plan,
                "changes": scene(case.changes) });
            let judged = data(&giveway_wasm::check(&object(&judged)).unwrap());
            assert_eq!(judged["violations"], json!([]), "{} {method}", case.name);
        }
    }
}

#[wasm_bindgen_test]
fn the_example_of_the_literature_has_its_makespans() {
    let case = &CHANGING[1];
    let request = json!({ "scene": scene(case.scene), "plan": scene(case.plan),
        "changes": scene(case.changes), "methods": METHODS });
    let answer = data(&giveway_wasm::change(&object(&request), &JsValue::UNDEFINED).unwrap());
    let makespan = |method: &str| answer["methods"][method]["costs"]["makespan"].clone();
    assert_eq!(METHODS.map(makespan), [5, 4, 4]);
}

#[wasm_bindgen_test]
fn a_change_that_contradicts_the_world_is_told_with_its_place() {
    let case = &CHANGING[0];
    let changes = json!({ "giveway": 1, "changes": [
        { "at": 1, "change": "add-obstacle", "cell": [1, 0] }] });
    let request = json!({ "scene": scene(case.scene), "plan": scene(case.plan),
        "changes": changes });
    let thrown = giveway_wasm::change(&object(&request), &JsValue::UNDEFINED).unwrap_err();
    let (code, place, sentence) = told(&thrown);
    assert_eq!(code, "bad-input");
    assert_eq!(place, "changes.changes[0]");
    assert!(sentence.contains("where A1 is at time 1"), "{sentence}");
}
