//! The JSON Schema accepts what the reader accepts, and refuses what it refuses.

use giveway_course::lesson::{Lesson, read_lesson};
use jsonschema::{Registry, Validator};
use serde_json::{Value, json};

use super::shipped;

/// A validator of one definition, with the scenes and plans of the model's schema.
pub(crate) fn with_definition<T>(name: &str, look: impl FnOnce(&Validator) -> T) -> T {
    let model: Value = serde_json::from_str(giveway_model::format::schema()).unwrap();
    let registry = Registry::new().add("urn:giveway:format:1", model).unwrap();
    let registry = registry.prepare().unwrap();
    let mut schema: Value = serde_json::from_str(Lesson::schema()).unwrap();
    let object = schema.as_object_mut().unwrap();
    object.remove("anyOf");
    object.insert("$ref".into(), format!("#/$defs/{name}").into());
    let validator = jsonschema::options()
        .with_registry(&registry)
        .build(&schema);
    look(&validator.unwrap())
}

#[test]
fn the_schema_is_one() {
    let schema: Value = serde_json::from_str(Lesson::schema()).unwrap();
    assert!(jsonschema::meta::is_valid(&schema));
}

#[test]
fn shipped_files_are_accepted() {
    let accepts = |definition: &str, name: &str| {
        let value: Value = serde_json::from_str(&shipped::text(name)).unwrap();
        with_definition(definition, |validator| {
            if let Err(error) = validator.validate(&value) {
                panic!("{name}: {error} at {}", error.instance_path());
            }
        });
    };
    accepts("course", "index");
    accepts("glossary", "glossary");
    for entry in shipped::course().lessons() {
        accepts("lesson", entry.lesson.as_str());
    }
}

/// A lesson that uses every key.
fn full() -> Value {
    json!({
        "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.",
        "steps": [
            { "title": "A", "text": ["See [A1](robot:A1)."], "time": 1, "playing": true,
              "scene": { "giveway": 1, "map": ["....", "...."], "agents": [
                  { "name": "A1", "start": [0, 0], "goal": [3, 0] },
                  { "name": "A2", "start": [3, 1], "goal": [0, 1] } ] },
              "solved": true, "show": ["trails", "lanes"] },
            { "title": "B", "text": ["Paint."], "tools": ["obstacle"], "edits": 1, "cells": [[1, 0]],
              "task": { "kind": "paint", "say": "Do.", "until": { "is": "cost", "cost": "makespan",
                        "compare": ">=", "value": 4 } },
              "hints": ["Think."], "reason": "So." },
            { "title": "C", "text": ["Say."],
              "task": { "kind": "predict", "say": "When?", "what": { "is": "arrival", "robot": "A1" },
                        "answers": [ { "value": 3, "text": "At 3.", "reply": "Yes." },
                                     { "value": 4, "text": "At 4.", "reply": "No." } ] },
              "reason": "So." },
            { "title": "D", "text": ["Choose."],
              "task": { "kind": "choose", "say": "Which?", "answers": [
                  { "text": "This.", "right": true, "reply": "Yes.", "claim": { "is": "solvable" } },
                  { "text": "That.", "reply": "No." } ] },
              "reason": "So." },
            { "title": "E", "text": ["Lead."],
              "task": { "kind": "lead", "say": "Lead.", "robots": ["A1"],
                        "aim": { "is": "best", "objective": ["sum-of-costs"] } },
              "hints": ["Think."], "reason": "So." },
            { "title": "F", "text": ["Order."],
              "task": { "kind": "order", "say": "Order.", "find": "none" },
              "hints": ["Think."], "reason": "So." },
            { "title": "G", "text": ["Change."],
              "plan": { "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0], [3, 0]],
                                                 "A2": [[3, 1], [2, 1], [1, 1], [0, 1]] } },
              "task": { "kind": "change", "say": "Go on.", "methods": ["revise", "tunnel=1"],
                        "changes": { "giveway": 1, "changes": [
                            { "at": 1, "change": "add-obstacle", "cell": [2, 0] } ] },
                        "cost": { "cost": "makespan", "at-most": 9 }, "kept": 1 },
              "hints": ["Think."], "reason": "So." },
            { "title": "H", "text": ["Spot."],
              "plan": { "giveway": 1, "paths": { "A1": [[0, 0], [0, 1], [1, 1], [2, 1], [3, 1], [3, 0]],
                                                 "A2": [[3, 1], [2, 1], [1, 1], [0, 1]] } },
              "task": { "kind": "spot", "say": "Find it." },
              "hints": ["Think."], "reason": "So." }
        ]
    })
}

fn both(value: &Value) -> (bool, bool) {
    let read = read_lesson(&value.to_string(), &shipped::glossary());
    let valid = with_definition("lesson", |validator| validator.is_valid(value));
    (read.is_ok(), valid)
}

#[test]
fn a_lesson_with_every_key_is_accepted_by_both() {
    let read = read_lesson(&full().to_string(), &shipped::glossary());
    assert_eq!(read.err(), None);
    assert_eq!(both(&full()), (true, true));
}

