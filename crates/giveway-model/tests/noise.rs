//! Readers never panic on noise, and read back what writers write.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use giveway_model::check::{check, levels};
use giveway_model::format::native;
use giveway_model::{Agent, AtGoal, Battery, Cell, Cost, Instance, Objective, Plan, Rules, Scene};
use proptest::prelude::*;

use texts::assert_short;

#[path = "noise/texts.rs"]
mod texts;

const INSTANCE: &str = r##"{ "giveway": 1, "name": "n", "map": ["..~~", "#+*."],
  "rules": { "at_goal": "vanish", "battery_floor": 1 }, "objective": ["moves", "waits"],
  "agents": [{ "name": "A", "start": [0, 0], "goal": [1, 1], "waypoints": [[1, 0]],
               "battery": { "capacity": 3, "initial": 3 } }] }"##;
const PLAN: &str = r#"{ "giveway": 1, "paths": { "A": [[0, 0], null, [1, 0], [1, 1]] },
  "charges": { "A": [1] }, "from": { "A": 0 }, "until": { "B": 3 } }"#;

const FILES: [&str; 2] = [INSTANCE, PLAN];

/// Gives a text to every reader, and what they read to all that comes after.
fn read_all(text: &str) {
    if let Err(fault) = native::read_scene(text) {
        assert_short(&fault);
    }
    let instance = match native::read_instance(text) {
        Ok(instance) => instance,
        Err(faults) => {
            assert!(!faults.is_empty());
            for fault in &faults {
                assert_short(fault);
                assert!(fault.line.is_some() && fault.column.is_some());
            }
            native::read_instance(INSTANCE).unwrap()
        }
    };
    if let Ok(plan) = native::read_plan(text) {
        let _ = check(&instance, &plan);
        let _ = levels(&instance, 0, &plan);
    }
}

/// A scene that may break any rule of the problem.
fn any_scene() -> impl Strategy<Value = Scene> {
    let cell = (0_u32..5, 0_u32..4).prop_map(Cell::from);
    let battery =
        (0_u32..9, 0_u32..9).prop_map(|(capacity, initial)| Battery { capacity, initial });
    let agent = (
        ".{0,6}",
        cell.clone(),
        cell.clone(),
        prop::collection::vec(cell, 0..3),
        prop::option::of(battery),
    )
        .prop_map(|(name, start, goal, waypoints, battery)| Agent {
            name,
            start,
            goal: Some(goal),
            waypoints,
            battery,
            heading: None,
        });
    let objective = prop::sample::subsequence(Cost::USUAL.to_vec(), 1..=5).prop_shuffle();
    (
        ".{0,9}",
        prop::collection::vec("[.#~+*]{3}|.{0,4}", 0..4),
        (any::<bool>(), 0_u32..4),
        objective,
        prop::collection::vec(agent, 0..4),
    )
        .prop_map(
            |(name, map, (stays, battery_floor), objective, agents)| Scene {
                name,
                map,
                rules: Rules {
                    at_goal: if stays { AtGoal::Stay } else { AtGoal::Vanish },
                    battery_floor,
                },
                objective: Objective::new(objective).unwrap(),
                agents,
                ..Scene::default()
            },
        )
}

/// A plan that may break any rule, for agents `A`, `B`, `C` among others.
fn any_plan() -> impl Strategy<Value = Plan> {
    let far = prop_oneof![0_u32..4, Just(u32::MAX)];
    let cell = prop::option::of((far.clone(), far).prop_map(Cell::from));
    let name = "[A-D]|.{0,3}";
    (
        prop::collection::btree_map(name, prop::collection::vec(cell, 0..9), 0..5),
        prop::collection::btree_map(name, prop::collection::vec(0_u32..12, 0..4), 0..3),
        prop::collection::btree_map(name, any::<u32>(), 0..2),
        prop::collection::btree_map(name, any::<u32>(), 0..2),
    )
        .prop_map(|(paths, charges, from, until)| Plan {
            paths,
            charges,
            from,
            until,
            ..Plan::default()
        })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn scenes_come_back_from_what_is_written(scene in any_scene()) {
        prop_assert_eq!(native::read_scene(&native::write_scene(&scene)), Ok(scene.clone()));
        let text = serde_json::to_string_pretty(&scene).unwrap();
        prop_assert_eq!(native::read_scene(&text), Ok(scene.clone()));
        if let Ok(instance) = Instance::new(scene.clone()) {
            prop_assert_eq!(instance.to_scene(), scene);
        }
    }

    #[test]
    fn plans_come_back_from_what_is_written_and_are_judged(plan in any_plan()) {
        prop_assert_eq!(native::read_plan(&native::write_plan(&plan)), Ok(plan.clone()));
        let agent = |name: &str, x| Agent {
            name: name.into(),
            start: Cell::new(x, 0),
            goal: Some(Cell::new(x, 1)),
            waypoints: vec![Cell::new(3, 1)],
            battery: Some(Battery { capacity: 4, initial: 3 }),
            heading: None,
        };
        let instance = Instance::new(Scene {
            map: vec![".~*.".into(), "+~~.".into(), "..#.".into()],
            agents: vec![agent("A", 0), agent("B", 1), agent("C", 2)],
            ..Scene::default()
        })
        .unwrap();
        let report = check(&instance, &plan);
        let times: Vec<u32> = report.violations.iter().map(|v| v.time).collect();
        prop_assert!(times.is_sorted());
        prop_assert_eq!(report, check(&instance, &plan));
    }
}
