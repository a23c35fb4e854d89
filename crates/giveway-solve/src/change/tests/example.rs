//! The 3 x 3 example of the literature: Bogatarkan (2021), from
//! `data/seed` of the workspace's tests.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

use giveway_model::{Cell, Plan, check::check_changes, format::native};

use crate::{
    Limits, Request, Response, SilentHost, Status,
    change::{ChangeAnswer, ChangeRequest, Method},
    serve,
};

const SCENE: &str = include_str!("../../../../../tests/data/seed/dynamic-3x3.json");
const PLAN: &str = include_str!("../../../../../tests/data/seed/dynamic-3x3.plan.json");
const LATER: &str = include_str!("../../../../../tests/data/seed/dynamic-3x3.plan-t1.json");
const CHANGES: &str = include_str!("../../../../../tests/data/seed/dynamic-3x3.changes.json");

fn go_on(plan: &str) -> ChangeAnswer {
    match answered(plan, CHANGES, None) {
        Response::Changed(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

fn answered(plan: &str, changes: &str, since: Option<u32>) -> Response {
    let request = ChangeRequest {
        scene: native::read_scene(SCENE).unwrap(),
        plan: native::read_plan(plan).unwrap(),
        changes: native::read_changes(changes).unwrap(),
        since,
        methods: vec![
            Method::Revise,
            Method::Tunnel(0),
            Method::Tunnel(1),
            Method::Replan,
        ],
        objective: None,
        within: None,
        limits: Limits::default(),
    };
    serve(&Request::Change(request), &SilentHost)
}

fn makespan(answer: &ChangeAnswer, method: Method) -> u32 {
    let answer = answer.methods.get(method).unwrap();
    assert_eq!(answer.result.status, Status::Optimal);
    assert!(
        answer.result.reach.is_complete() && answer.closest,
        "{answer:?}"
    );
    assert!(answer.freed.is_empty() && answer.cause.is_none());
    answer.result.costs.unwrap().makespan
}

/// The cells by their numbers in the paper, from 1, row by row.
fn numbers(plan: &Plan, agent: &str) -> Vec<u32> {
    let number = |cell: &Option<Cell>| cell.map_or(0, |cell| cell.y * 3 + cell.x + 1);
    plan.path(agent).iter().map(number).collect()
}

#[test]
fn reuse_costs_a_step() {
    let answer = go_on(LATER);
    assert_eq!(answer.at, Some(2));
    assert!(answer.history.is_empty(), "the plan knows the first change");
    assert_eq!(makespan(&answer, Method::Revise), 5);
    assert_eq!(makespan(&answer, Method::Replan), 4);
    assert_eq!(answer.adopted, Some(Method::Revise));
    let plan = answer.adopted().unwrap().result.plan.clone().unwrap();
    // The only plan of makespan 5; all but A4 from time 0.
    assert_eq!(numbers(&plan, "A1"), [1, 2, 3, 3, 6, 9]);
    assert_eq!(numbers(&plan, "A2"), [3, 6, 5, 5, 4, 7]);
    assert_eq!(numbers(&plan, "A3"), [9, 6, 6, 5, 2]);
    assert_eq!(numbers(&plan, "A4"), [7, 4, 1, 1][..3]);
    assert_eq!(plan.from["A3"], 1);
    assert_eq!(plan.from["A4"], 2);
}

#[test]
fn both_changes_from_the_beginning() {
    let answer = go_on(PLAN);
    let first = &answer.history[0];
    assert_eq!((first.at, first.adopted), (1, Some(Method::Revise)));
    let revised = first.methods.get(Method::Revise).unwrap();
    assert_eq!(revised.result.costs.unwrap().makespan, 4);
    assert_eq!(revised.kept, ["A1", "A2"]);
    assert_eq!(revised.added, ["A3"]);
    let instance = native::read_instance(SCENE).unwrap();
    let changes = native::read_changes(CHANGES).unwrap();
    for (_, method) in &answer.methods.0 {
        let plan = method.result.plan.as_ref().unwrap();
        let report = check_changes(&instance, &changes, plan).unwrap();
        assert!(report.is_valid());
        assert_eq!(report.costs, method.result.costs);
    }
}

#[test]
fn a_plan_that_stays_valid_may_have_been_adopted_after_a_change() {
    let changes = r#"{ "giveway": 1, "changes": [
        { "at": 1, "change": "add-charger", "cell": [1, 2] },
        { "at": 2, "change": "add-charger", "cell": [1, 0] }] }"#;
    let earlier = |since| -> Vec<u32> {
        match answered(PLAN, changes, since) {
            Response::Changed(answer) => answer.history.iter().map(|step| step.at).collect(),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(earlier(None), [1]);
    assert!(earlier(Some(2)).is_empty());
    assert_eq!(earlier(Some(1)), [1]);
    let refused = answered(LATER, CHANGES, Some(1));
    assert!(matches!(refused, Response::Refused(_)), "{refused:?}");
}
