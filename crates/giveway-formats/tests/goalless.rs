//! Agents without a goal, written in formats that want one for each agent.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

use giveway_formats::{Format, write};
use giveway_model::format::native;
use giveway_model::{Instance, Plan};

fn instance(rules: &str, agents: &str) -> Instance {
    let text = format!(
        r#"{{ "giveway": 1, "map": ["....", "...."], "rules": {rules}, "agents": [{agents}] }}"#
    );
    native::read_instance(&text).unwrap()
}

fn plan(paths: &str) -> Plan {
    native::read_plan(&format!(r#"{{ "giveway": 1, "paths": {{ {paths} }} }}"#)).unwrap()
}

#[test]
fn other_formats_take_the_end_of_a_plan_as_the_goal_and_say_so() {
    let agents = r#"{ "name": "A1", "start": [0, 0] },
                    { "name": "A2", "start": [1, 0], "goal": [3, 0] }"#;
    let scene = instance("{}", agents);
    let plan = plan(r#""A1": [[0, 0], [0, 1]], "A2": [[1, 0], [2, 0], [3, 0]]"#);
    for format in [
        Format::MovingAi,
        Format::Tracker,
        Format::Paths,
        Format::Result,
        Format::Asprilo,
        Format::League,
        Format::Mapfw,
        Format::MultiRobot,
    ] {
        let refused = write(format, "x", Some(&scene), None).unwrap_err();
        let told = refused.to_string();
        assert!(
            told.contains("A1, a robot without a goal") || told.contains("plan"),
            "{told}"
        );
        if format == Format::MovingAi {
            continue; // (it holds no plans)
        }
        let written = write(format, "x", Some(&scene), Some(&plan)).unwrap();
        let lost = "that 1 robot may rest at any cell (the end of the plan is the goal)";
        assert!(
            written.losses.iter().any(|loss| loss == lost),
            "{format}: {:?}",
            written.losses
        );
    }
    let own = write(Format::Giveway, "x", Some(&scene), Some(&plan)).unwrap();
    assert!(own.losses.is_empty(), "{:?}", own.losses);
}
