//! Whatever is handed in, an `Error` with a sentence comes out.

use js_sys::Reflect;
use serde_json::{Value, json};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, hard, js, object, told, warehouse};

/// Expects a refusal of a request with this scene and these other keys.
#[track_caller]
fn expect_refused(request: &JsValue, place: &str, found: &str) {
    let thrown = giveway_wasm::solve(request, &JsValue::UNDEFINED).unwrap_err();
    let (code, at, sentence) = told(&thrown);
    assert_eq!(
        (code.as_str(), at.as_str()),
        ("bad-input", place),
        "{sentence}"
    );
    assert!(sentence.contains(found), "{sentence}");
}

fn with(change: impl FnOnce(&mut Value)) -> JsValue {
    let mut request = json!({ "scene": warehouse() });
    change(&mut request);
    object(&request)
}

#[wasm_bindgen_test]
fn values_of_wrong_types_are_told_with_their_place() {
    let of = |value: Value| with(|request| request["scene"]["agents"][1]["goal"] = value);
    let place = "scene.agents[1].goal";
    expect_refused(&of(json!("x")), place, "found the text \"x\"");
    expect_refused(&of(json!({})), place, "found an object");
    expect_refused(
        &with(|r| r["scene"]["agents"][1]["goal"][0] = json!(1.5)),
        "scene.agents[1].goal[0]",
        "1.5",
    );
    expect_refused(&with(|r| r["within"] = json!(-1)), "within", "-1");
    expect_refused(&with(|r| r["within"] = json!(1e300)), "within", "1e+300");
    expect_refused(
        &with(|r| r["pareto"] = json!(1)),
        "pareto",
        "found the number 1",
    );
    expect_refused(
        &with(|r| r["objective"] = json!(["time"])),
        "objective[0]",
        "time",
    );
    expect_refused(&with(|r| r["limits"] = json!([1])), "limits", "a list");
    expect_refused(
        &with(|r| r["limits"] = json!({ "second": 1 })),
        "limits",
        "second",
    );
    expect_refused(
        &with(|r| r["scenes"] = json!(1)),
        "",
        "the unknown key \"scenes\"",
    );
    expect_refused(&object(&json!({})), "", "no key \"scene\"");
    expect_refused(&object(&json!([warehouse()])), "", "a list");
}

#[wasm_bindgen_test]
fn what_is_no_plain_object_is_told() {
    let cases = [
        ("undefined", "found nothing"),
        ("() => 1", "found a function"),
        ("Symbol('x')", "found a symbol"),
        ("5n", "5n"),
        ("NaN", "NaN"),
        ("null", "found null"),
        ("'text'", "text"),
        ("new Map()", "Map"),
        (
            "(() => { const a = {}; a.scene = a; return a; })()",
            "cannot be read",
        ),
        (
            "({ get scene() { throw new Error('no'); } })",
            "cannot be read: no",
        ),
        (
            "new Proxy({}, { ownKeys() { throw 1; } })",
            "cannot be read",
        ),
        ("({ toJSON() { throw null; } })", "cannot be read"),
        (
            "({ scene: { giveway: 1, map: [], agents: [], rules: { battery_floor: NaN } } })",
            "NaN",
        ),
        ("({ scene: new Set() })", "Set"),
        (
            "(() => { let a = {}; for (let i = 0; i < 1000; i++) a = { scene: a }; return a; })()",
            "found",
        ),
        (
            "(() => { let a = []; for (let i = 0; i < 1e5; i++) a = [a]; return a; })()",
            "found",
        ),
    ];
    for (code, found) in cases {
        let thrown = giveway_wasm::solve(&js(code), &JsValue::UNDEFINED).unwrap_err();
        let (kind, _, sentence) = told(&thrown);
        assert_eq!(kind, "bad-input", "{code}: {sentence}");
        assert!(sentence.contains(found), "{code}: {sentence}");
        let thrown = giveway_wasm::check(&js(code)).unwrap_err();
        assert_eq!(told(&thrown).0, "bad-input", "{code}");
        for text in [
            giveway_wasm::read_scene(&js(code)),
            giveway_wasm::read_plan(&js(code)),
        ] {
            told(&text.unwrap_err());
        }
    }
}

#[wasm_bindgen_test]
fn every_fault_of_a_scene_is_told() {
    let request = with(|request| {
        request["scene"]["agents"][0]["goal"] = json!([99, 99]);
        request["scene"]["agents"][1]["name"] = json!("");
    });
    let thrown = giveway_wasm::solve(&request, &JsValue::UNDEFINED).unwrap_err();
    let (code, place, sentence) = told(&thrown);
    assert_eq!(
        (code.as_str(), place.as_str()),
        ("bad-scene", "scene.agents[0].goal")
    );
    assert!(sentence.ends_with("(and one more fault)"), "{sentence}");
    let faults = data(&Reflect::get(&thrown, &"faults".into()).unwrap());
    assert_eq!(faults[1]["place"], "scene.agents[1].name");
}

#[wasm_bindgen_test]
fn a_front_of_one_cost_is_refused() {
    let request = with(|request| {
        request["pareto"] = json!(true);
        request["objective"] = json!(["makespan"]);
    });
    expect_refused(&request, "objective", "found 1 costs");
}

#[wasm_bindgen_test]
fn options_of_wrong_types_are_told() {
    let request = with(|_| ());
    let cases = [
        ("null", "options"),
        ("5", "options"),
        ("[]", "options"),
        ("({ onprogress() {} })", "options"),
        ("({ onProgress: 1 })", "options.onProgress"),
        ("({ shouldStop: null })", "options.shouldStop"),
        ("({ shouldStop: async () => false })", "options.shouldStop"),
    ];
    for (code, place) in cases {
        let thrown = giveway_wasm::solve(&request, &js(code)).unwrap_err();
        assert_eq!(told(&thrown).1, place, "{code}");
    }
}

#[wasm_bindgen_test]
fn what_a_callback_throws_comes_out_as_it_is() {
    let request = object(&json!({ "scene": hard() }));
    let start = js_sys::Date::now();
    for code in [
        "({ onProgress() { throw 'mine'; } })",
        "({ shouldStop() { throw 'mine'; } })",
    ] {
        let thrown = giveway_wasm::solve(&request, &js(code)).unwrap_err();
        assert_eq!(thrown.as_string().as_deref(), Some("mine"), "{code}");
    }
    assert!(js_sys::Date::now() - start < 5000.0);
}

#[wasm_bindgen_test]
fn a_plan_that_is_noise_is_judged() {
    for plan in [
        json!({ "giveway": 1, "paths": {} }),
        json!({ "giveway": 1, "paths": { "A1": [], "__proto__": [[4_294_967_295_u32, 0], null] } }),
        json!({ "giveway": 1, "paths": { "A1": [null, null] }, "charges": { "A1": [4_294_967_295_u32, 0] },
            "from": { "A1": 4_294_967_295_u32 }, "until": { "A1": 0 } }),
    ] {
        let request = object(&json!({ "scene": warehouse(), "plan": plan }));
        let verdict = data(&giveway_wasm::check(&request).unwrap());
        assert_eq!(verdict["valid"], false, "{plan}");
    }
}
