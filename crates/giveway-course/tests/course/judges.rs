//! The judges on small scenes: each condition, quantity and aim, each way to be outside.

use giveway_course::judge::words::said;
use giveway_course::judge::{
    Did, Judging, Kind, Outside, Situation, Verdict, Why, begin, conclude,
};
use giveway_course::lesson::{Lesson, Step, Value, read_lesson};
use giveway_model::{Agent, Cell, Path, Plan, Scene};
use giveway_solve::{SilentHost, serve};
use serde_json::{Value as Json, json};

use super::shipped;

/// A lesson of one step with a task.
pub(crate) fn lesson(scene: &Json, step: &Json, task: &Json) -> Lesson {
    let mut whole = json!({
        "title": "Step", "text": ["Text."], "scene": scene, "hints": ["Hint."], "reason": "Reason.",
    });
    for (key, value) in step.as_object().unwrap() {
        whole[key] = value.clone();
    }
    whole["task"] = task.clone();
    whole["task"]["say"] = json!("Do it.");
    let lesson = json!({
        "giveway": 1, "title": "T", "minutes": 4, "about": "About.", "steps": [whole],
    });
    read_lesson(&lesson.to_string(), &shipped::glossary()).unwrap()
}

pub(crate) fn scene(map: &[&str], agents: &[(&str, [u32; 2], [u32; 2])]) -> Json {
    let agents: Vec<Json> = agents
        .iter()
        .map(|(name, start, goal)| json!({ "name": name, "start": start, "goal": goal }))
        .collect();
    json!({ "giveway": 1, "map": map, "agents": agents })
}

fn crossing() -> Json {
    scene(
        &["#.#", "...", "#.#"],
        &[("A1", [0, 1], [2, 1]), ("A2", [1, 2], [1, 0])],
    )
}

pub(crate) fn judged(lesson: &Lesson, scene: &Scene, did: &Did) -> Verdict {
    let step: &Step = &lesson.steps[0];
    let situation = Situation {
        step,
        start: step.scene.as_ref().unwrap(),
        scene,
    };
    match begin(situation, did).unwrap() {
        Judging::Verdict(verdict) => *verdict,
        Judging::Ask(requests) => {
            let responses: Vec<_> = requests.iter().map(|r| serve(r, &SilentHost)).collect();
            conclude(situation, did, &responses).unwrap()
        }
    }
}

/// What is said of what was done on a board.
fn told(lesson: &Lesson, verdict: &Verdict) -> String {
    let said = said(verdict, &lesson.steps[0]);
    format!("{}: {}", said.head, said.text.plain())
}

pub(crate) fn painted(lesson: &Lesson, change: impl FnOnce(&mut Scene)) -> (Verdict, String) {
    let mut scene = lesson.steps[0].scene.clone().unwrap();
    change(&mut scene);
    let verdict = judged(lesson, &scene, &Did::Edits);
    let told = told(lesson, &verdict);
    (verdict, told)
}

fn set(x: usize, y: usize, ground: &'static str) -> impl FnOnce(&mut Scene) {
    move |scene| scene.map[y].replace_range(x..=x, ground)
}

/// The truth of a quantity, by a guess that it never is.
fn truth(scene: &Json, what: &Json) -> Why {
    let lesson = lesson(
        scene,
        &json!({}),
        &json!({ "kind": "predict", "what": what }),
    );
    let start = lesson.steps[0].scene.clone().unwrap();
    let guess = Did::Guessed(Value::Robot("nobody".into()));
    judged(&lesson, &start, &guess).why
}

#[track_caller]
fn is_truth(scene: &Json, what: &Json, wanted: &Value) {
    match truth(scene, what) {
        Why::Guessed { truth, .. } => assert_eq!(truth, *wanted),
        other => panic!("{other:?}"),
    }
}

#[test]
fn quantities_are_those_of_every_best_plan() {
    let lane = scene(&["....", "#.##"], &[("A1", [0, 0], [3, 0])]);
    is_truth(
        &lane,
        &json!({ "is": "arrival", "robot": "A1" }),
        &Value::Number(3),
    );
    let place = |time: u32| json!({ "is": "place", "robot": "A1", "time": time });
    is_truth(&lane, &place(1), &Value::Cell(Cell::new(1, 0)));
    is_truth(&lane, &place(9), &Value::Cell(Cell::new(3, 0)));
    is_truth(&lane, &json!({ "is": "plans" }), &Value::Number(1));
    is_truth(&crossing(), &json!({ "is": "plans" }), &Value::Number(2));
    // A1 can only wait: A2 comes through its cell's only neighbour.
    let bay = scene(
        &["#.##", "...."],
        &[("A1", [0, 1], [3, 1]), ("A2", [3, 1], [1, 0])],
    );
    is_truth(
        &bay,
        &json!({ "is": "cost", "cost": "makespan" }),
        &Value::Number(5),
    );
}

