//! JSON of the project's own: what the command writes, and null for what is left out.

use giveway_model::check::check;
use giveway_model::format::native::read_instance;

use super::{apart, brought, opened, refused};

#[test]
fn the_plan_in_a_result_is_read() {
    let scene = brought("lane.json");
    for name in ["solve-result.json", "lane.plan.json"] {
        let combined = opened(&[("lane.json", &scene), (name, &brought(name))]).unwrap();
        assert!(
            check(&combined.instance, &combined.plans[0].plan).is_valid(),
            "{name}"
        );
    }
    for name in ["change-result.json", "adopted.json"] {
        let combined = opened(&[("lane.json", &scene), (name, &brought(name))]).unwrap();
        let plan = &combined.plans[0];
        assert_eq!(plan.plan.knows, Some(3), "{name}");
        assert!(
            plan.notes[0].contains("adopted after the change"),
            "{:?}",
            plan.notes
        );
    }
}

#[test]
fn results_without_a_plan_say_what_they_are() {
    for (text, kind) in [
        (
            r#"{ "giveway": 1, "status": "optimal", "plan": null }"#,
            "a result without a plan",
        ),
        (
            r#"{ "giveway": 1, "valid": true, "violations": [] }"#,
            "the result of a check",
        ),
        (
            r#"{ "giveway": 1, "legal": true, "status": "optimal" }"#,
            "the result of an audit",
        ),
        (
            r#"{ "giveway": 1, "methods": {}, "adopted": null, "history": [] }"#,
            "a result without a plan",
        ),
    ] {
        assert!(refused(text).contains(kind), "{}", refused(text));
    }
    let told = apart(&[
        ("lane.json", &brought("lane.json")),
        ("delay.json", &brought("delay.json")),
    ]);
    assert!(
        told.starts_with("delay.json is a list of changes."),
        "{told}"
    );
    let front = r#"{ "giveway": 1, "status": "optimal", "front": [
        { "plan": { "giveway": 1, "paths": { "R1": [[0, 1]] } } }, { "plan": null }] }"#;
    let combined = opened(&[("lane.json", &brought("lane.json")), ("front.json", front)]).unwrap();
    assert!(combined.plans[0].notes[0].contains("the first of 2"));
}

#[test]
fn null_is_what_is_left_out() {
    let text = r#"{ "giveway": 1, "name": null, "map": [".."], "rules": null, "objective": null,
        "agents": [{ "name": "A", "start": [0, 0], "goal": [1, 0], "waypoints": null, "battery": null }] }"#;
    let without = r#"{ "giveway": 1, "map": [".."], "agents": [{ "name": "A", "start": [0, 0], "goal": [1, 0] }] }"#;
    assert_eq!(
        read_instance(text).unwrap(),
        read_instance(without).unwrap()
    );
    let rules = r#"{ "giveway": 1, "map": [".."], "rules": { "at_goal": null, "battery_floor": null }, "agents": [] }"#;
    assert!(read_instance(rules).is_ok());
}
