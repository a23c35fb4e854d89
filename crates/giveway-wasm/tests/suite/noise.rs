//! Noise for every function: an answer or an `Error` of ours comes out, never a trap.

use serde_json::{Map, Value, json};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, js, object, told, warehouse};

type Function = fn(&JsValue) -> Result<JsValue, JsValue>;

const NONE: JsValue = JsValue::UNDEFINED;

const FUNCTIONS: [(&str, Function); 19] = [
    ("solve", |request| giveway_wasm::solve(request, &NONE)),
    ("check", giveway_wasm::check),
    ("explain", |request| giveway_wasm::explain(request, &NONE)),
    ("certify", |request| giveway_wasm::certify(request, &NONE)),
    ("verify", |request| giveway_wasm::verify(request, &NONE)),
    ("convert", giveway_wasm::convert),
    ("change", |request| giveway_wasm::change(request, &NONE)),
    ("audit", |request| giveway_wasm::audit(request, &NONE)),
    ("freedom", |request| giveway_wasm::freedom(request, &NONE)),
    ("price", |request| giveway_wasm::price(request, &NONE)),
    ("delays", |request| giveway_wasm::delays(request, &NONE)),
    ("order", |request| giveway_wasm::order(request, &NONE)),
    ("sizing", |request| giveway_wasm::sizing(request, &NONE)),
    ("plan", |request| giveway_wasm::plan(request, &NONE)),
    ("compare", giveway_wasm::compare_plans),
    ("readFiles", |files| giveway_wasm::read_files(files, &NONE)),
    ("readScene", giveway_wasm::read_scene),
    ("readPlan", giveway_wasm::read_plan),
    ("readMovingAi", |text| {
        giveway_wasm::read_moving_ai(text, text, &NONE)
    }),
];

/// Random numbers of one seed.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: usize) -> usize {
        // Knuth's multiplier; the high bits are the random ones.
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n as u64) as usize
    }
}

/// A small scene with everything in it, a plan, and what was claimed of it.
fn requests() -> Vec<Value> {
    let scene = json!({ "giveway": 1, "map": ["..+", "~~.", ".#."],
        "rules": { "at_goal": "vanish", "battery_floor": 1 }, "objective": ["makespan", "charges"],
        "agents": [{ "name": "a", "start": [0, 0], "goal": [2, 2], "waypoints": [[1, 1]],
            "battery": { "capacity": 6, "initial": 6 } }] });
    let limits = json!({ "conflicts": 200, "seconds": 2 });
    let answer = super::solve(&json!({ "scene": scene, "limits": limits }));
    let (plan, bounds) = (&answer["plan"], &answer["bounds"]);
    assert!(!plan.is_null());
    let question = json!({ "kind": "visit", "agent": "a", "at": [1, 1], "time": 2 });
    let about = json!({ "most": {}, "within": null });
    let text = scene.to_string();
    vec![
        json!({ "scene": scene, "limits": limits }),
        json!({ "scene": scene, "plan": plan }),
        json!({ "scene": scene, "plan": plan, "question": question, "limits": limits }),
        json!({ "scene": scene, "plan": plan, "bounds": bounds, "about": about, "impossible": false,
            "complete": true, "within": null, "limits": limits }),
        json!({ "files": { "manifest.json": "{}", "instance.json": text }, "limits": limits }),
        json!({ "files": { "a.json": text, "b.map": "type octile\nheight 1\nwidth 2\nmap\n..\n",
            "b.scen": "version 1\n0\tb.map\t2\t1\t0\t0\t1\t0\t1\n" }, "to": "movingai", "agents": 1 }),
    ]
}

/// Changes a random place of a value.
fn spoil(value: &mut Value, chance: &mut Chance) {
    let inner: Vec<&mut Value> = match value {
        Value::Array(items) => items.iter_mut().collect(),
        Value::Object(map) => map.values_mut().collect(),
        _ => Vec::new(),
    };
    let count = inner.len();
    if count > 0 && chance.below(5) > 0 {
        let place = chance.below(count);
        if let Some(inner) = inner.into_iter().nth(place) {
            return spoil(inner, chance);
        }
    }
    let noise = [
        json!(null),
        json!(true),
        json!(-1),
        json!(0),
        json!(4_294_967_295_u64),
        json!(1e308),
        json!(0.5),
        json!(""),
        json!("a"),
        json!("\u{0}\u{202e}\n\""),
        json!([]),
        json!([[], {}, [0, 0]]),
        json!({}),
        json!({ "kind": "wait", "agent": "b" }),
        json!("x".repeat(5000)),
    ];
    match (value, chance.below(3)) {
        (Value::Object(map), 0) => {
            let key = map.keys().nth(chance.below(map.len().max(1))).cloned();
            *map = key.map_or_else(Map::new, |key| {
                let mut rest = map.clone();
                rest.remove(&key);
                rest
            });
        }
        (Value::Array(items), 0) => {
            let again = items.clone();
            items.extend(again);
        }
        (value, _) => *value = noise[chance.below(noise.len())].clone(),
    }
}

#[track_caller]
fn expect_answer_or_error(name: &str, came: Result<JsValue, JsValue>, given: &str) {
    match came {
        Ok(answer) => assert!(answer.is_object(), "{name} {given}"),
        Err(thrown) => {
            let (code, _, sentence) = told(&thrown);
            assert_ne!(code, "broken", "{name} {given}: {sentence}");
        }
    }
}

#[wasm_bindgen_test]
fn spoilt_requests_of_every_kind_never_trap() {
    let mut chance = Chance(1);
    let requests = requests();
    for round in 0..600 {
        let mut request = requests[round % requests.len()].clone();
        for _ in 0..=chance.below(3) {
            spoil(&mut request, &mut chance);
        }
        // What limits it is not spoilt, or it would take long.
        if let (Some(map), Some(limits)) = (request.as_object_mut(), requests[0].get("limits"))
            && map.contains_key("limits")
        {
            map.insert("limits".to_owned(), limits.clone());
        }
        let given = request.to_string();
        let (name, function) = FUNCTIONS[round % requests.len()];
        expect_answer_or_error(name, function(&object(&request)), &given);
        // Texts are noise for the readers, and for all others.
        let text = JsValue::from_str(&given);
        for (name, function) in &FUNCTIONS[6..] {
            expect_answer_or_error(name, function(&text), &given);
        }
    }
    // It works as ever.
    let answer = super::solve(&json!({ "scene": warehouse() }));
    assert_eq!(answer["status"], "optimal");
}

#[wasm_bindgen_test]
fn no_function_takes_what_is_no_object() {
    for code in [
        "undefined",
        "null",
        "5n",
        "() => 1",
        "new Map()",
        "[]",
        "'x'",
    ] {
        for (name, function) in FUNCTIONS {
            expect_answer_or_error(name, function(&js(code)), code);
        }
        let options = js(code);
        if !options.is_undefined() {
            let request = object(&json!({ "scene": warehouse() }));
            let thrown = giveway_wasm::explain(&request, &options).unwrap_err();
            assert_eq!(told(&thrown).0, "bad-input", "{code}");
        }
    }
}

#[wasm_bindgen_test]
fn the_schema_is_an_object_with_all_definitions() {
    let schema = data(&giveway_wasm::schema().unwrap());
    assert!(schema["$defs"]["plan"].is_object());
}
