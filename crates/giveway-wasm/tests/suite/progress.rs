//! What is told on the way.

use js_sys::{Object, Reflect};
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, js, object, warehouse};

#[wasm_bindgen_test]
fn bounds_and_plans_are_told_on_the_way_and_agree_with_the_answer() {
    let request = object(&json!({ "scene": warehouse() }));
    let options = js("(() => { const heard = []; \
        return { heard, options: { onProgress: (event) => heard.push(event) } }; })()");
    let get = |key: &str| Reflect::get(&options, &key.into()).unwrap();
    let answer = data(&giveway_wasm::solve(&request, &get("options")).unwrap());
    let heard = data(&get("heard"));
    let heard = heard.as_array().unwrap();
    let of = |kind: &str| -> Vec<&Value> {
        heard
            .iter()
            .filter(|event| event["event"] == kind)
            .collect()
    };
    assert_eq!(of("plan").last().unwrap()["costs"], answer["costs"]);
    assert_eq!(of("plan").last().unwrap()["plan"], answer["plan"]);
    let bounds = of("bound");
    let makespans = bounds.iter().filter(|event| event["cost"] == "makespan");
    let makespans: Vec<u64> = makespans
        .map(|event| event["at_least"].as_u64().unwrap())
        .collect();
    assert!(makespans.is_sorted(), "{makespans:?}");
    assert_eq!(makespans.last(), Some(&18));
}

#[wasm_bindgen_test]
fn a_trace_is_told_on_the_way_and_a_step_of_it_can_be_asked_about() {
    let scene = json!({
        "giveway": 1,
        "map": [".##.", "....", ".##."],
        "agents": [
            { "name": "A", "start": [0, 1], "goal": [3, 1] },
            { "name": "B", "start": [3, 1], "goal": [0, 1] }
        ]
    });
    let request = object(&json!({ "scene": scene, "trace": true }));
    let options = js("(() => { const heard = []; \
        return { heard, options: { onProgress: (event) => heard.push(event) } }; })()");
    let get = |key: &str| Reflect::get(&options, &key.into()).unwrap();
    let answer = data(&giveway_wasm::solve(&request, &get("options")).unwrap());
    let heard = data(&get("heard"));
    let traced = heard.as_array().unwrap().iter();
    let traced = traced.filter(|event| event["event"] == "traced");
    let told: Vec<&Value> = traced
        .flat_map(|event| event["events"].as_array().unwrap())
        .collect();
    let events = answer["trace"]["events"].as_array().unwrap();
    assert_eq!(told, events.iter().collect::<Vec<&Value>>());
    let core = events
        .iter()
        .find(|event| event["event"] == "core")
        .unwrap();
    let asked = json!({ "scene": scene, "cost": core["cost"], "agents": core["limits"] });
    let together = giveway_wasm::together(&object(&asked), &js("undefined")).unwrap();
    let together = data(&together);
    assert_eq!(together["alone"]["refuted"], true);
    assert_eq!(together["meetings"][0]["kind"], "swap");
}

#[wasm_bindgen_test]
fn a_callback_may_itself_solve() {
    let request = object(&json!({ "scene": warehouse() }));
    let options = Object::new();
    let inner = request.clone();
    let hear = wasm_bindgen::closure::Closure::<dyn Fn()>::new(move || {
        let answer = giveway_wasm::solve(&inner, &wasm_bindgen::JsValue::UNDEFINED);
        assert_eq!(data(&answer.unwrap())["status"], "optimal");
    });
    Reflect::set(&options, &"onProgress".into(), hear.as_ref()).unwrap();
    let answer = giveway_wasm::solve(&request, &options).unwrap();
    assert_eq!(data(&answer)["status"], "optimal");
}
