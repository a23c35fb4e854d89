//! Questions while a robot is broken down: what they are about begins at the change,
//! and the breakdown is one of the facts.

use giveway_model::{Plan, Question, check::Rule, format::native};

use super::rest::{Course, course, explained};
use crate::explain::{Edit, ExplainAnswer, Fact, FactKind, Verdict};

/// Two robots in opposite directions in a lane with one bay. At time 1 `b` breaks
/// down for 6 steps; `a` goes on to the bay and waits there.
fn lane() -> Course {
    course(
        r#####"{ "giveway": 1, "map": ["####.###", "........"],
            "objective": ["makespan", "sum-of-costs", "waits"], "agents": [
            { "name": "a", "start": [0, 1], "goal": [7, 1] },
            { "name": "b", "start": [7, 1], "goal": [0, 1] }] }"#####,
        r#"{ "giveway": 1, "knows": 1, "paths": {
            "a": [[0, 1], [1, 1], [2, 1], [3, 1], [4, 1], [4, 0], [4, 0], [4, 0], [4, 0],
                [4, 0], [4, 1], [5, 1], [6, 1], [7, 1]],
            "b": [[7, 1], [6, 1], [6, 1], [6, 1], [6, 1], [6, 1], [6, 1], [6, 1],
                [5, 1], [4, 1], [3, 1], [2, 1], [1, 1], [0, 1]] } }"#,
        r#"{ "at": 1, "change": "delay-agent", "agent": "b", "steps": 6 }"#,
    )
}

fn facts(answer: &ExplainAnswer) -> &[Fact] {
    answer.core.as_ref().map_or(&[], |core| &core.facts)
}

fn texts(answer: &ExplainAnswer) -> Vec<&str> {
    let facts = facts(answer).iter();
    facts.map(|fact| fact.text.as_str()).collect()
}

const BROKEN: &str = "b is broken down from time 1 to 7";

#[test]
fn a_broken_robot_waits_because_of_its_breakdown() {
    let lane = lane();
    for words in [
        "wait b",
        "wait b --from 1 --to 7",
        "wait b --from 4 --to 6",
        "waits b",
        "arrival b",
        "visit b --at 6,1 --time 5",
        "no-move b --from-cell 6,1 --to-cell 5,1 --time 3",
    ] {
        let answer = lane.ask(words);
        assert_eq!(answer.since, Some(1), "{words}");
        assert_eq!(answer.verdict, Verdict::Necessary, "{words}");
        assert!(answer.reach.is_complete(), "{words}");
        assert_eq!(texts(&answer), [BROKEN], "{words}");
        let core = answer.core.unwrap();
        assert!(core.minimal, "{words}");
        let fact = &core.facts[0];
        assert_eq!((fact.time, fact.until), (Some(1), Some(7)));
        assert_eq!(fact.kind, FactKind::Breakdown);
        assert_eq!(answer.repairs, [], "{words}");
    }
}

#[test]
fn what_would_happen_names_the_breakdown() {
    let lane = lane();
    let answer = lane.ask("wait b");
    let moved: Vec<_> = answer.witness.iter().map(|it| &it.violation).collect();
    let of_breakdown = moved.iter().filter(|it| it.rule == Rule::Move);
    assert_eq!(of_breakdown.count(), 1, "the later moves follow from it");
    assert_eq!(
        moved[0].message,
        "b leaves (6, 1) at time 1, but a breakdown keeps it there."
    );
    let words = &answer.words;
    let would = "it would have to move at time 1, but it is broken down until time 7";
    assert!(words.contains(would), "{words}");
    let words = lane.ask("wait a --from 5 --to 7").words;
    let meets = "it would meet b at (6, 1)";
    assert!(
        words.contains(meets) || words.contains("run into b"),
        "{words}"
    );
}

#[test]
fn others_wait_for_a_broken_robot() {
    let lane = lane();
    for words in ["arrival a", "makespan", "sum-of-costs"] {
        let answer = lane.ask(words);
        assert_eq!(answer.since, Some(1), "{words}");
        assert_eq!(answer.verdict, Verdict::Necessary, "{words}");
        assert!(
            texts(&answer).contains(&BROKEN),
            "{words} {:?}",
            answer.core
        );
        assert!(answer.words.contains(BROKEN), "{}", answer.words);
        // Every plan that is offered keeps to the breakdown.
        for repair in &answer.repairs {
            let gone = |edit: &Edit| matches!(edit, Edit::LeaveOut { agent } if agent == "b");
            assert!(
                repair.edits.iter().any(gone) || rests(&repair.plan),
                "{repair:?}"
            );
        }
    }
}

/// Whether `b` is where it broke down until its breakdown ends.
fn rests(plan: &Plan) -> bool {
    let path = plan.path("b");
    (1..=7).all(|time| path.get(time) == path.get(1))
}

#[test]
fn other_plans_keep_to_the_breakdown() {
    let lane = lane();
    for words in [
        "wait a",
        "visit a --at 4,0",
        "move b --from-cell 6,1 --to-cell 5,1 --time 7",
        "plan",
    ] {
        let answer = lane.ask(words);
        assert_eq!(answer.since, Some(1), "{words}");
        if let Some(other) = answer.alternative {
            assert_eq!(answer.costs, Some(lane.costs(&other)), "{words}");
            assert!(rests(&other), "{words}");
        }
    }
}

