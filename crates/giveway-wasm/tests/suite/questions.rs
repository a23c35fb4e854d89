//! Questions, certificates and files by way of JavaScript.

use serde_json::{Value, json};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, js, object, solve, told, warehouse};

const NONE: JsValue = JsValue::UNDEFINED;

fn scene() -> Value {
    serde_json::from_str(include_str!("../../../../tests/data/seed/scenario-1.json")).unwrap()
}

#[wasm_bindgen_test]
fn a_question_is_answered_with_another_plan() {
    let scene = scene();
    let plan = solve(&json!({ "scene": scene }))["plan"].clone();
    let question = json!({ "kind": "wait", "agent": "A2" });
    let request = json!({ "scene": scene, "plan": plan, "question": question });
    let heard = js("({ onProgress: () => {} })");
    let answer = data(&giveway_wasm::explain(&object(&request), &heard).unwrap());
    assert_eq!(answer["verdict"], "needless");
    let judged = json!({ "scene": scene, "plan": answer["alternative"] });
    let judged = data(&giveway_wasm::check(&object(&judged)).unwrap());
    assert_eq!(judged["valid"], true);
}

#[wasm_bindgen_test]
fn a_question_that_does_not_fit_and_a_broken_plan_are_told() {
    let scene = scene();
    let mut plan = solve(&json!({ "scene": scene }))["plan"].clone();
    let ask = |plan: &Value, question: Value| {
        let request = json!({ "scene": scene, "plan": plan, "question": question });
        told(&giveway_wasm::explain(&object(&request), &NONE).unwrap_err())
    };
    let (code, place, sentence) = ask(&plan, json!({ "kind": "wait", "agent": "A9" }));
    assert_eq!(
        (code.as_str(), place.as_str()),
        ("bad-input", "question.agent")
    );
    assert!(sentence.contains("A9"), "{sentence}");
    plan["paths"]["A2"] = json!([[3, 1]]);
    let (code, place, _) = ask(&plan, json!({ "kind": "makespan" }));
    assert_eq!((code.as_str(), place.as_str()), ("bad-input", "plan"));
}

#[wasm_bindgen_test]
fn what_was_solved_is_certified() {
    let scene = warehouse();
    let answer = solve(&json!({ "scene": scene }));
    let request = json!({ "scene": scene, "plan": answer["plan"], "bounds": answer["bounds"],
        "about": { "most": {}, "within": null }, "impossible": false,
        "complete": answer["complete"], "within": answer["within"] });
    let report = data(&giveway_wasm::certify(&object(&request), &NONE).unwrap());
    assert_eq!(report["accepted"], true, "{report}");
    let claims = report["claims"].as_array().unwrap();
    let shown = claims.iter().filter(|claim| claim["kind"] != "none");
    assert!(shown.count() > 0, "{report}");
}

#[wasm_bindgen_test]
fn a_folder_that_is_no_certificate_is_rejected() {
    let request = json!({ "files": { "manifest.json": "{}" } });
    let report = data(&giveway_wasm::verify(&object(&request), &NONE).unwrap());
    assert_eq!(report["accepted"], false);
    assert!(report["reason"].as_str().unwrap().contains("manifest"));
}

#[wasm_bindgen_test]
fn a_plan_is_read_audited_and_compared() {
    let scene = json!({ "giveway": 1, "name": "a", "map": ["...", ".#."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 1] }] });
    let plan = json!({ "giveway": 1,
        "paths": { "A1": [[0, 0], [0, 0], [1, 0], [2, 0], [2, 1]] } });
    let files = json!({ "a.json": scene.to_string(), "p.json": plan.to_string() });
    let read = data(&giveway_wasm::read_files(&object(&files), &NONE).unwrap());
    assert_eq!(read["plans"][0]["format"], "giveway");
    let (scene, plan) = (&read["scene"], &read["plans"][0]["plan"]);
    let request = json!({ "scene": scene, "plan": plan });
    let answer = data(&giveway_wasm::audit(&object(&request), &NONE).unwrap());
    assert_eq!(answer["status"], "feasible");
    assert_eq!(answer["better_costs"]["makespan"], 3);
    let request = json!({ "scene": scene, "plans": [plan, answer["better"]] });
    let compared = data(&giveway_wasm::compare_plans(&object(&request)).unwrap());
    assert_eq!(compared["agents"][0]["difference"], "retimed");
    let lone = json!({ "a.scen": "version 1\n0\ta.map\t3\t2\t0\t0\t2\t1\t0\n" });
    let (code, place, sentence) =
        told(&giveway_wasm::read_files(&object(&lone), &NONE).unwrap_err());
    assert_eq!((code.as_str(), place.as_str()), ("bad-text", "a.scen"));
    assert!(sentence.contains("a.map"), "{sentence}");
}

