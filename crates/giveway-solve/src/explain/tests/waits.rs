//! What would happen without a wait.

use giveway_model::{Plan, Question, check::Rule, question::from_words};

use super::{read, scenario_1};
use crate::explain::{waits::witness, whole::WholePlan};

fn asked(words: &str) -> Question {
    let words: Vec<&str> = words.split_whitespace().collect();
    from_words(&words).unwrap()
}

#[test]
fn in_scenario_1_they_would_meet() {
    let (instance, plan, _) = scenario_1();
    let found = witness(
        &instance,
        &asked("wait A2 --at 3,1"),
        &plan,
        WholePlan::default(),
    );
    let found: Vec<_> = found.iter().map(|v| (v.rule, v.time)).collect();
    assert_eq!(found, [(Rule::Vertex, 1), (Rule::Vertex, 2)]);
    let elsewhere = witness(
        &instance,
        &asked("wait A2 --at 2,1"),
        &plan,
        WholePlan::default(),
    );
    assert!(elsewhere.is_empty(), "no wait step is taken out");
}

/// A corridor in which `a` waits a while before it goes, charging at times.
fn waiting(entries: &str, charges: &str) -> (giveway_model::Instance, Plan) {
    let instance = r#"{ "giveway": 1, "map": ["+....", "....."], "agents": [
        { "name": "a", "start": [0, 0], "goal": [4, 0],
          "battery": { "capacity": 4, "initial": 1 } },
        { "name": "b", "start": [4, 1], "goal": [0, 1] }] }"#;
    let paths = format!(
        r#"{{ "giveway": 1, "paths": {{ "a": [{entries}],
            "b": [[4, 1], [3, 1], [2, 1], [1, 1], [0, 1]] }},
            "charges": {{ "a": [{charges}] }} }}"#
    );
    read(instance, &paths)
}

#[test]
fn a_charge_of_a_wait_is_made_by_the_step_after_it() {
    let (instance, plan) = waiting(
        "[0, 0], [0, 0], [0, 0], [1, 0], [2, 0], [3, 0], [4, 0]",
        "0, 2",
    );
    assert!(giveway_model::check::check(&instance, &plan).is_valid());
    // All waits gone, a charge is left at time 0: nothing is broken.
    assert!(witness(&instance, &asked("wait a"), &plan, WholePlan::default()).is_empty());
}

#[test]
fn of_a_long_wait_only_what_is_too_long_is_taken_out() {
    let (instance, plan) = waiting(
        "[0, 0], [0, 0], [0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [4, 0]",
        "0, 2",
    );
    let short = |words: &str| {
        let (_, other) = waiting("[0, 0], [0, 0], [1, 0], [2, 0], [3, 0], [4, 0]", "0, 1");
        (
            witness(&instance, &asked(words), &plan, WholePlan::default()),
            other,
        )
    };
    let (found, other) = short("wait a --at-least 2");
    assert_eq!(
        found,
        giveway_model::check::check(&instance, &other).violations
    );
}
