//! The fewest agents to free, and the makespan up to which fewer were shown not to do.

use giveway_model::format::native;

use crate::{
    Limits, Request, Response, SilentHost, Status,
    change::{ChangeRequest, Method, MethodAnswer},
    serve,
};

/// A2 steps aside before A1 comes, if it is not held up.
const SCENE: &str = r#"{ "giveway": 1, "map": ["......", "......"], "agents": [
    { "name": "A1", "start": [0, 0], "goal": [5, 0] },
    { "name": "A2", "start": [3, 0], "goal": [3, 1] }] }"#;
const PLAN: &str = r#"{ "giveway": 1, "paths": {
    "A1": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]],
    "A2": [[3, 0], [3, 0], [3, 1]] } }"#;
/// A2 leaves the cell at time 8 only, so that A1 behind it arrives at time 10.
const DELAY: &str = r#"{ "giveway": 1, "changes": [
    { "at": 1, "change": "delay-agent", "agent": "A2", "steps": 6 }] }"#;

fn revised(within: Option<u32>) -> MethodAnswer {
    let request = ChangeRequest {
        scene: native::read_scene(SCENE).unwrap(),
        plan: native::read_plan(PLAN).unwrap(),
        changes: native::read_changes(DELAY).unwrap(),
        since: None,
        methods: vec![Method::Revise],
        objective: None,
        within,
        limits: Limits::default(),
    };
    match serve(&Request::Change(request), &SilentHost) {
        Response::Changed(answer) => answer.methods.get(Method::Revise).unwrap().clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn nobody_is_freed_where_there_is_time_to_wait() {
    for within in [None, Some(10)] {
        let answer = revised(within);
        assert_eq!(answer.result.status, Status::Optimal);
        assert_eq!(answer.result.costs.unwrap().makespan, 10);
        assert!(answer.freed.is_empty() && answer.fewest, "{answer:?}");
        assert_eq!(answer.fewest_within, None);
    }
}

#[test]
fn that_fewer_do_not_suffice_holds_up_to_the_horizon() {
    let answer = revised(Some(9));
    assert_eq!(answer.result.status, Status::Optimal);
    assert_eq!(answer.freed, ["A1"]);
    assert!(answer.fewest, "{answer:?}");
    // With one step more nobody has to be freed.
    assert_eq!(answer.fewest_within, Some(9));
}
