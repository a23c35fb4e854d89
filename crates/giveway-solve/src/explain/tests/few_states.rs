//! Questions about few robots on small maps that SAT finds hard: their joint states are
//! exhausted, under the limits that a question sets.

use giveway_model::{Instance, Objective, Plan, Question};

use super::read;
use crate::{
    Limits, Request, Response, SilentHost,
    explain::{Class, ExplainAnswer, ExplainRequest, Verdict, unsolvable::of_class},
    serve,
};

pub(super) fn asked(
    instance: &Instance,
    (plan, question): (Option<Plan>, Question),
    objective: &str,
    within: Option<u32>,
) -> ExplainAnswer {
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan,
        question,
        changes: None,
        at: None,
        objective: Some(objective.parse::<Objective>().unwrap()),
        within,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits {
            conflicts: Some(30_000),
            ..Limits::default()
        },
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

fn fewer_moves(texts: (&str, &str), objective: &str, within: u32) -> ExplainAnswer {
    let (instance, plan) = read(texts.0, texts.1);
    let question = Question::Moves { agent: None };
    asked(&instance, (Some(plan), question), objective, Some(within))
}

/// The limit is on the first cost, so the best plan of all keeps it.
#[test]
fn fewer_moves_where_moves_come_first() {
    let instance = r#"{ "giveway": 1,
        "map": [".+..", ".#..", ".##.", ".#+.", "+##.", "+##.", "...."],
        "agents": [
            { "name": "A1", "start": [1, 6], "goal": [3, 1], "waypoints": [[0, 2]],
              "battery": { "capacity": 4, "initial": 3 } },
            { "name": "A2", "start": [0, 5], "goal": [0, 4],
              "battery": { "capacity": 7, "initial": 2 } }] }"#;
    let plan = r#"{ "giveway": 1, "paths": {
        "A1": [[1,6],[0,6],[0,5],[0,4],[0,3],[0,2],[0,1],[0,0],[1,0],[2,0],[3,0],[3,1]],
        "A2": [[0,5],[0,5],[0,4],[0,3],[0,2],[0,1],[0,0],[1,0],[2,0],[2,1],[2,0],[1,0],[1,0],
               [0,0],[0,1],[0,0],[0,1],[0,2],[0,3],[0,4]] },
        "charges": { "A1": [3, 8], "A2": [2, 7, 11] } }"#;
    let answer = fewer_moves((instance, plan), "moves,sum-of-costs", 200);
    assert_eq!(answer.verdict, Verdict::Improvable);
    assert!(answer.reach.is_complete(), "{answer:?}");
}

/// The limit is on a later cost: what is used of it is part of the joint states.
#[test]
fn fewer_moves_where_waits_come_first() {
    let instance = r#####"{ "giveway": 1,
        "map": ["+....", ".#.#.", "####+", ".###+", ".###+", "....."],
        "agents": [
            { "name": "A1", "start": [2, 5], "goal": [4, 1], "waypoints": [[2, 5]],
              "battery": { "capacity": 7, "initial": 5 } },
            { "name": "A2", "start": [3, 5], "goal": [0, 5], "waypoints": [[4, 5]],
              "battery": { "capacity": 8, "initial": 2 } }] }"#####;
    let plan = r#"{ "giveway": 1, "paths": {
        "A1": [[2,5],[3,5],[4,5],[4,4],[4,5],[4,4],[4,3],[4,2],[4,1],[4,0],[3,0],[2,0],[2,1],
               [2,0],[1,0],[0,0],[1,0],[2,0],[3,0],[4,0],[4,1]],
        "A2": [[3,5],[4,5],[4,4],[4,3],[4,2],[4,1],[4,0],[3,0],[2,0],[1,0],[0,0],[1,0],[2,0],
               [3,0],[4,0],[4,1],[4,2],[4,3],[4,4],[4,5],[3,5],[2,5],[1,5],[0,5]] },
        "charges": { "A1": [5, 7, 15], "A2": [2, 10, 18] } }"#;
    let objective = "waits,moves,makespan,sum-of-costs,charges";
    let answer = fewer_moves((instance, plan), objective, 26);
    assert_eq!(answer.verdict, Verdict::Costly);
    assert!(answer.reach.is_complete(), "{answer:?}");
}

/// Leaving out two waypoints is enough, though SAT does not find the plan soon.
#[test]
fn the_fewest_waypoints_that_are_skipped() {
    let instance = r##"{ "giveway": 1, "map": ["#~.~~"], "rules": { "battery_floor": 1 },
        "agents": [
            { "name": "A1", "start": [1, 0], "goal": [1, 0], "waypoints": [[4, 0], [3, 0]] },
            { "name": "A2", "start": [2, 0], "goal": [2, 0], "waypoints": [[1, 0]] }] }"##;
    let instance = giveway_model::format::native::read_instance(instance).unwrap();
    let answer = asked(
        &instance,
        (None, Question::Unsolvable),
        "moves,makespan",
        None,
    );
    assert_eq!(answer.verdict, Verdict::Necessary);
    assert_eq!(of_class(&answer.witness, Class::Waypoint).len(), 2);
}