#[test]
fn a_breakdown_begins_at_the_end_of_a_slow_move() {
    let course = course(
        r#"{ "giveway": 1, "map": [".~~..", "....."], "agents": [
            { "name": "a", "start": [1, 0], "goal": [4, 0] }] }"#,
        r#"{ "giveway": 1, "knows": 1, "paths": {
            "a": [[1, 0], null, [2, 0], [2, 0], [2, 0], [3, 0], [4, 0]] } }"#,
        r#"{ "at": 1, "change": "delay-agent", "agent": "a", "steps": 2 }"#,
    );
    let answer = course.ask("wait a");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(1), Verdict::Necessary)
    );
    assert_eq!(texts(&answer), ["a is broken down from time 2 to 4"]);
    assert_eq!(course.ask("plan").optimal, Some(true));
}

#[test]
fn of_two_breakdowns_the_one_that_matters_is_named() {
    let mut course = lane();
    let more = r#"{ "giveway": 1, "changes": [
        { "at": 1, "change": "delay-agent", "agent": "b", "steps": 6 },
        { "at": 3, "change": "delay-agent", "agent": "b", "steps": 2 },
        { "at": 3, "change": "set-normal", "cells": [[5, 1]] }] }"#;
    course.changes = native::read_changes(more).unwrap();
    course.plan.knows = Some(3);
    let answer = course.ask("wait b --from 5 --to 7");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(3), Verdict::Necessary)
    );
    assert_eq!(texts(&answer), [BROKEN]);
    // The shown time decides which changes count.
    let mut request = course.request("wait b --from 3 --to 5");
    request.at = Some(2);
    assert_eq!(explained(request).unwrap().since, Some(1));
    let answer = course.ask("wait b --from 3 --to 5");
    let [one] = facts(&answer) else {
        panic!("{:?}", answer.core);
    };
    assert_eq!(one.kind, FactKind::Breakdown);
}

#[test]
fn a_robot_that_has_arrived_breaks_down_at_its_goal() {
    // `b` rests in the only way and breaks down there; `n` comes at the same time.
    let course = course(
        r#"{ "giveway": 1, "map": ["....", ".#.."], "agents": [
            { "name": "b", "start": [2, 0], "goal": [2, 0] }] }"#,
        r#"{ "giveway": 1, "knows": 4, "slept": { "b": [[0, 4]] }, "paths": {
            "b": [[2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [2, 1],
                [2, 0]],
            "n": [[0, 0], [0, 0], [0, 0], [1, 0], [2, 0], [3, 0]] }, "from": { "n": 4 } }"#,
        r#"{ "at": 4, "change": "add-agent", "agent":
                { "name": "n", "start": [0, 0], "goal": [3, 0] } },
            { "at": 4, "change": "delay-agent", "agent": "b", "steps": 3 }"#,
    );
    let answer = course.ask("plan");
    assert_eq!((answer.since, answer.optimal), (Some(4), Some(true)));
    assert_eq!(answer.costs, Some(course.costs(&course.plan)));
    let answer = course.ask("arrival n");
    assert_eq!(answer.verdict, Verdict::Necessary);
    let texts = texts(&answer);
    assert!(
        texts.contains(&"b is broken down from time 4 to 7"),
        "{texts:?}"
    );
}

#[test]
fn a_breakdown_beyond_the_end_of_the_plan() {
    let course = course(
        r#"{ "giveway": 1, "map": ["..."], "agents": [
            { "name": "a", "start": [0, 0], "goal": [1, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0]] } }"#,
        r#"{ "at": 5, "change": "delay-agent", "agent": "a", "steps": 100 }"#,
    );
    let answer = course.ask("plan");
    assert_eq!((answer.since, answer.optimal), (Some(5), Some(true)));
    assert_eq!(
        course.refused("arrival a"),
        "a was already at its goal at time 5, and the past cannot change."
    );
    let answer = course.ask("no-visit a --at 2,0");
    assert_eq!(answer.verdict, Verdict::Costly, "{}", answer.words);
    assert_eq!(answer.costs.unwrap().makespan, 107);
    assert!(texts(&answer).is_empty() || answer.core.is_some());
}

#[test]
fn a_battery_that_a_breakdown_empties() {
    let course = course(
        r#"{ "giveway": 1, "map": ["...."], "agents": [
            { "name": "a", "start": [0, 0], "goal": [3, 0],
              "battery": { "capacity": 9, "initial": 5 } }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0], [2, 0], [3, 0]] } }"#,
        r#"{ "at": 1, "change": "delay-agent", "agent": "a", "steps": 3 }"#,
    );
    let answer = course.ask("unsolvable");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(1), Verdict::Necessary)
    );
    assert!(answer.reach.is_complete());
    let texts = texts(&answer);
    assert!(
        texts.contains(&"a is broken down from time 1 to 4"),
        "{texts:?}"
    );
    let kinds: Vec<FactKind> = facts(&answer).iter().map(|fact| fact.kind).collect();
    assert!(kinds.contains(&FactKind::Battery), "{kinds:?}");
    assert!(matches!(answer.question, Question::Unsolvable));
    let mut repairs = answer.repairs.iter();
    assert!(repairs.any(|repair| matches!(repair.edits[..], [Edit::Battery { .. }])));
}
