//! Limits, and stopping: what is known by then, never "impossible".

use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, expect_judged, hard, js, object, solve};

/// An answer that was cut short, and by what.
#[track_caller]
fn expect_cut_short(answer: &Value, reason: &str) {
    let status = answer["status"].as_str().unwrap();
    assert!(["feasible", "unknown"].contains(&status), "{status}");
    let told = answer["reason"].as_str().unwrap();
    assert!(told.contains(reason), "{told}");
    if status == "feasible" {
        expect_judged(&hard(), answer);
    }
}

#[wasm_bindgen_test]
fn a_limit_of_seconds_ends_it_soon() {
    let start = js_sys::Date::now();
    let answer = solve(&json!({ "scene": hard(), "limits": { "seconds": 0.5 } }));
    let seconds = (js_sys::Date::now() - start) / 1000.0;
    expect_cut_short(&answer, "The time limit was reached");
    // In a release build 0.3 s after the limit; here, among other tests, more.
    assert!(seconds < 3.0, "{seconds} s");
}

#[wasm_bindgen_test]
fn a_limit_of_conflicts_ends_it_at_the_same_place_each_time() {
    let request = json!({ "scene": hard(), "limits": { "conflicts": 20 } });
    let answer = solve(&request);
    expect_cut_short(&answer, "The conflict limit was reached");
    let again = solve(&request);
    assert_eq!(answer["plan"], again["plan"]);
    assert_eq!(answer["bounds"], again["bounds"]);
    assert_eq!(answer["stats"]["clauses"], again["stats"]["clauses"]);
}

#[wasm_bindgen_test]
fn a_limit_of_memory_ends_it() {
    let request = json!({ "scene": hard(), "limits": { "memory_bytes": 1_000_000 } });
    expect_cut_short(&solve(&request), "The memory limit was reached");
}

#[wasm_bindgen_test]
fn the_caller_may_stop_it() {
    let request = object(&json!({ "scene": hard() }));
    let options = js("(() => { let asked = 0; return { shouldStop: () => ++asked > 20 }; })()");
    let start = js_sys::Date::now();
    let answer = giveway_wasm::solve(&request, &options).unwrap();
    expect_cut_short(&data(&answer), "The search was cancelled");
    assert!(js_sys::Date::now() - start < 5000.0);
}
