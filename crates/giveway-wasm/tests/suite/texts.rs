//! Texts of files, read in Wasm.

use serde_json::{Value, json};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, told};

const MAP: &str = "type octile\nheight 1\nwidth 3\nmap\n..@\n";
const SCENARIO: &str = "version 1\n0\ta.map\t3\t1\t0\t0\t1\t0\t1\n";

fn read(map: &str, scenario: &str, options: &JsValue) -> Result<JsValue, JsValue> {
    giveway_wasm::read_moving_ai(&map.into(), &scenario.into(), options)
}

#[wasm_bindgen_test]
fn a_scene_and_a_plan_come_back_as_objects() {
    let text = include_str!("../../../../tests/data/seed/warehouse.json");
    let scene = data(&giveway_wasm::read_scene(&text.into()).unwrap());
    let written: Value = serde_json::from_str(text).unwrap();
    assert_eq!(scene["agents"][0]["name"], written["agents"][0]["name"]);
    let text = include_str!("../../../../tests/data/seed/warehouse.plan.json");
    let plan = data(&giveway_wasm::read_plan(&text.into()).unwrap());
    let request = super::object(&json!({ "scene": scene, "plan": plan }));
    let verdict = data(&giveway_wasm::check(&request).unwrap());
    assert_eq!(verdict["valid"], true);
    assert_eq!(verdict["costs"]["makespan"], 18);
}

#[wasm_bindgen_test]
fn a_fault_of_a_text_has_its_line_and_column() {
    let text = "{ \"giveway\": 1, \"map\": [\"..\"],\n  \"agents\": [\
        { \"name\": \"a\", \"start\": [0, 0], \"goal\": [5, 0] }] }";
    let thrown = giveway_wasm::read_scene(&text.into()).unwrap_err();
    let (code, place, sentence) = told(&thrown);
    assert_eq!(
        (code.as_str(), place.as_str()),
        ("bad-text", "agents[0].goal")
    );
    assert!(sentence.starts_with("line 2, column "), "{sentence}");
    let thrown = giveway_wasm::read_plan(&"{".into()).unwrap_err();
    assert_eq!(told(&thrown).0, "bad-text");
}

#[wasm_bindgen_test]
fn moving_ai_files_become_a_scene() {
    let options = super::object(&json!({ "name": "two", "agents": 1 }));
    let scene = data(&read(MAP, SCENARIO, &options).unwrap());
    assert_eq!(scene["map"], json!(["..#"]));
    assert_eq!(scene["name"], "two");
    assert_eq!(scene["agents"][0]["goal"], json!([1, 0]));
}

#[wasm_bindgen_test]
fn a_fault_tells_which_of_the_two_texts_has_it() {
    let thrown = read(
        "type octile\nheight 1\nwidth 3\nmap\n..?\n",
        SCENARIO,
        &JsValue::UNDEFINED,
    );
    let (code, place, sentence) = told(&thrown.unwrap_err());
    assert_eq!((code.as_str(), place.as_str()), ("bad-text", "map"));
    assert!(sentence.starts_with("line 5"), "{sentence}");
    let thrown = read(MAP, "version 1\nnoise\n", &JsValue::UNDEFINED);
    assert_eq!(told(&thrown.unwrap_err()).1, "scenario");
    let thrown = read(MAP, SCENARIO, &super::object(&json!({ "agents": 2 })));
    assert_eq!(told(&thrown.unwrap_err()).1, "scenario");
    let thrown = read(MAP, SCENARIO, &super::object(&json!({ "agent": 2 })));
    assert_eq!(told(&thrown.unwrap_err()).0, "bad-input");
}