#[test]
fn what_best_plans_differ_in_is_no_truth() {
    let waits = json!({ "is": "waits" });
    assert_eq!(truth(&crossing(), &waits), Why::Differs);
    let arrival = json!({ "is": "arrival", "robot": "A1" });
    assert_eq!(truth(&crossing(), &arrival), Why::Differs);
    let middle = json!({ "is": "place", "robot": "A1", "time": 1 });
    assert_eq!(truth(&crossing(), &middle), Why::Differs);
}

#[test]
fn the_one_that_waits_is_named() {
    // A2 has the shorter way and comes first; A1 is late in any case.
    let scene = json!({ "giveway": 1, "map": ["#.##", "....", "#.##"], "objective": ["sum-of-costs"],
        "agents": [{ "name": "A1", "start": [1, 2], "goal": [1, 0] },
                   { "name": "A2", "start": [0, 1], "goal": [3, 1], "battery": { "capacity": 3, "initial": 3 } }] });
    is_truth(
        &scene,
        &json!({ "is": "waits" }),
        &Value::Robot("A1".into()),
    );
}

#[test]
fn a_condition_that_is_raised_counts_from_the_start() {
    let lane = scene(&["...", "..."], &[("A1", [0, 0], [2, 0])]);
    let raised = |by: u32| {
        let until = json!({ "is": "raised", "cost": "makespan", "by": by });
        let task = json!({ "kind": "paint", "until": until });
        lesson(&lane, &json!({ "tools": ["obstacle"] }), &task)
    };
    assert!(painted(&raised(2), set(1, 0, "#")).0.is_solved());
    let (verdict, told) = painted(&raised(1), set(1, 0, "#"));
    assert_eq!(verdict.kind, Kind::NotYet);
    assert_eq!(
        told,
        "Not yet: the best makespan went from 2 to 4; 3 is asked for."
    );
    let (_, told) = painted(&raised(1), set(1, 1, "#"));
    assert_eq!(told, "Not yet: the best makespan is still 2.");
}

#[test]
fn edits_outside_of_the_task_are_not_like_this() {
    let step = json!({ "tools": ["obstacle"], "edits": 1, "cells": [[0, 0], [2, 0]] });
    let task = json!({ "kind": "paint", "until": { "is": "solvable" } });
    let open = scene(&["...", "..."], &[("A1", [0, 1], [2, 1])]);
    let lesson = lesson(&open, &step, &task);
    let outside = |change: fn(&mut Scene)| {
        let (verdict, _) = painted(&lesson, change);
        assert_eq!(verdict.kind, Kind::NotLikeThis);
        verdict.why
    };
    let cell = |x, y| Why::Outside(Outside::Cell(Cell::new(x, y)));
    let robot = || Why::Outside(Outside::Robot("A1".into()));
    assert_eq!(outside(|scene| scene.map[0] = ".#.".into()), cell(1, 0));
    assert_eq!(outside(|scene| scene.map[0] = "+..".into()), cell(0, 0));
    assert_eq!(outside(|scene| scene.map[0] = "~..".into()), cell(0, 0));
    assert_eq!(
        outside(|scene| scene.agents[0].start = Cell::new(0, 0)),
        robot()
    );
    assert_eq!(
        outside(|scene| scene.agents[0].goal = Some(Cell::new(2, 0))),
        robot()
    );
    assert_eq!(
        outside(|scene| scene.agents[0].waypoints = vec![Cell::new(2, 0)]),
        robot()
    );
    assert_eq!(outside(|scene| scene.agents.clear()), robot());
    assert_eq!(
        outside(|scene| scene.map.truncate(1)),
        Why::Outside(Outside::Rules)
    );
    assert_eq!(
        outside(|scene| scene.rules.battery_floor = 1),
        Why::Outside(Outside::Rules)
    );
    let added = outside(|scene| {
        let agent = Agent {
            name: "A2".into(),
            start: Cell::new(0, 0),
            goal: Some(Cell::new(2, 0)),
            waypoints: Vec::new(),
            battery: None,
            heading: None,
        };
        scene.agents.push(agent);
    });
    assert_eq!(added, Why::Outside(Outside::Robot("A2".into())));
    let (verdict, _) = painted(&lesson, |scene| scene.map[0] = "#.#".into());
    let many = Why::TooManyEdits {
        made: 2,
        allowed: 1,
    };
    assert_eq!((verdict.kind, verdict.why), (Kind::NotLikeThis, many));
    let (verdict, _) = painted(&lesson, |_| {});
    assert_eq!(verdict.why, Why::Untouched);
    assert!(painted(&lesson, set(0, 0, "#")).0.is_solved());
}

