//! Who is last and why, and what a report says of it.

use giveway_model::change::Changes;
use giveway_model::format::native::{read_changes, read_instance, read_plan};

use super::{report, scene};
use crate::report::{Known, LoneDelay, Report, Subject};

fn lone(robot: &str, alone: u32, delay: u32) -> LoneDelay {
    LoneDelay {
        robot: robot.to_owned(),
        alone,
        delay,
        passes: "somebody".to_owned(),
        why: format!("{robot} lets somebody pass."),
    }
}

#[test]
fn the_last_robot_is_told_with_its_way_alone() {
    let unknown = report(Known::default());
    assert_eq!(
        unknown.last,
        [
            "A2 arrives last, at 6.",
            "A2 waits 1 step at (3, 1) from 0 on."
        ]
    );
    assert!(!unknown.html().contains("Alone"));
    let known = report(Known {
        delays: vec![lone("A2", 5, 1), lone("=A1", 4, 0)],
        ..Known::default()
    });
    assert_eq!(
        known.last,
        [
            "A2 arrives last, at 6.",
            "Alone, A2 would arrive at 5.",
            "A2 lets somebody pass.",
            "A2 waits 1 step at (3, 1) from 0 on."
        ]
    );
    let alone = known.robots.iter().map(|row| row.alone.as_ref().unwrap());
    let alone: Vec<_> = alone.map(|lone| (lone.alone, lone.delay)).collect();
    assert_eq!(alone, [(4, 0), (5, 1)]);
    let html = known.html();
    assert!(
        html.contains("<li>Alone, A2 would arrive at 5.</li>"),
        "{html}"
    );
    let heads = known.csv();
    let heads = heads.lines().next().unwrap();
    assert!(heads.contains("seconds\",Alone,Delay,Waits,"), "{heads}");
    let free = report(Known {
        delays: vec![lone("A2", 6, 0)],
        ..Known::default()
    });
    assert_eq!(
        free.last[1],
        "Alone, A2 would arrive at 6, too: no other robot makes it late."
    );
}

#[test]
fn it_is_told_who_passes_meanwhile() {
    let instance = read_instance(
        r##"{ "giveway": 1, "map": ["...", "#.#"],
        "agents": [
          { "name": "A1", "start": [0, 0], "goal": [2, 0] },
          { "name": "A2", "start": [1, 1], "goal": [0, 0] }
        ] }"##,
    )
    .unwrap();
    let plan = read_plan(
        r#"{ "giveway": 1, "paths": {
          "A1": [[0, 0], [1, 0], [2, 0]],
          "A2": [[1, 1], [1, 1], [1, 0], [0, 0]] } }"#,
    )
    .unwrap();
    let subject = Subject::new(&instance, &plan, None).unwrap();
    let told = Report::of(&subject, Known::default());
    assert_eq!(
        told.last,
        [
            "A2 arrives last, at 3.",
            "A2 waits 1 step at (1, 1) from 0 on, for A1 to pass (1, 0)."
        ]
    );
}

#[test]
fn who_is_broken_down_does_not_wait() {
    let (instance, plan) = scene();
    let changes: Changes = read_changes(
        r#"{ "giveway": 1, "changes": [
          { "at": 0, "change": "delay-agent", "agent": "A2", "steps": 1 } ] }"#,
    )
    .unwrap();
    let subject = Subject::new(&instance, &plan, Some(&changes)).unwrap();
    let told = Report::of(&subject, Known::default());
    assert_eq!(told.last[1], "A2 is broken down at (3, 1) between 0 and 1.");
}
