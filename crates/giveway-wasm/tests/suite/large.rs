//! Whatever is opened, the memory stays small enough for a tab.

use std::fmt::Write as _;

use js_sys::{Reflect, WebAssembly};
use serde_json::{Value, json};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, object, solve};

/// What the linear memory may be, of the 600 MB of a tab.
const LARGEST: f64 = 500e6;

#[track_caller]
fn expect_small_memory(name: &str) {
    let memory: WebAssembly::Memory = wasm_bindgen::memory().unchecked_into();
    let length = Reflect::get(&memory.buffer(), &"byteLength".into()).unwrap();
    let length = length.as_f64().unwrap();
    assert!(length < LARGEST, "{length} bytes after {name}");
}

/// The scene of a map and a scenario's first agents.
fn moving_ai(map: &str, scenario: &str, agents: usize) -> Value {
    let options = object(&json!({ "agents": agents }));
    data(&giveway_wasm::read_moving_ai(&map.into(), &scenario.into(), &options).unwrap())
}

/// An empty map with agents that cross it.
fn empty(side: usize, agents: usize) -> Value {
    let row = ".".repeat(side) + "\n";
    let map = format!(
        "type octile\nheight {side}\nwidth {side}\nmap\n{}",
        row.repeat(side)
    );
    let mut scenario = "version 1\n".to_owned();
    for i in 0..agents {
        let (x, y) = (i % side, i / side);
        let (u, v) = (side - 1 - y, side - 1 - x);
        writeln!(
            scenario,
            "0\tempty.map\t{side}\t{side}\t{x}\t{y}\t{u}\t{v}\t0"
        )
        .unwrap();
    }
    moving_ai(&map, &scenario, agents)
}

/// Solves, and expects an honest end in little memory.
#[track_caller]
fn expect_honest(name: &str, scene: &Value) {
    let request = json!({ "scene": scene, "limits": { "seconds": 2.0 } });
    let start = js_sys::Date::now();
    let answer = solve(&request);
    let seconds = (js_sys::Date::now() - start) / 1000.0;
    let status = answer["status"].as_str().unwrap();
    assert_ne!(status, "impossible", "{name}");
    if status != "optimal" {
        let reason = answer["reason"].as_str().unwrap();
        assert!(reason.contains(" limit was reached."), "{name}: {reason}");
    }
    assert!(seconds < 30.0, "{seconds} s for {name}");
    expect_small_memory(name);
}

#[wasm_bindgen_test]
fn a_warehouse_with_hundreds_of_agents() {
    let map = include_str!("../../../../tests/data/movingai/warehouse-10-20-10-2-1.map");
    let scenario =
        include_str!("../../../../tests/data/movingai/warehouse-10-20-10-2-1-random-1.scen");
    expect_honest("the warehouse", &moving_ai(map, scenario, 400));
}

#[wasm_bindgen_test]
fn a_wide_map_with_a_thousand_agents() {
    expect_honest("256 x 256", &empty(256, 1000));
}

#[wasm_bindgen_test]
fn a_map_of_a_million_cells_with_thousands_of_agents() {
    expect_honest("1024 x 1024", &empty(1024, 4096));
}

#[wasm_bindgen_test]
fn batteries_and_waypoints_that_multiply_the_states() {
    let row = "~+".repeat(50);
    let map: Vec<&str> = (0..100).map(|_| row.as_str()).collect();
    let agents: Vec<Value> = (0..40)
        .map(|i| {
            let waypoints: Vec<[usize; 2]> = (0..12)
                .map(|k| [(7 * i + 11 * k) % 100, 3 * k + 20])
                .collect();
            json!({ "name": format!("A{i}"), "start": [i, 0], "goal": [99 - i, 99],
                "waypoints": waypoints,
                "battery": { "capacity": 1_000_000, "initial": 1_000_000 } })
        })
        .collect();
    let scene = json!({ "giveway": 1, "map": map, "agents": agents });
    expect_honest("batteries", &scene);
}

#[wasm_bindgen_test]
fn a_text_that_is_too_long_is_refused() {
    let text = js_sys::JsString::from("giveway ").repeat(5 << 20);
    let thrown = giveway_wasm::read_scene(&JsValue::from(text)).unwrap_err();
    let (code, place, sentence) = super::told(&thrown);
    assert_eq!((code.as_str(), place.as_str()), ("bad-input", "text"));
    assert!(sentence.contains("41943040 characters"), "{sentence}");
    expect_small_memory("a text");
}