#[test]
fn a_scene_that_is_none_is_refused_with_its_reason() {
    let task = json!({ "kind": "paint", "until": { "is": "impossible" } });
    let lesson = lesson(&crossing(), &json!({ "tools": ["obstacle"] }), &task);
    let (verdict, told) = painted(&lesson, set(2, 1, "#"));
    assert_eq!(verdict.kind, Kind::NotLikeThis);
    assert!(told.contains("obstacle"), "{told}");
}

#[test]
fn a_verdict_of_a_question_can_be_painted() {
    let lane = scene(
        &["#.###", "....."],
        &[("A1", [0, 1], [4, 1]), ("A2", [4, 1], [1, 0])],
    );
    let until = json!({ "is": "verdict", "question": { "kind": "visit", "agent": "A1", "at": [2, 1] },
                        "verdict": "needless" });
    let task = json!({ "kind": "paint", "until": until });
    let lesson = lesson(&lane, &json!({ "tools": ["obstacle"] }), &task);
    let (verdict, told) = painted(&lesson, set(4, 0, "."));
    assert!(!verdict.is_solved());
    assert!(
        told.starts_with("Not yet: it is necessary, not needless."),
        "{told}"
    );
    let wide = painted(&lesson, |scene| scene.map[0] = "#....".into());
    // A1 can go above or below: the question does not fit, or its answer is needless.
    assert_ne!(wide.1, told);
}

fn led(paths: &[(&str, &[[u32; 2]])]) -> Did {
    let path = |cells: &[[u32; 2]]| -> Path {
        let cells = cells.iter().map(|[x, y]| Some(Cell::new(*x, *y)));
        cells.collect()
    };
    let paths = paths
        .iter()
        .map(|(name, cells)| ((*name).to_owned(), path(cells)));
    Did::Led(Plan {
        paths: paths.collect(),
        ..Plan::default()
    })
}

#[test]
fn only_the_robots_of_the_task_may_be_led() {
    let plan = json!({ "giveway": 1, "paths": { "A1": [[0, 1], [1, 1], [2, 1]],
                                                "A2": [[1, 2], [1, 1], [1, 0]] } });
    let task = json!({ "kind": "lead", "robots": ["A2"], "aim": { "is": "legal" } });
    let lesson = lesson(&crossing(), &json!({ "plan": plan }), &task);
    let start = lesson.steps[0].scene.clone().unwrap();
    let straight: &[[u32; 2]] = &[[0, 1], [1, 1], [2, 1]];
    let late: &[[u32; 2]] = &[[1, 2], [1, 2], [1, 1], [1, 0]];
    let verdict = judged(&lesson, &start, &led(&[("A1", straight), ("A2", late)]));
    assert!(verdict.is_solved());
    let slow: &[[u32; 2]] = &[[0, 1], [0, 1], [1, 1], [2, 1]];
    let up: &[[u32; 2]] = &[[1, 2], [1, 1], [1, 0]];
    let verdict = judged(&lesson, &start, &led(&[("A1", slow), ("A2", up)]));
    assert_eq!(verdict.why, Why::LedAnother("A1".into()));
    let verdict = judged(&lesson, &start, &led(&[("A1", straight), ("A2", up)]));
    assert_eq!(verdict.kind, Kind::NotLikeThis);
    assert_eq!(verdict.evidence.time, Some(1));
    // A step that is no step.
    let jump: &[[u32; 2]] = &[[1, 2], [1, 0]];
    let verdict = judged(&lesson, &start, &led(&[("A1", straight), ("A2", jump)]));
    assert_eq!(verdict.kind, Kind::NotLikeThis);
}

#[test]
fn an_order_may_have_to_be_the_best() {
    let lesson = lesson(
        &crossing(),
        &json!({}),
        &json!({ "kind": "order", "find": "best" }),
    );
    let start = lesson.steps[0].scene.clone().unwrap();
    let order = |names: &[&str]| Did::Ordered(names.iter().map(|n| (*n).to_owned()).collect());
    assert!(judged(&lesson, &start, &order(&["A1", "A2"])).is_solved());
    for names in [&["A1"][..], &["A1", "A1"], &["A1", "A3"]] {
        assert_eq!(judged(&lesson, &start, &order(names)).why, Why::Untouched);
    }
    assert_eq!(judged(&lesson, &start, &Did::NoOrder).why, Why::Untouched);
}

#[test]
fn no_order_is_not_said_of_a_scene_in_which_one_works() {
    let lesson = lesson(
        &crossing(),
        &json!({}),
        &json!({ "kind": "order", "find": "none" }),
    );
    let start = lesson.steps[0].scene.clone().unwrap();
    let verdict = judged(&lesson, &start, &Did::NoOrder);
    assert!(!verdict.is_solved());
    assert_eq!(
        told(&lesson, &verdict),
        "Not yet: the order A1 and A2 works."
    );
}

