//! Agents asked about by themselves: where they can be, where they collide, and whether
//! they can keep their limits.

use giveway_model::{Cell, Cost, Scene, format::native};
use serde_json::json;

use super::{MeetingKind, TogetherAnswer, TogetherRequest};
use crate::{
    Limits, Refusal, Request, Response, SilentHost, SolveRequest, Status, serve,
    trace::{AgentLimit, SearchEvent},
};

const CROSSING: &str = r##"{
    "giveway": 1,
    "map": ["#.#", "...", "#.#"],
    "objective": ["sum-of-costs", "makespan"],
    "agents": [
        { "name": "A", "start": [0, 1], "goal": [2, 1] },
        { "name": "B", "start": [1, 0], "goal": [1, 2] }
    ]
}"##;

/// A lane of two cells between two rooms, passed both ways at once.
const LANE: &str = r#"{
    "giveway": 1,
    "map": [".##.", "....", ".##."],
    "agents": [
        { "name": "A", "start": [0, 1], "goal": [3, 1] },
        { "name": "B", "start": [3, 1], "goal": [0, 1] }
    ]
}"#;

fn scene(text: &str) -> Scene {
    native::read_scene(text).unwrap()
}

fn limit(agent: &str, least: u32, at_most: u32) -> AgentLimit {
    AgentLimit {
        agent: agent.to_owned(),
        least,
        at_most,
    }
}

fn request(scene: &str, cost: Cost, agents: &[AgentLimit]) -> TogetherRequest {
    TogetherRequest {
        scene: self::scene(scene),
        cost,
        agents: agents.to_vec(),
        more: None,
        within: None,
        limits: Limits::default(),
    }
}

fn told(request: TogetherRequest) -> TogetherAnswer {
    match serve(&Request::Together(request), &SilentHost) {
        Response::Together(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

fn refuted(request: TogetherRequest) -> Option<bool> {
    told(request).alone.unwrap().refuted
}

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
fn together_they_may_have_less_than_each() {
    let each = [limit("A", 2, 3), limit("B", 2, 3)];
    for (more, expected) in [(0, true), (1, false)] {
        let asked = TogetherRequest {
            more: Some(more),
            ..request(CROSSING, Cost::SumOfCosts, &each)
        };
        assert_eq!(refuted(asked), Some(expected), "{more}");
    }
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
            scene: self::scene(&scene.replace("\"agents\"", "\"name\": \"x\", \"agents\"")),
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

#[test]
fn limits_of_counts_have_no_regions() {
    let no_waits = [limit("A", 0, 0), limit("B", 0, 0)];
    let answer = told(request(CROSSING, Cost::Waits, &no_waits));
    assert!(answer.regions.is_empty() && answer.meetings.is_empty());
    let few_moves = [limit("A", 2, 2), limit("B", 2, 2)];
    assert_eq!(
        refuted(request(CROSSING, Cost::Moves, &few_moves)),
        Some(false)
    );
    let within = TogetherRequest {
        within: Some(2),
        ..request(CROSSING, Cost::Moves, &few_moves)
    };
    assert_eq!(refuted(within), Some(true));
}

#[test]
fn a_limit_below_the_least_is_refuted() {
    let low = [limit("A", 2, 1)];
    let answer = told(request(CROSSING, Cost::SumOfCosts, &low));
    assert!(answer.regions[0].cells.is_empty());
    assert_eq!(answer.alone.unwrap().refuted, Some(true));
}

#[test]
fn the_core_of_a_trace_is_asked_about() {
    let solve = Request::Solve(SolveRequest {
        scene: scene(LANE),
        trace: true,
        ..SolveRequest::default()
    });
    let Response::Solved(solved) = serve(&solve, &SilentHost) else {
        panic!("not solved");
    };
    let mut cores = 0;
    for event in solved.trace.unwrap().events {
        if let SearchEvent::Core(core) = event.event {
            cores += 1;
            let asked = TogetherRequest::about(&core, scene(LANE));
            assert_eq!(refuted(asked), Some(true), "{core:?}");
        }
    }
    assert!(cores > 1);
}

#[test]
fn what_is_spent_settles_nothing() {
    let both = [limit("A", 2, 2), limit("B", 2, 2)];
    let mut asked = request(CROSSING, Cost::SumOfCosts, &both);
    asked.limits.seconds = Some(0.0);
    let alone = told(asked).alone.unwrap();
    assert_eq!(alone.refuted, None);
    assert_eq!(alone.solved.status, Status::Unknown);
}

#[test]
fn agents_are_named_once() {
    let faults = |agents: &[AgentLimit]| {
        let asked = Request::Together(request(CROSSING, Cost::SumOfCosts, agents));
        match serve(&asked, &SilentHost) {
            Response::Refused(Refusal::Request { fault }) => fault.to_string(),
            other => panic!("{other:?}"),
        }
    };
    let a = limit("A", 2, 2);
    assert_eq!(
        faults(&[a.clone(), limit("C", 2, 2)]),
        "agents[1].agent: found \"C\", expected the name of a robot"
    );
    assert_eq!(
        faults(&[a.clone(), a]),
        "agents[1].agent: found \"A\" again, expected each robot once"
    );
    assert_eq!(faults(&[]), "agents: found none, expected a robot or more");
}

/// Limits that no plan comes near bind nothing, however large they are.
#[test]
fn limits_beyond_every_plan_are_none() {
    let most = u32::MAX;
    for cost in [Cost::SumOfCosts, Cost::Waits, Cost::Moves, Cost::Makespan] {
        let wide = [limit("A", 2, most), limit("B", 2, most)];
        assert_eq!(refuted(request(CROSSING, cost, &wide)), Some(false));
        let tight = [limit("A", 2, 3), limit("B", 2, 3)];
        let mut asked = request(CROSSING, cost, &tight);
        asked.more = Some(most);
        assert_eq!(refuted(asked), Some(false), "{cost:?}");
    }
}

/// A horizon that no search can reach ends with the budget.
#[test]
fn a_horizon_beyond_every_table_ends_with_the_budget() {
    let wide = [limit("A", 2, u32::MAX), limit("B", 2, u32::MAX)];
    let mut asked = request(CROSSING, Cost::SumOfCosts, &wide);
    asked.within = Some(u32::MAX);
    asked.limits.work = Some(300_000);
    let answer = told(asked);
    assert!(answer.regions.is_empty());
}
