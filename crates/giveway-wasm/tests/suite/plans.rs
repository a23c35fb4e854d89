//! Wasm gives the native answers.

use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

use super::cases::CASES;
use super::{expect_judged, solve};

/// The answer without what a clock has told.
fn without_seconds(mut answer: Value) -> Value {
    if let Some(stats) = answer.get_mut("stats") {
        stats["cpu_seconds"] = json!(0);
    }
    if let Some(Value::Array(front)) = answer.get_mut("front") {
        let points = front.drain(..).map(without_seconds).collect();
        *front = points;
    }
    answer
}

#[wasm_bindgen_test]
fn native_and_wasm_give_the_same_answer_in_as_much_work() {
    for case in CASES {
        let scene: Value = serde_json::from_str(case.scene).unwrap();
        let mut request = json!({ "scene": scene, "pareto": case.pareto });
        if let Some(objective) = case.objective {
            request["objective"] = objective.split(',').collect();
        }
        if let Some(conflicts) = case.conflicts {
            request["limits"] = json!({ "conflicts": conflicts });
        }
        let answer = without_seconds(solve(&request));
        let expected: Value = serde_json::from_str(case.expected).unwrap();
        assert_eq!(answer, without_seconds(expected), "{}", case.name);
        if !answer["plan"].is_null() {
            expect_judged(&scene, &answer);
        }
    }
}

#[wasm_bindgen_test]
fn the_examples_have_the_costs_of_the_literature() {
    let answer = solve(&json!({ "scene": super::warehouse() }));
    assert_eq!(answer["status"], "optimal");
    let costs = ["makespan", "sum-of-costs", "charges"].map(|cost| answer["costs"][cost].clone());
    assert_eq!(costs, [18, 35, 3]);
}