#[test]
fn plans_of_elsewhere_are_told_apart() {
    let plan = |a2: &[[u32; 2]]| json!({ "giveway": 1, "paths": { "A1": [[0, 1], [1, 1], [2, 1]], "A2": a2 } });
    let holds = |is: &str, a2: &[[u32; 2]]| {
        let answers = json!([
            { "text": "Yes.", "right": true, "reply": "Yes.", "claim": { "is": is } },
            { "text": "No.", "reply": "No." },
        ]);
        let task = json!({ "kind": "choose", "answers": answers });
        let lesson = lesson(&crossing(), &json!({ "plan": plan(a2) }), &task);
        let start = lesson.steps[0].scene.clone().unwrap();
        judged(&lesson, &start, &Did::Chose(0)).is_solved()
    };
    let broken = [[1, 2], [1, 1], [1, 0]];
    let best = [[1, 2], [1, 2], [1, 1], [1, 0]];
    let late = [[1, 2], [1, 2], [1, 2], [1, 1], [1, 0]];
    let found = |a2: &[[u32; 2]]| ["legal", "best", "beaten"].map(|is| holds(is, a2));
    assert_eq!(found(&broken), [false, false, false]);
    assert_eq!(found(&best), [true, true, false]);
    assert_eq!(found(&late), [true, false, true]);
}

#[test]
fn what_is_no_answer_of_the_task_is_nothing() {
    let lesson = lesson(
        &crossing(),
        &json!({}),
        &json!({ "kind": "order", "find": "works" }),
    );
    let start = lesson.steps[0].scene.clone().unwrap();
    for did in [
        Did::Edits,
        Did::Chose(9),
        Did::Guessed(Value::Number(1)),
        Did::Marked(vec![]),
    ] {
        assert_eq!(judged(&lesson, &start, &did).why, Why::Untouched);
    }
}

/// "There is no plan" is one thing, "there is none up to a horizon" another.
#[test]
fn a_claim_up_to_a_horizon_is_not_impossible() {
    let task = json!({ "kind": "paint", "until": { "is": "impossible" } });
    let lane = scene(
        &["....", "#.##"],
        &[("A1", [0, 0], [3, 0]), ("A2", [3, 0], [0, 0])],
    );
    let lesson = lesson(&lane, &json!({ "tools": ["obstacle"] }), &task);
    let mut scene = lesson.steps[0].scene.clone().unwrap();
    set(1, 1, "#")(&mut scene);
    let situation = Situation {
        step: &lesson.steps[0],
        start: lesson.steps[0].scene.as_ref().unwrap(),
        scene: &scene,
    };
    let Some(Judging::Ask(requests)) = begin(situation, &Did::Edits) else {
        panic!("nothing is asked");
    };
    let mut response = serve(&requests[0], &SilentHost);
    let solved = |response: &giveway_solve::Response| {
        let responses = std::slice::from_ref(response);
        conclude(situation, &Did::Edits, responses)
            .unwrap()
            .is_solved()
    };
    assert!(solved(&response));
    let giveway_solve::Response::Solved(answer) = &mut response else {
        panic!("{response:?}");
    };
    let within = serde_json::json!({ "complete": false, "within": 20 });
    answer.reach = serde_json::from_value(within).unwrap();
    assert!(!solved(&response));
}

/// To stand at its flag at a time in every best plan is not to arrive then.
#[test]
fn an_arrival_is_sure_where_the_step_before_is() {
    use giveway_solve::freedom::Known;
    let lane = scene(&["....", "#.##"], &[("A1", [0, 0], [3, 0])]);
    let what = json!({ "is": "arrival", "robot": "A1" });
    let lesson = lesson(
        &lane,
        &json!({}),
        &json!({ "kind": "predict", "what": what }),
    );
    let start = lesson.steps[0].scene.as_ref().unwrap();
    let situation = Situation {
        step: &lesson.steps[0],
        start,
        scene: start,
    };
    let guess = Did::Guessed(Value::Number(3));
    let Some(Judging::Ask(requests)) = begin(situation, &guess) else {
        panic!("nothing is asked");
    };
    let mut response = serve(&requests[0], &SilentHost);
    let judged = |response: &giveway_solve::Response| {
        conclude(situation, &guess, std::slice::from_ref(response)).unwrap()
    };
    assert!(judged(&response).is_solved());
    let giveway_solve::Response::Freedom(answer) = &mut response else {
        panic!("{response:?}");
    };
    let visits = answer.backbone.as_mut().unwrap().get_mut("A1").unwrap();
    let before = visits.len() - 2;
    visits[before].always = Known::No;
    assert_eq!(judged(&response).why, Why::Differs);
}
