//! What is outside of a task, and what cannot be known.

use giveway_course::judge::{Did, Judging, Kind, Outside, Situation, Why, begin, conclude};
use giveway_course::lesson::Value;
use giveway_model::{Agent, Cell, Path, Plan, Scene};
use giveway_solve::{SilentHost, serve};
use serde_json::json;

use super::{crossing, judged, lesson, painted, scene, set};

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
