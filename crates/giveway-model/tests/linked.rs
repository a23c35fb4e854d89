//! A scene that has all that a scene can have is the same after a link.

#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use std::collections::BTreeSet;

use giveway_model::format::link::scene::{PARTS, read, write};
use giveway_model::{Assumption, Measure, Objective, Scene, Units, format::native};

/// Whoever gives scenes another field adds it here.
fn whole() -> Scene {
    let text = r#"{ "giveway": 1, "name": "All & = one", "map": ["..#~", "+..."],
        "rules": { "at_goal": "vanish", "battery_floor": 2 },
        "objective": ["moves", "makespan"],
        "agents": [
            { "name": "A1", "start": [0, 0], "goal": [3, 0], "waypoints": [[1, 1]],
              "battery": { "capacity": 9, "initial": 7 }, "heading": "east" },
            { "name": "A2", "start": [0, 1] }
        ],
        "zones": [{ "name": "bay", "cells": [[0, 0], [1, 0]] }],
        "constraints": [{ "kind": "capacity", "zone": "bay", "most": 1 }],
        "units": { "cell": 0.8, "step": 1.5 } }"#;
    let mut scene = native::read_scene(text).unwrap();
    scene.assumptions.push(Assumption::GoalsChosen);
    scene
}

#[test]
fn nothing_is_left_out_and_every_part_is_named() {
    let scene = whole();
    let Scene {
        giveway: _,
        name,
        map,
        rules,
        objective,
        agents,
        assumptions,
        zones,
        constraints,
        units,
    } = &scene;
    assert!(!name.is_empty() && !map.is_empty() && !agents.is_empty());
    assert!(*rules != Scene::default().rules && *objective != Objective::default());
    assert!(!assumptions.is_empty() && !zones.is_empty() && !constraints.is_empty());
    let thousandths = |measure: Measure| measure.thousandths();
    let units = units.map(|Units { cell, step }| (thousandths(cell), thousandths(step)));
    assert_eq!(units, Some((800, 1500)));

    let text = write(&scene);
    let parts: Vec<(&str, &str)> = text
        .split('&')
        .skip(1)
        .map(|part| part.split_once('=').unwrap())
        .collect();
    let names: BTreeSet<&str> = parts.iter().map(|&(name, _)| name).collect();
    assert_eq!(names, BTreeSet::from(PARTS));
    let mut linked = Scene::default();
    for (name, value) in parts {
        read(&mut linked, name, value).unwrap();
    }
    assert_eq!(linked, scene);
}
