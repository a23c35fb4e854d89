//! Who has waited, and since when.

use giveway_model::Cost;
use giveway_model::check::check_changes;
use giveway_model::format::native;
use giveway_solve::change::Method;

use super::{answer, optimal, request_of};

/// An agent that stands at its goal and was to go on, and stays for good after
/// all, arrived when it came; if it goes on, it has waited.
#[test]
fn who_stands_at_its_goal_has_waited_only_if_it_goes_on() {
    let scene = r##"{ "giveway": 1, "map": ["...", "#.."],
        "objective": ["makespan", "waits"],
        "agents": [{ "name": "A", "start": [1, 0], "goal": [1, 0] }] }"##;
    let plan = r#"{ "giveway": 1, "paths": { "A": [[1, 0], [1, 0], [1, 0], [0, 0], [1, 0]] } }"#;
    let passes = r#"{ "at": 2, "change": "add-agent",
        "agent": { "name": "B", "start": [0, 0], "goal": [2, 0] } }"#;
    let idle = r#"{ "at": 2, "change": "add-charger", "cell": [0, 0] }"#;
    for (change, arrival, waits) in [(idle, 0, 0), (passes, 4, 2)] {
        let scene = native::read_instance(scene).unwrap();
        let changes = format!(r#"{{ "giveway": 1, "changes": [{change}] }}"#);
        let changes = native::read_changes(&changes).unwrap();
        let request = request_of(
            scene.to_scene(),
            native::read_plan(plan).unwrap(),
            changes.clone(),
            &[Method::Replan],
        );
        let answer = answer(request).unwrap();
        let found = &answer.methods.get(Method::Replan).unwrap().result;
        let costs = found.costs.unwrap();
        assert_eq!(costs.waits, waits, "{found:?}");
        let plan = found.plan.clone().unwrap();
        let report = check_changes(&scene, &changes, &plan).unwrap();
        assert!(report.is_valid(), "{:?}", report.violations);
        assert_eq!(report.costs, Some(costs));
        assert_eq!(plan.path("A").len() as u32, arrival + 1, "{plan:?}");
    }
}

/// A battery that is set while its agent sleeps counts when it wakes.
#[test]
fn a_battery_that_is_set_in_sleep_lasts() {
    let scene = r#"{ "giveway": 1, "map": ["..."], "agents": [{ "name": "A",
        "start": [0, 0], "goal": [1, 0], "battery": { "capacity": 6, "initial": 1 } }] }"#;
    let changes = r#"{ "giveway": 1, "changes": [
        { "at": 3, "change": "set-battery", "agent": "A", "level": 6 },
        { "at": 5, "change": "add-waypoint", "agent": "A", "cell": [2, 0] }] }"#;
    let plan = r#"{ "giveway": 1, "knows": 3, "paths": { "A": [[0, 0], [1, 0]] } }"#;
    let request = request_of(
        native::read_instance(scene).unwrap().to_scene(),
        native::read_plan(plan).unwrap(),
        native::read_changes(changes).unwrap(),
        &[Method::Replan],
    );
    let answer = answer(request).unwrap();
    assert_eq!(optimal(&answer, Method::Replan).makespan, 7);
}

/// What an agent slept before one change is no wait at the next.
#[test]
fn who_was_woken_and_stays_after_all_has_waited_since_it_was_woken() {
    let scene = r#"{ "giveway": 1, "map": ["...", "..."], "objective": ["makespan", "waits"],
        "agents": [{ "name": "A", "start": [1, 0], "goal": [1, 0] }] }"#;
    let plan = r#"{ "giveway": 1, "knows": 3, "slept": { "A": [[0, 3]] },
        "paths": { "A": [[1, 0], [1, 0], [1, 0], [1, 0], [1, 0], [1, 1], [1, 0]] } }"#;
    let changes = r#"{ "giveway": 1, "changes": [
        { "at": 3, "change": "add-charger", "cell": [0, 0] },
        { "at": 4, "change": "add-charger", "cell": [2, 0] }] }"#;
    let request = |method| {
        request_of(
            native::read_instance(scene).unwrap().to_scene(),
            native::read_plan(plan).unwrap(),
            native::read_changes(changes).unwrap(),
            &[method],
        )
    };
    for (method, makespan, waits) in [(Method::Revise, 6, 1), (Method::Replan, 0, 0)] {
        let answer = answer(request(method)).unwrap();
        let costs = optimal(&answer, method);
        assert_eq!((costs.makespan, costs.waits), (makespan, waits));
        let bounds = &answer.methods.get(method).unwrap().result.bounds;
        assert_eq!(bounds.get(&Cost::Waits), Some(&waits), "{bounds:?}");
    }
}

/// A waypoint that was dropped was in the way up to then: who waited for that
/// has waited, and sleeps from then on.
#[test]
fn who_waited_for_a_waypoint_to_be_dropped_has_waited() {
    let scene = r#"{ "giveway": 1, "map": ["..."],
        "agents": [{ "name": "A", "start": [0, 0], "goal": [0, 0] }] }"#;
    let changes = r#"{ "giveway": 1, "changes": [
        { "at": 1, "change": "add-waypoint", "agent": "A", "cell": [2, 0] },
        { "at": 1, "change": "delay-agent", "agent": "A", "steps": 2 },
        { "at": 3, "change": "drop-waypoint", "agent": "A", "cell": [2, 0] },
        { "at": 5, "change": "add-charger", "cell": [1, 0] }] }"#;
    let plan = r#"{ "giveway": 1, "knows": 3, "slept": { "A": [[0, 1]] },
        "paths": { "A": [[0, 0], [0, 0], [0, 0], [0, 0]] } }"#;
    let request = request_of(
        native::read_instance(scene).unwrap().to_scene(),
        native::read_plan(plan).unwrap(),
        native::read_changes(changes).unwrap(),
        &[Method::Replan],
    );
    let answer = answer(request).unwrap();
    let costs = optimal(&answer, Method::Replan);
    assert_eq!((costs.makespan, costs.waits), (3, 2));
}
