//! A cause is named only where it is one, and what is too large is unknown.

use giveway_model::format::native;

use crate::{
    Limits, Reason, Request, Response, SilentHost, Status,
    change::{CauseKind, ChangeRequest, Method, MethodAnswer},
    serve, words,
};

fn changed(
    scene: &str,
    paths: &str,
    changes: &str,
    (method, within): (Method, Option<u32>),
) -> MethodAnswer {
    let plan = format!(r#"{{ "giveway": 1, "paths": {paths} }}"#);
    let changes = format!(r#"{{ "giveway": 1, "changes": [{changes}] }}"#);
    let request = ChangeRequest {
        scene: native::read_scene(scene).unwrap(),
        plan: native::read_plan(&plan).unwrap(),
        changes: native::read_changes(&changes).unwrap(),
        since: None,
        methods: vec![method],
        objective: None,
        within,
        limits: Limits::default(),
    };
    match serve(&Request::Change(request), &SilentHost) {
        Response::Changed(answer) => answer.methods.get(method).unwrap().clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_battery_is_the_cause_where_the_robot_could_without_one() {
    let scene = r#"{ "giveway": 1, "map": ["...#.", "...##"], "agents": [{ "name": "A1",
        "start": [0, 0], "goal": [2, 0], "battery": { "capacity": 50, "initial": 50 } }] }"#;
    let walled = r#"{ "at": 1, "change": "set-goal", "agent": "A1", "cell": [4, 0] }"#;
    let path = r#"{ "A1": [[0, 0], [1, 0], [2, 0]] }"#;
    let answer = changed(scene, path, walled, (Method::Replan, None));
    assert_eq!(answer.cause.unwrap().kind, CauseKind::NoWay);
    let weak = scene.replace("50", "3").replace("...#.", ".....");
    let answer = changed(&weak, path, walled, (Method::Replan, None));
    assert_eq!(answer.cause.unwrap().kind, CauseKind::Battery);
}

#[test]
fn an_obstacle_on_the_old_path_is_no_cause_where_any_path_may_be_taken() {
    let scene = r#"{ "giveway": 1, "map": ["....", "...."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] }] }"#;
    let wall = r#"{ "at": 1, "change": "add-obstacle", "cell": [2, 0] },
        { "at": 1, "change": "add-obstacle", "cell": [2, 1] }"#;
    let path = r#"{ "A1": [[0, 0], [1, 0], [2, 0], [3, 0]] }"#;
    let kind = |method| {
        changed(scene, path, wall, (method, None))
            .cause
            .unwrap()
            .kind
    };
    assert_eq!(kind(Method::Replan), CauseKind::NoWay);
}

#[test]
fn only_old_robots_keep_to_their_old_paths() {
    let scene = r##"{ "giveway": 1, "map": ["....", "#.##"], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [3, 0] },
        { "name": "B", "start": [3, 0], "goal": [0, 0] }] }"##;
    let paths = r#"{ "A1": [[0, 0], [1, 0], [1, 1], [1, 0], [2, 0], [3, 0]],
        "B": [[3, 0], [2, 0], [1, 0], [0, 0]] }"#;
    let joins = r#"{ "at": 1, "change": "add-agent",
        "agent": { "name": "C", "start": [1, 1], "goal": [1, 1] } }"#;
    let answer = changed(scene, paths, joins, (Method::Revise, None));
    let cause = answer.cause.unwrap();
    assert!(!cause.held.contains(&"C".to_owned()), "{cause:?}");
    let said = words::reason(&Reason::Cause(Box::new(cause)));
    assert!(!said.contains("they keep"), "{said}");
}

#[test]
fn what_is_too_large_to_plan_for_is_not_ruled_out() {
    let row = ".".repeat(26);
    let stops: Vec<String> = (1..=22).map(|x| format!("[{x}, 0]")).collect();
    let scene = format!(
        r#"{{ "giveway": 1, "map": ["{row}", "{row}"], "agents": [
            {{ "name": "A1", "start": [0, 0], "goal": [25, 0], "waypoints": [{}] }},
            {{ "name": "B1", "start": [23, 1], "goal": [23, 1], "waypoints": [[23, 0]] }}] }}"#,
        stops.join(", ")
    );
    let path: Vec<String> = (0..=25).map(|x| format!("[{x}, 0]")).collect();
    let paths = format!(
        r#"{{ "A1": [{}], "B1": [[23, 1], [23, 0], [23, 1]] }}"#,
        path.join(", ")
    );
    let delay = r#"{ "at": 1, "change": "delay-agent", "agent": "B1", "steps": 24 }"#;
    let answer = changed(&scene, &paths, delay, (Method::Revise, Some(27)));
    assert_eq!(answer.result.status, Status::Unknown, "{answer:?}");
}

#[test]
fn a_rule_on_the_old_path_is_the_cause() {
    let scene = r#"{ "giveway": 1, "map": ["....", "...."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] }],
        "zones": [{ "name": "door", "cells": [[2, 0]] }] }"#;
    let closed = r#"{ "at": 1, "change": "add-constraint", "constraint":
        { "kind": "closed", "zone": "door", "name": "people crossing" } }"#;
    let path = r#"{ "A1": [[0, 0], [1, 0], [2, 0], [3, 0]] }"#;
    let answer = changed(scene, path, closed, (Method::Revise, None));
    assert_eq!(answer.freed, ["A1"]);
    let cause = answer.cause.unwrap();
    assert_eq!(cause.kind, CauseKind::Rule);
    assert_eq!(cause.cell, Some((2, 0).into()));
    assert_eq!(cause.rule.as_ref().unwrap().index, 0);
    let told = crate::change::words::cause(&cause);
    let expected = "A1 cannot keep the rule 'people crossing' on its old path.";
    assert_eq!(told, expected);
    assert_eq!(answer.result.costs.unwrap().makespan, 5);
    // Where it closes for a while only, the robot waits.
    let for_a_while = closed.replace(r#""name""#, r#""to": 4, "name""#);
    let answer = changed(scene, path, &for_a_while, (Method::Revise, None));
    assert!(answer.freed.is_empty() && answer.cause.is_none());
    assert_eq!(answer.result.costs.unwrap().makespan, 6);
    // It cannot be closed where the goal is.
    let goal = scene.replace("[[2, 0]]", "[[3, 0]]");
    let answer = changed(&goal, path, closed, (Method::Replan, None));
    assert_eq!(answer.result.status, Status::Impossible);
    assert_eq!(answer.cause.unwrap().kind, CauseKind::Rule);
}

#[test]
fn a_rule_between_robots_is_the_cause() {
    let scene = r#"{ "giveway": 1, "map": ["....."],
        "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] },
                   { "name": "A2", "start": [4, 0], "goal": [3, 0] }] }"#;
    let apart = r#"{ "at": 0, "change": "add-constraint",
        "constraint": { "kind": "apart", "distance": 2 } }"#;
    let path = r#"{ "A1": [[0, 0], [1, 0], [2, 0]], "A2": [[4, 0], [3, 0]] }"#;
    let answer = changed(scene, path, apart, (Method::Replan, None));
    assert_eq!(answer.result.status, Status::Impossible);
    let cause = answer.cause.unwrap();
    assert_eq!((cause.kind, cause.agents.len()), (CauseKind::Blocked, 2));
    let told = crate::change::words::cause(&cause);
    let expected = "A1 and A2 cannot all arrive and keep the rule \"All robots keep 2 apart\".";
    assert_eq!(told, expected);
}
