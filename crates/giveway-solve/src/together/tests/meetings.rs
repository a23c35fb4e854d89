//! Where agents can be, and where they collide.

use giveway_model::{Cell, Cost};
use serde_json::json;

use super::{CROSSING, LANE, limit, request, told};
use crate::{
    Request, Response, SilentHost, SolveRequest, Status, serve,
    together::MeetingKind,
    trace::{AgentLimit, SearchEvent},
};

#[test]
fn on_time_both_have_to_be_in_the_middle() {
    let both = [limit("A", 2, 2), limit("B", 2, 2)];
    let answer = told(request(CROSSING, Cost::SumOfCosts, &both));
    let cells = json!([
        { "cell": [0, 1], "first": 0, "last": 0 },
        { "cell": [1, 1], "first": 1, "last": 1 },
        { "cell": [2, 1], "first": 2, "last": 2 },
    ]);
    let regions = serde_json::to_value(&answer.regions).unwrap();
    assert_eq!(regions[0], json!({ "agent": "A", "by": 2, "cells": cells }));
    let meetings = serde_json::to_value(&answer.meetings).unwrap();
    assert_eq!(
        meetings,
        json!([{ "agents": ["A", "B"], "time": 1, "kind": "vertex", "cell": [1, 1] }])
    );
    let passes = serde_json::to_value(&answer.passes).unwrap();
    assert_eq!(
        passes,
        json!([
            { "agent": "A", "cell": [1, 1], "time": 1, "rests": false },
            { "agent": "B", "cell": [1, 1], "time": 1, "rests": false },
        ])
    );
    let alone = answer.alone.unwrap();
    assert_eq!(alone.refuted, Some(true));
    assert_eq!(alone.solved.status, Status::Optimal);
    assert_eq!(alone.solved.costs.unwrap().sum_of_costs, 5);
    let events = alone.solved.trace.unwrap().events;
    let texts: Vec<&str> = events.iter().map(|event| event.text.as_str()).collect();
    assert_eq!(
        texts[0],
        "Each robot alone, by its fastest way: sum of costs at least 4."
    );
    assert_eq!(
        texts[2..],
        [
            "A and B join the proof: they get in each other's way.",
            "No plan has less than sum of costs 5.",
            "Plan and bound meet: sum of costs 5. No plan is better.",
        ]
    );
}

#[test]
fn one_step_more_is_enough() {
    let late = [limit("A", 2, 3), limit("B", 2, 2)];
    let answer = told(request(CROSSING, Cost::SumOfCosts, &late));
    assert_eq!(answer.meetings, []);
    assert_eq!(answer.passes, []);
    // A may wait at first, in the middle, or before its goal.
    let times: Vec<(u32, u32)> = answer.regions[0]
        .cells
        .iter()
        .map(|times| (times.first, times.last))
        .collect();
    assert_eq!(times, [(0, 1), (1, 2), (2, 3)]);
    assert_eq!(answer.alone.unwrap().refuted, Some(false));
}

#[test]
fn in_a_lane_they_swap() {
    let both = [limit("A", 3, 3), limit("B", 3, 3)];
    let answer = told(request(LANE, Cost::Makespan, &both));
    let [meeting] = answer.meetings.as_slice() else {
        panic!("{:?}", answer.meetings);
    };
    let edge = [Cell::new(1, 1), Cell::new(2, 1)];
    assert_eq!(meeting.kind, MeetingKind::Swap { edge });
    assert_eq!(meeting.time, 1);
    assert_eq!(answer.passes.len(), 4);
    assert_eq!(answer.alone.unwrap().refuted, Some(true));
}

/// The step that `docs/trace.md` looks at.
#[test]
fn who_leaves_a_bay_swaps_with_who_comes_in() {
    let door = r#"{
        "giveway": 1,
        "map": ["...#.", ".....", ".##.."],
        "agents": [
            { "name": "A", "start": [0, 2], "goal": [2, 0] },
            { "name": "B", "start": [0, 1], "goal": [0, 2] },
            { "name": "C", "start": [4, 2], "goal": [0, 1] }
        ]
    }"#;
    let both = [limit("A", 4, 4), limit("B", 1, 1)];
    let answer = told(request(door, Cost::SumOfCosts, &both));
    let meetings = serde_json::to_value(&answer.meetings).unwrap();
    let edge = json!([[0, 2], [0, 1]]);
    assert_eq!(
        meetings,
        json!([{ "agents": ["A", "B"], "time": 0, "kind": "swap", "edge": edge }])
    );
    assert_eq!(answer.alone.unwrap().refuted, Some(true));
}

#[test]
fn a_slow_swap_has_the_times_of_both() {
    let scene = r#"{
        "giveway": 1,
        "map": [".~~."],
        "agents": [
            { "name": "A", "start": [0, 0], "goal": [2, 0] },
            { "name": "B", "start": [3, 0], "goal": [1, 0] }
        ]
    }"#;
    let alone = serve(
        &Request::Solve(SolveRequest {
            scene: super::scene(&scene.replace("\"agents\"", "\"name\": \"x\", \"agents\"")),
            trace: true,
            ..SolveRequest::default()
        }),
        &SilentHost,
    );
    let Response::Solved(solved) = alone else {
        panic!("{alone:?}");
    };
    let events = solved.trace.unwrap().events;
    let SearchEvent::Alone { agents, .. } = &events[0].event else {
        panic!("{events:?}");
    };
    let both: Vec<AgentLimit> = agents
        .iter()
        .map(|own| limit(&own.agent, own.least, own.least))
        .collect();
    let answer = told(request(scene, Cost::Makespan, &both));
    let [meeting] = answer.meetings.as_slice() else {
        panic!("{:?}", answer.meetings);
    };
    assert!(
        matches!(meeting.kind, MeetingKind::Swap { .. }),
        "{meeting:?}"
    );
    let spans = answer
        .passes
        .chunks(2)
        .map(|pair| pair[1].time - pair[0].time);
    assert_eq!(spans.collect::<Vec<u32>>(), [2, 2], "{:?}", answer.passes);
    assert_eq!(answer.alone.unwrap().refuted, Some(true));
}

#[test]
fn one_that_rests_is_in_the_way() {
    let scene = r##"{
        "giveway": 1,
        "map": ["#.####", "......"],
        "agents": [
            { "name": "B", "start": [0, 1], "goal": [5, 1] },
            { "name": "A", "start": [1, 0], "goal": [1, 1] }
        ]
    }"##;
    let both = [limit("B", 5, 5), limit("A", 1, 1)];
    let answer = told(request(scene, Cost::SumOfCosts, &both));
    let meetings = serde_json::to_value(&answer.meetings).unwrap();
    assert_eq!(
        meetings,
        json!([{ "agents": ["A", "B"], "time": 1, "kind": "target", "cell": [1, 1] }])
    );
    assert!(
        answer
            .passes
            .iter()
            .any(|pass| pass.agent == "A" && pass.rests)
    );
    // Who vanishes is there at that time, and is in the way all the same; a step later
    // it is not.
    let gone = scene.replace("\"map\"", r#""rules": { "at_goal": "vanish" }, "map""#);
    let late = [limit("B", 5, 6), limit("A", 1, 1)];
    let answer = told(request(&gone, Cost::SumOfCosts, &late));
    assert_eq!(answer.meetings, []);
    assert_eq!(answer.alone.unwrap().refuted, Some(false));
}