#[test]
fn broken_lessons_are_refused_by_both() {
    let broken = [
        ("/giveway", json!(2)),
        ("/title", json!("")),
        ("/title", Value::Null),
        ("/minutes", json!(0)),
        ("/minutes", json!(-1)),
        ("/extra", json!(1)),
        ("/steps", json!([])),
        ("/steps/0", json!([])),
        ("/steps/0/text", json!([])),
        ("/steps/0/text/0", json!("")),
        ("/steps/0/show/0", json!("everything")),
        ("/steps/0/extra", json!(1)),
        ("/steps/0/scene/map/0", json!("..x.")),
        ("/steps/0/time", json!(99_999)),
        ("/steps/1/tools/0", json!("hammer")),
        ("/steps/1/edits", json!(0)),
        ("/steps/1/cells/0", json!([1])),
        ("/steps/1/task/kind", json!("dance")),
        ("/steps/1/task/extra", json!(1)),
        ("/steps/1/task/until/is", json!("nice")),
        ("/steps/1/task/until/compare", json!("<")),
        ("/steps/1/task/until/extra", json!(1)),
        ("/steps/1/task/say", Value::Null),
        ("/steps/2/task/what/is", json!("weather")),
        ("/steps/2/task/what/robot", Value::Null),
        ("/steps/2/task/answers/0/value", json!(1.5)),
        ("/steps/2/task/answers/0/reply", Value::Null),
        ("/steps/3/task/answers", json!([])),
        ("/steps/3/task/answers/0/claim/is", json!("true")),
        ("/steps/4/task/robots", json!([])),
        ("/steps/4/task/aim/objective", json!([])),
        ("/steps/5/task/find", json!("something")),
        ("/steps/6/task/methods/0", json!("guess")),
        ("/steps/6/task/changes/changes/0/change", json!("dance")),
        ("/steps/6/task/cost/at-most", Value::Null),
        ("/steps/7/hints", json!(["a", "b", "c", "d"])),
        ("/steps/7/plan/paths/A1/0", json!(3)),
    ];
    for (pointer, bad) in broken {
        let mut value = full();
        let (object, key) = pointer.rsplit_once('/').unwrap();
        let object = value.pointer_mut(object).unwrap();
        if let Value::Array(list) = object {
            list[key.parse::<usize>().unwrap()] = bad.clone();
        } else if bad.is_null() {
            object.as_object_mut().unwrap().remove(key).unwrap();
        } else {
            object[key] = bad.clone();
        }
        assert_eq!(both(&value), (false, false), "{pointer} = {bad}");
    }
}

/// A place of the full lesson, what is put there, and the place of the fault.
type Misfit = (&'static str, Value, &'static str);

fn misfits() -> Vec<Misfit> {
    vec![
        (
            "/steps/0/text/0",
            json!("See [A9](robot:A9)."),
            "steps[0].text[0]",
        ),
        (
            "/steps/0/text/0",
            json!("At [here](cell:9,9)."),
            "steps[0].text[0]",
        ),
        (
            "/steps/0/text/0",
            json!("A [thing](term:thing)."),
            "steps[0].text[0]",
        ),
        (
            "/steps/0/text/0",
            json!("A <b>bold</b> word."),
            "steps[0].text[0]",
        ),
        (
            "/steps/0/text/0",
            json!("An *open word."),
            "steps[0].text[0]",
        ),
        (
            "/steps/0/scene/agents/0/goal",
            json!([9, 9]),
            "steps[0].scene.agents[0].goal",
        ),
        ("/steps/1/cells/0", json!([9, 9]), "steps[1].cells[0]"),
        ("/steps/1/tools", json!([]), "steps[1]"),
        (
            "/steps/1/task/say",
            json!("See [A9](robot:A9)."),
            "steps[1].task.say",
        ),
        (
            "/steps/1/task/say",
            json!("[A9](dog:A9)"),
            "steps[1].task.say",
        ),
        (
            "/steps/1/task/until/cost",
            json!("waits"),
            "steps[1].task.until.cost",
        ),
        ("/steps/1/task/until/value", json!("four"), "steps[1].task"),
        (
            "/steps/2/task/what/robot",
            json!("A9"),
            "steps[2].task.what.robot",
        ),
        (
            "/steps/2/task/answers/0/value",
            json!("A1"),
            "steps[2].task.answers[0].value",
        ),
        (
            "/steps/2/task/answers/0/value",
            json!(4),
            "steps[2].task.answers[1].value",
        ),
        (
            "/steps/2/task/answers/0/extra",
            json!(4),
            "steps[2].task.answers[0]",
        ),
        (
            "/steps/3/task/answers/0/right",
            json!(false),
            "steps[3].task.answers",
        ),
        (
            "/steps/3/task/answers/1/text",
            json!("[x](time:x)"),
            "steps[3].task.answers[1].text",
        ),
        (
            "/steps/4/task/robots/0",
            json!("A9"),
            "steps[4].task.robots[0]",
        ),
        ("/steps/6/task/kept", json!(3), "steps[6].task.kept"),
        (
            "/steps/7/plan/paths/A1",
            json!([[0, 0], [1, 0], [2, 0], [3, 0]]),
            "steps[7].plan",
        ),
        ("/steps/7/hints", json!([]), "steps[7].hints"),
    ]
}

/// What only the reader can see, each with the place that it names.
#[test]
fn the_reader_also_sees_what_belongs_together() {
    for (pointer, bad, place) in misfits() {
        let mut value = full();
        let (object, key) = pointer.rsplit_once('/').unwrap();
        match value.pointer_mut(object).unwrap() {
            Value::Array(list) => list[key.parse::<usize>().unwrap()] = bad.clone(),
            object => object[key] = bad.clone(),
        }
        let text = serde_json::to_string_pretty(&value).unwrap();
        let faults = read_lesson(&text, &shipped::glossary()).unwrap_err();
        let found = faults.iter().find(|fault| fault.place.starts_with(place));
        let found = found.unwrap_or_else(|| panic!("{pointer} = {bad}: {faults:?}"));
        assert!(found.line.is_some_and(|line| line > 1), "{found}");
    }
}
