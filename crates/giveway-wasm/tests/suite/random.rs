//! Random instances: Wasm gives the native plans, byte for byte.

use js_sys::{JSON, Reflect};
use serde::Deserialize;
use serde_json::{Value, json};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::object;

/// An instance and its native answer; `tests/tests/wasm_answers.rs` writes them.
#[derive(Deserialize)]
struct Kept {
    scene: Value,
    limits: Value,
    status: String,
    ended: String,
    plan: String,
}

#[wasm_bindgen_test]
fn random_instances_have_the_native_plans_byte_for_byte() {
    let kept: Vec<Kept> = serde_json::from_str(include_str!("../data/random.json")).unwrap();
    assert_eq!(kept.len(), 85);
    for Kept {
        scene,
        limits,
        status,
        ended,
        plan,
    } in kept
    {
        let request = json!({ "scene": scene, "limits": limits });
        let answer = giveway_wasm::solve(&object(&request), &JsValue::UNDEFINED).unwrap();
        let get = |key: &str| Reflect::get(&answer, &key.into()).unwrap();
        assert_eq!(get("status").as_string().unwrap(), status, "{scene}");
        assert_eq!(get("ended").as_string().unwrap(), ended, "{scene}");
        let found = String::from(JSON::stringify(&get("plan")).unwrap());
        assert_eq!(found, plan, "{scene}");
    }
}
