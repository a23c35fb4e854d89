//! Agents without a goal: read, written, judged, changed.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

use giveway_model::change::History;
use giveway_model::check::{Rule, arrivals, check, check_changes, level_over_time};
use giveway_model::format::{link, native, schema};
use giveway_model::{Cell, Instance, Plan};

fn instance(rules: &str, agents: &str) -> Instance {
    let text = format!(
        r#"{{ "giveway": 1, "map": ["....", "...."], "rules": {rules}, "agents": [{agents}] }}"#
    );
    native::read_instance(&text).unwrap()
}

fn plan(paths: &str) -> Plan {
    native::read_plan(&format!(r#"{{ "giveway": 1, "paths": {{ {paths} }} }}"#)).unwrap()
}

fn rules_broken(instance: &Instance, plan: &Plan) -> Vec<Rule> {
    let report = check(instance, plan);
    report.violations.iter().map(|it| it.rule).collect()
}

const FREE: &str = r#"{ "name": "A", "start": [0, 0] }"#;
const VANISH: &str = r#"{ "at_goal": "vanish" }"#;

#[test]
fn a_goal_left_out_or_null_is_none() {
    let left_out = instance("null", FREE);
    let null = instance(
        "{}",
        r#"{ "name": "A", "start": [0, 0], "goal": null, "waypoints": null, "battery": null }"#,
    );
    assert_eq!(left_out.agents()[0].goal, None);
    assert_eq!(left_out, null);
    let text = native::write_scene(&left_out.to_scene());
    assert!(
        text.contains(r#"{ "name": "A", "start": [0, 0] }"#),
        "{text}"
    );
    assert_eq!(native::read_instance(&text).unwrap(), left_out);
    let objective = r#"{ "giveway": 1, "map": ["."], "objective": null, "agents": [] }"#;
    assert!(native::read_instance(objective).is_ok());
}

#[test]
fn the_schema_takes_what_is_read() {
    let whole: serde_json::Value = serde_json::from_str(schema()).unwrap();
    let mut of_instance = whole.clone();
    of_instance["$ref"] = "#/$defs/instance".into();
    of_instance.as_object_mut().unwrap().remove("anyOf");
    let validator = jsonschema::draft202012::new(&of_instance).unwrap();
    let scene = serde_json::json!({
        "giveway": 1, "map": [".."], "rules": null, "objective": null,
        "agents": [{ "name": "A", "start": [0, 0], "goal": null, "waypoints": null },
                   { "name": "B", "start": [1, 0] }]
    });
    assert!(validator.is_valid(&scene));
}

#[test]
fn links_hold_agents_without_goals() {
    let scene = instance(
        VANISH,
        r#"{ "name": "A-.1", "start": [0, 0], "waypoints": [[1, 0], [2, 1]],
             "battery": { "capacity": 5, "initial": 4 } },
           { "name": "B", "start": [1, 1] },
           { "name": "C", "start": [3, 1], "goal": [0, 1], "waypoints": [[2, 0]] }"#,
    )
    .to_scene();
    let text = link::scene::write(&scene);
    assert!(
        text.ends_with("&agents=A-%2E1.0.0.-.1.0.2.1!5.4;B.1.1.-;C.3.1.0.1.2.0"),
        "{text}"
    );
    for agent in &scene.agents {
        let told = link::scene::write_agent(agent);
        assert_eq!(link::scene::read_agent(&told).as_ref(), Some(agent));
    }
    // Links of before are read as ever, and broken ones are not.
    let old = link::scene::read_agent("B.1.1.0.0").unwrap();
    assert_eq!(old.goal, Some(Cell::new(0, 0)));
    for broken in [
        "B.1.1",
        "B.1.1.-.2",
        "B.1.1.-2.1",
        "B.1.1.0.0.-",
        "B.-",
        "B.1.1.-.",
    ] {
        assert_eq!(link::scene::read_agent(broken), None, "{broken}");
    }
}

#[test]
fn it_arrives_where_it_stays_with_its_waypoints_visited() {
    let free = instance("{}", FREE);
    for (path, arrival) in [
        (r#""A": [[0, 0]]"#, 0),
        (r#""A": [[0, 0], [0, 0], [0, 0]]"#, 0),
        (r#""A": [[0, 0], [1, 0], [1, 0]]"#, 1),
        (r#""A": [[0, 0], [0, 0], [0, 1]]"#, 2),
    ] {
        let plan = plan(path);
        assert_eq!(rules_broken(&free, &plan), [], "{path}");
        assert_eq!(arrivals(&free, &plan), [Some(arrival)], "{path}");
    }
    let errand = instance(
        "{}",
        r#"{ "name": "A", "start": [0, 0], "waypoints": [[2, 0]] }"#,
    );
    assert_eq!(
        rules_broken(&errand, &plan(r#""A": [[0, 0]]"#)),
        [Rule::Waypoint]
    );
    let done = plan(r#""A": [[0, 0], [1, 0], [2, 0], [2, 0], [2, 1]]"#);
    assert_eq!(rules_broken(&errand, &done), []);
    assert_eq!(arrivals(&errand, &done), [Some(4)]);
}

#[test]
fn it_blocks_the_cell_where_it_rests_under_both_rules() {
    let other = r#"{ "name": "B", "start": [2, 0], "goal": [0, 0] }"#;
    let passing = plan(r#""A": [[0, 0], [1, 0]], "B": [[2, 0], [2, 0], [2, 0], [1, 0], [0, 0]]"#);
    let aside = plan(r#""A": [[0, 0], [0, 1]], "B": [[2, 0], [1, 0], [0, 0]]"#);
    for rules in ["{}", VANISH] {
        let both = instance(rules, &format!("{FREE}, {other}"));
        assert_eq!(rules_broken(&both, &passing), [Rule::Vertex]);
        assert_eq!(rules_broken(&both, &aside), []);
    }
}

#[test]
fn its_battery_counts_up_to_its_arrival() {
    let agent = |initial: u32| {
        format!(
            r#"{{ "name": "A", "start": [0, 0],
                  "battery": {{ "capacity": 3, "initial": {initial} }} }}"#
        )
    };
    let rest = plan(r#""A": [[0, 0], [1, 0], [1, 0], [1, 0], [1, 0]]"#);
    assert_eq!(rules_broken(&instance("{}", &agent(1)), &rest), []);
    assert_eq!(
        rules_broken(&instance("{}", &agent(0)), &rest),
        [Rule::Battery]
    );
}

#[test]
fn goals_of_others_are_no_fault() {
    let agents = r#"{ "name": "A", "start": [0, 0] }, { "name": "B", "start": [1, 0] },
                    { "name": "C", "start": [2, 0], "goal": [3, 0] }"#;
    assert_eq!(instance("{}", agents).agents().len(), 3);
}

#[test]
fn it_has_arrived_when_the_world_changes_and_may_be_given_a_goal() {
    for rules in ["{}", VANISH] {
        let scene = instance(
            rules,
            r#"{ "name": "A", "start": [0, 0], "battery": { "capacity": 4, "initial": 3 } }"#,
        );
        let before = plan(r#""A": [[0, 0], [1, 0]]"#);
        let changes = native::read_changes(
            r#"{ "giveway": 1, "changes": [
                 { "at": 3, "change": "set-goal", "agent": "A", "cell": [3, 0] } ] }"#,
        )
        .unwrap();
        let history = History::of(&scene, &changes, &before).unwrap();
        assert_eq!(history.timelines()[0].goal(), Some(Cell::new(3, 0)));
        let after = native::read_plan(
            r#"{ "giveway": 1, "knows": 3, "slept": { "A": [[1, 3]] },
                 "paths": { "A": [[0, 0], [1, 0], [1, 0], [1, 0], [2, 0], [3, 0]] } }"#,
        )
        .unwrap();
        let report = check_changes(&scene, &changes, &after).unwrap();
        assert_eq!(report.violations, []);
        let costs = report.costs.unwrap();
        assert_eq!((costs.makespan, costs.waits), (5, 0));
        let trajectories = history.trajectories(&after, 5);
        let level = level_over_time(&history, &trajectories[0], 5);
        assert_eq!(level, Some(0), "it used nothing while it slept");
    }
}

/// A robot that rests is there also where others vanish, and half way along a slow edge it is
/// met by what crosses that edge the other way.
#[test]
fn obstacles_that_move_meet_robots_that_rest_and_robots_in_transit() {
    let moving = |map: &str, path: &str, agent: &str| {
        let text = format!(
            r#"{{ "giveway": 1, "map": {map}, "rules": {VANISH}, "agents": [{agent}],
                "assumptions": [{{ "assumes": "moving-obstacle", "name": "o", "path": {path} }}] }}"#
        );
        native::read_instance(&text).unwrap()
    };
    let rests = moving(
        r#"["..."]"#,
        "[[2, 0], [2, 0], [1, 0], [0, 0]]",
        r#"{ "name": "A", "start": [1, 0] }"#,
    );
    let here = plan(r#""A": [[1, 0]]"#);
    assert_eq!(rules_broken(&rests, &here), [Rule::Obstacle]);
    let goes = r#"{ "name": "A", "start": [0, 0], "goal": [1, 0] }"#;
    let slow = moving(r#"["~~"]"#, "[[1, 0], [0, 0]]", goes);
    let there = plan(r#""A": [[0, 0], null, [1, 0]]"#);
    assert_eq!(rules_broken(&slow, &there), [Rule::Obstacle]);
    let later = moving(r#"["~~"]"#, "[[1, 0], [1, 0], [0, 0]]", goes);
    assert_eq!(rules_broken(&later, &there), [Rule::Obstacle]);
    let behind = moving(r#"["~~~"]"#, "[[2, 0], [2, 0], [2, 0]]", goes);
    assert!(check(&behind, &there).is_valid());
}