#[wasm_bindgen_test]
fn bytes_of_files_are_read_in_their_encoding() {
    let map = "type octile\nheight 1\nwidth 2\nmap\n..\n";
    let bytes: Vec<u8> = map.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let files = js_sys::Object::new();
    let bytes = js_sys::Uint8Array::from(bytes.as_slice());
    js_sys::Reflect::set(&files, &"a.map".into(), &bytes).unwrap();
    let read = data(&giveway_wasm::read_files(&files, &NONE).unwrap());
    assert_eq!(read["scene"]["map"], json!([".."]));
}

#[wasm_bindgen_test]
fn what_every_best_plan_has_is_told() {
    let scene = json!({ "giveway": 1, "map": ["..#.", "...."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 1] },
            { "name": "A2", "start": [3, 0], "goal": [0, 1] }] });
    let answer = data(&giveway_wasm::freedom(&object(&json!({ "scene": scene })), &NONE).unwrap());
    assert_eq!(answer["status"], "optimal");
    assert_eq!(answer["plans"]["count"], 7);
    assert_eq!(answer["backbone"]["A2"][2]["always"], true);
    assert_eq!(answer["critical"].as_array().unwrap().len(), 7);
    assert!(answer.get("pending").is_none());
    let request = json!({ "scene": scene, "parts": ["slack"] });
    let answer = data(&giveway_wasm::freedom(&object(&request), &NONE).unwrap());
    assert_eq!(answer["slack"]["A2"]["arrival"], 0);
    assert!(answer.get("critical").is_none());
    let plan = json!({ "giveway": 1, "paths": { "A1": [[0, 0]], "A2": [[3, 0]] } });
    let request = json!({ "scene": scene, "plan": plan });
    let (code, place, _) = told(&giveway_wasm::freedom(&object(&request), &NONE).unwrap_err());
    assert_eq!((code.as_str(), place.as_str()), ("bad-input", "plan"));
}

#[wasm_bindgen_test]
fn rules_have_prices() {
    let scene = json!({ "giveway": 1, "map": ["...", "#.#", "..."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [0, 2] },
            { "name": "A2", "start": [2, 0], "goal": [2, 2] }],
        "zones": [{ "name": "aisle", "rect": [1, 0, 1, 2] }],
        "constraints": [{ "kind": "capacity", "zone": "aisle", "most": 1 }] });
    let answer = data(&giveway_wasm::price(&object(&json!({ "scene": scene })), &NONE).unwrap());
    assert_eq!(answer["prices"][0]["price"], "costs");
    assert_eq!(answer["prices"][0]["exact"], true);
    assert_eq!(
        answer["words"],
        "At most 1 robot in 'aisle': costs 2 steps of the makespan."
    );
    let rule = json!({ "kind": "arrive", "by": 5 });
    let question = json!({ "kind": "rule", "rule": rule });
    let request = json!({ "scene": scene, "question": question });
    let answer = data(&giveway_wasm::explain(&object(&request), &NONE).unwrap());
    assert_eq!(answer["verdict"], "necessary");
    assert_eq!(answer["question"], question);
}

#[wasm_bindgen_test]
fn delays_are_split_by_whom_a_robot_lets_pass() {
    let scene = json!({ "giveway": 1, "map": ["...", "#.#"],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] },
            { "name": "A2", "start": [2, 0], "goal": [0, 0] }] });
    let answer = data(&giveway_wasm::delays(&object(&json!({ "scene": scene })), &NONE).unwrap());
    assert_eq!(answer["delay"], 3);
    assert_eq!(answer["alone"], 4);
    assert_eq!(answer["agents"][0]["because"][0]["because"], "agent");
    assert_eq!(answer["proof"]["at_least"], 3);
    let plan = answer["plan"].clone();
    let request = json!({ "scene": scene, "plan": plan, "ledger_only": true });
    let again = data(&giveway_wasm::delays(&object(&request), &NONE).unwrap());
    assert_eq!(again["agents"], answer["agents"]);
    assert_eq!(again["proof"], Value::Null);
}

