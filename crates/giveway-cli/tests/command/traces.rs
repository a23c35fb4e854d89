//! `giveway solve --trace`: how the best plan was found and proved.

use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::{Folder, Run, SCENARIO_6, WAREHOUSE};

/// The trace of `scene.json`, which must fit the schema, and what was said beside it.
fn traced(folder: &Folder, line: &str) -> (Run, Value) {
    let run = folder.run(&format!("solve scene.json --trace trace.json {line}"));
    assert_eq!(run.err, "");
    let trace = serde_json::from_str(&folder.read("trace.json")).unwrap();
    fits("searchTrace", &trace);
    (run, trace)
}

fn kinds(trace: &Value) -> Vec<&str> {
    let events = trace["events"].as_array().unwrap().iter();
    events.map(|step| step["event"].as_str().unwrap()).collect()
}

#[test]
fn the_last_step_says_what_the_answer_says() {
    let folder = Folder::scene(WAREHOUSE);
    let (run, trace) = traced(&folder, "--format json");
    assert_eq!(run.exit, Some(0));
    let answer: Value = serde_json::from_str(&run.out).unwrap();
    fits("solveResult", &answer);
    assert_eq!(answer.get("trace"), None, "it is in a file of its own");
    let kinds = kinds(&trace);
    assert_eq!(kinds[0], "alone");
    let phases = kinds.iter().filter(|kind| **kind == "phase").count();
    let costs = trace["objective"].as_array().unwrap();
    assert_eq!(phases, costs.len() - 1, "{kinds:?}");
    let last = trace["events"].as_array().unwrap().last().unwrap();
    assert_eq!(last["event"], "met");
    for cost in costs {
        let cost = cost.as_str().unwrap();
        assert_eq!(last["costs"][cost], answer["costs"][cost]);
    }
}

#[test]
fn the_answer_is_the_same_without() {
    let folder = Folder::scene(WAREHOUSE);
    let answer = |line: &str| {
        let run = folder.run(&format!("solve scene.json --format json {line}"));
        let mut answer: Value = serde_json::from_str(&run.out).unwrap();
        answer["stats"]["cpu_seconds"] = json!(0);
        answer
    };
    assert_eq!(answer("--trace trace.json"), answer(""));
}

#[test]
fn that_there_is_no_plan_is_the_last_step() {
    let folder = Folder::scene(SCENARIO_6);
    let (run, trace) = traced(&folder, "");
    assert_eq!(run.exit, Some(0), "it is proved");
    let last = trace["events"].as_array().unwrap().last().unwrap();
    assert_eq!(last["event"], "impossible");
    let said = last["text"].as_str().unwrap();
    assert!(said.starts_with("No plan exists: "), "{said}");
}

#[test]
fn a_search_cut_off_says_so() {
    let folder = Folder::scene(WAREHOUSE);
    let (_, trace) = traced(&folder, "--time-limit 0.000001");
    assert_eq!(kinds(&trace).last(), Some(&"stopped"));
}

/// The scene and the trace of the documentation.
#[test]
fn the_trace_that_the_documentation_explains_is_that_of_its_scene() {
    let text = include_str!("../../../../docs/trace.md");
    let blocks: Vec<&str> = text.split("```json\n").skip(1).collect();
    let [scene, trace] = blocks.as_slice() else {
        panic!("{} blocks of JSON", blocks.len());
    };
    let block = |text: &str| text.split_once("```").unwrap().0.to_owned();
    let folder = Folder::scene(block(scene));
    let (_, written) = traced(&folder, "");
    let explained: Value = serde_json::from_str(&block(trace)).unwrap();
    assert_eq!(written, explained);
    // Each step is explained, in its own words.
    let (_, lines) = text.rsplit_once("```\n").unwrap();
    for step in written["events"].as_array().unwrap() {
        let number = format!("- **{}**", step["number"]);
        assert!(lines.contains(&number), "{number} is not explained");
    }
}
