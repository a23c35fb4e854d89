//! Limits that agents can keep together or cannot, and faults in them.

use giveway_model::Cost;

use super::{CROSSING, LANE, limit, refuted, request, scene, told};
use crate::{
    Refusal, Request, Response, SilentHost, SolveRequest, Status, serve,
    together::TogetherRequest,
    trace::{AgentLimit, SearchEvent},
};

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
