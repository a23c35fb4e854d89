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
    conflicts: u64,
    status: String,
    plan: String,
}

#[wasm_bindgen_test]
fn random_instances_have_the_native_plans_byte_for_byte() {
    let kept: Vec<Kept> = serde_json::from_str(include_str!("../data/random.json")).unwrap();
    assert_eq!(kept.len(), 50);
    for Kept {
        scene,
        conflicts,
        status,
        plan,
    } in kept
    {
        let request = json!({ "scene": scene, "limits": { "conflicts": conflicts } });
        let answer = giveway_wasm::solve(&object(&request), &JsValue::UNDEFINED).unwrap();
        let get = |key: &str| Reflect::get(&answer, &key.into()).unwrap();
        assert_eq!(get("status").as_string().unwrap(), status, "{scene}");
        let found = String::from(JSON::stringify(&get("plan")).unwrap());
        assert_eq!(found, plan, "{scene}");
    }
}