#[wasm_bindgen_test]
fn robots_keep_an_order() {
    let scene = json!({ "giveway": 1, "map": ["...."],
        "agents": [{ "name": "A1", "start": [1, 0], "goal": [3, 0] },
            { "name": "A2", "start": [0, 0], "goal": [2, 0] }] });
    let late = json!([{ "agent": "A1", "cell": [2, 0], "steps": 3 }]);
    let request =
        json!({ "scene": scene, "late": late, "to": ["dot", "csv", "waypoints", "vda5050"] });
    let answer = data(&giveway_wasm::order(&object(&request), &NONE).unwrap());
    assert_eq!(answer["order"]["links"].as_array().unwrap().len(), 2);
    assert_eq!(answer["without_slack"], 2);
    assert_eq!(
        answer["late"]["arrivals"][1],
        json!({ "agent": "A2", "planned": 2, "now": 5, "most": 3 })
    );
    let files = answer["files"].as_array().unwrap();
    assert_eq!(files.len(), 4);
    assert!(
        files[3]["text"]
            .as_str()
            .unwrap()
            .contains("\"orderUpdateId\"")
    );
    let late = json!([{ "agent": "A3", "cell": [2, 0], "steps": 3 }]);
    let request = json!({ "scene": scene, "late": late });
    let (code, place, _) = told(&giveway_wasm::order(&object(&request), &NONE).unwrap_err());
    assert_eq!(
        (code.as_str(), place.as_str()),
        ("bad-input", "late[0].agent")
    );
}

#[wasm_bindgen_test]
fn a_planner_of_the_textbook_plans_and_tells_how() {
    let scene = json!({ "giveway": 1, "map": ["#.#", "...", "#.#"], "objective": ["sum-of-costs"],
        "agents": [{ "name": "A", "start": [0, 1], "goal": [2, 1] },
            { "name": "B", "start": [1, 0], "goal": [1, 2] }] });
    let request = json!({ "scene": scene, "planner": "cbs", "trace": true });
    let answer = data(&giveway_wasm::plan(&object(&request), &NONE).unwrap());
    assert_eq!(answer["ended"], json!({ "how": "best", "within": null }));
    assert_eq!(answer["bounds"]["sum-of-costs"], 5);
    assert_eq!(answer["trace"]["nodes"][0]["fate"], "split");
    let request = json!({ "scene": scene, "planner": "guess" });
    let (code, place, _) = told(&giveway_wasm::plan(&object(&request), &NONE).unwrap_err());
    assert_eq!((code.as_str(), place.as_str()), ("bad-input", "planner"));
}

#[wasm_bindgen_test]
fn files_are_converted_there_and_back() {
    let scene = json!({ "giveway": 1, "name": "a", "map": ["...", ".#."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 1] }] });
    let request = json!({ "files": { "a.json": scene.to_string() }, "to": "movingai" });
    let written = data(&giveway_wasm::convert(&object(&request)).unwrap());
    let files = written["files"].as_object().unwrap();
    assert_eq!(files.keys().collect::<Vec<_>>(), ["a.map", "a.scen"]);
    let request = json!({ "files": files, "to": "giveway" });
    let back = data(&giveway_wasm::convert(&object(&request)).unwrap());
    let text = back["files"]["a.json"].as_str().unwrap();
    let back: Value = serde_json::from_str(text).unwrap();
    assert_eq!(back["map"], scene["map"]);
    assert_eq!(back["agents"][0]["goal"], json!([2, 1]));
    let request = json!({ "files": { "a.scen": files["a.scen"] }, "to": "giveway" });
    let (code, place, sentence) = told(&giveway_wasm::convert(&object(&request)).unwrap_err());
    assert_eq!((code.as_str(), place.as_str()), ("bad-text", "a.scen"));
    assert!(sentence.contains("map"), "{sentence}");
}
