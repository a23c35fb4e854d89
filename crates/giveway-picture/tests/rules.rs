//! Rules of the scene's own in pictures: zones, signs, lanes, tags, closed zones while they are
//! closed.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use giveway_model::format::native;
use giveway_model::{Instance, Plan};
use giveway_picture::{Inks, Letters, Look, Theme, moving, on_paper, still};
use roxmltree::{Document, Node};

const SCENE: &str = r#"{
    "giveway": 1,
    "map": ["....", "....", "...."],
    "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] }],
    "zones": [{ "name": "<gate>", "cells": [[1, 1], [2, 1]] }, { "name": "hall", "rect": [0, 2, 3, 2] }],
    "constraints": [
        { "kind": "closed", "zone": "<gate>", "from": 2, "to": 3 },
        { "kind": "capacity", "zone": "<gate>", "most": 7 },
        { "kind": "one-way", "lane": [[0, 0], [1, 0], [2, 0]] },
        { "kind": "arrive", "by": 8 },
        { "kind": "avoid", "zone": "hall", "weight": 5, "off": true }
    ]
}"#;

const PLAN: &str = r#"{
    "giveway": 1,
    "paths": { "A1": [[0, 0], [1, 0], [2, 0], [2, 0], [2, 0], [3, 0]] }
}"#;

fn scene(theme: Theme, cell: u32) -> (Instance, Plan, Look) {
    let instance = native::read_instance(SCENE).unwrap();
    let plan = native::read_plan(PLAN).unwrap();
    let look = Look {
        theme,
        cell,
        ..Look::fitting(instance.grid(), 1000)
    };
    (instance, plan, look)
}

/// How many shapes have an attribute with a value.
fn count(svg: &str, name: &str, value: &str) -> usize {
    let document = Document::parse(svg).unwrap();
    let shapes = document.descendants();
    let has = |shape: &Node<'_, '_>| shape.attribute(name).is_some_and(|it| it.contains(value));
    shapes.filter(has).count()
}

fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|it| it.has_tag_name("text"));
    texts
        .filter_map(|it| it.text().map(str::to_owned))
        .collect()
}

#[test]
fn a_closed_zone_is_hatched_while_it_is_closed() {
    for theme in [Theme::Light, Theme::Dark] {
        for cell in [10, 20, 40, 64] {
            let (instance, plan, look) = scene(theme, cell);
            for draw in [still, on_paper] {
                let hatched =
                    |time: f64| count(&draw(&instance, &plan, time, &look), "fill", "-shut)");
                let times = [0.0, 1.5, 2.0, 3.5, 4.0].map(hatched);
                assert_eq!(times, [0, 0, 1, 1, 0], "{cell}");
            }
            let moves = moving(&instance, &plan, &look);
            assert_eq!(count(&moves, "fill", "-shut)"), 1);
            let never = SCENE.replace("\"to\": 3", "\"to\": 3, \"off\": true");
            let never = native::read_instance(&never).unwrap();
            let open = moving(&never, &plan, &look);
            assert_eq!(count(&open, "fill", "-shut)"), 0);
            let hidden = [&moves, &open].map(|svg| count(svg, "opacity", "0"));
            assert_eq!(hidden[0] - hidden[1], 2, "the hatch and the full sign wait");
        }
    }
}

#[test]
fn zones_lanes_and_tags_are_drawn_in_ink() {
    for theme in [Theme::Light, Theme::Dark] {
        let (instance, plan, look) = scene(theme, 64);
        let svg = still(&instance, &plan, 0.0, &look);
        let words = texts(&svg);
        for word in ["<gate>", "2-3", "hall", "7", "by 8"] {
            assert!(words.iter().any(|it| it == word), "{word}: {words:?}");
        }
        assert!(
            !words.contains(&"5".to_owned()),
            "a rule that is off has no sign"
        );
        let line = Inks::of(theme).rule_line.to_string();
        let chevrons = count(&svg, "d", "M-15-39");
        assert_eq!(chevrons, 4, "two borders, each with a halo");
        // Two outlines, two tabs, two chevrons, a tag.
        assert_eq!(count(&svg, "stroke", &line), 7);
        // Small cells keep the signs and leave the words out.
        let (_, _, small) = scene(theme, 20);
        let svg = still(&instance, &plan, 0.0, &small);
        assert!(!texts(&svg).contains(&"hall".to_owned()));
        assert!(texts(&svg).contains(&"7".to_owned()));
        // Letters that are lines have no text.
        let strokes = Look {
            letters: Letters::Strokes,
            ..look
        };
        assert_eq!(texts(&still(&instance, &plan, 0.0, &strokes)), [""; 0]);
    }
}

#[test]
fn a_scene_without_rules_has_nothing_of_it() {
    let (_, plan, look) = scene(Theme::Light, 64);
    let text = r#"{ "giveway": 1, "map": ["...."], "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] }] }"#;
    let instance = native::read_instance(text).unwrap();
    let svg = moving(&instance, &plan, &look);
    assert!(!svg.contains("-shut") && !svg.contains(&Inks::of(Theme::Light).rule_line.to_string()));
}

#[test]
fn a_stay_counts_down_while_it_is_made() {
    let (_, _, look) = scene(Theme::Light, 64);
    let rules = r#""constraints": [{ "kind": "visit", "cell": [2, 0], "stay": 2 },"#;
    let scene = SCENE.replace(r#""constraints": ["#, rules);
    let instance = native::read_instance(&scene).unwrap();
    let plan = native::read_plan(PLAN).unwrap();
    let look = Look {
        letters: Letters::Text,
        ..look
    };
    // At (2, 0) from 2 to 4.
    let left = |time: f64| {
        let svg = still(&instance, &plan, time, &look);
        let is_clock = "M-12-8a8 8 0 1 0 .01 0M-12-4V0l3 2";
        (count(&svg, "d", is_clock), texts(&svg))
    };
    for (time, word) in [(2.0, "2"), (3.0, "1")] {
        let (clocks, texts) = left(time);
        assert_eq!(clocks, 1, "at {time}");
        let first = texts.iter().filter(|text| *text == word).count();
        assert!(first > 0, "{word} at {time}: {texts:?}");
    }
    assert_eq!([left(1.0).0, left(4.0).0], [0, 0]);
    // As it moves, each number is there once, seen at its time alone.
    let svg = moving(&instance, &plan, &look);
    assert_eq!(count(&svg, "d", "M-12-8a8 8 0 1 0 .01 0"), 2);
}
