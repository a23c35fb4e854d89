//! Rules of a scene's own as they are read, refused, written and judged.

use giveway_model::format::{link, native};
use giveway_model::{Cell, Constraint, Grid, Instance, Scene};

/// A scene with these zones and rules.
fn scene(zones: &str, constraints: &str) -> String {
    format!(
        r#"{{ "giveway": 1, "map": ["....", ".#.."],
            "agents": [{{ "name": "A1", "start": [0, 0], "goal": [3, 0], "heading": "east" }},
                       {{ "name": "A2", "start": [3, 1], "goal": [0, 1] }}],
            "zones": [{zones}], "constraints": [{constraints}] }}"#
    )
}

const AISLE: &str = r#"{ "name": "aisle, \"3\"", "rect": [1, 0, 2, 0] }"#;

/// One rule of each kind.
const ALL: [&str; 14] = [
    r#"{ "kind": "capacity", "zone": "aisle, \"3\"", "most": 1, "from": 2, "name": "narrow" }"#,
    r#"{ "kind": "closed", "zone": "aisle, \"3\"", "to": 1000000, "off": true }"#,
    r#"{ "kind": "one-way", "lane": [[0, 0], [1, 0]], "agents": ["A2"] }"#,
    r#"{ "kind": "gap", "steps": 1 }"#,
    r#"{ "kind": "apart", "distance": 2 }"#,
    r#"{ "kind": "sequence", "agent": "A1", "cells": [[1, 0], [2, 1]] }"#,
    r#"{ "kind": "visit", "cell": [2, 1], "stay": 2, "from": 1, "to": 3 }"#,
    r#"{ "kind": "arrive", "by": 9, "from": 3 }"#,
    r#"{ "kind": "arrive", "by": 0, "weight": 4 }"#,
    r#"{ "kind": "depart", "from": 2 }"#,
    r#"{ "kind": "before", "first": { "agent": "A1", "cell": [2, 0] },
         "second": { "agent": "A2", "cell": [2, 0] } }"#,
    r#"{ "kind": "no-waiting", "zone": "aisle, \"3\"" }"#,
    r#"{ "kind": "turns", "quarter": 1 }"#,
    r#"{ "kind": "avoid", "zone": "aisle, \"3\"", "weight": 2 }"#,
];

#[test]
fn every_kind_is_written_as_it_was_read() {
    let read = native::read_scene(&scene(AISLE, &ALL.join(","))).unwrap();
    assert!(Instance::new(read.clone()).is_ok());
    assert_eq!(
        native::read_scene(&native::write_scene(&read)),
        Ok(read.clone())
    );
    let text = link::scene::write(&read);
    let mut linked = Scene::default();
    for part in text.split('&').skip(1) {
        let (key, value) = part.split_once('=').unwrap();
        link::scene::read(&mut linked, key, value).unwrap();
    }
    assert_eq!(linked, read);
    let sentences: Vec<String> = read.constraints.iter().map(Constraint::sentence).collect();
    for (i, sentence) in sentences.iter().enumerate() {
        assert!(!sentences[..i].contains(sentence), "{sentence}");
    }
}

#[test]
fn faults_name_their_place() {
    let zone = |text: &str| scene(text, "");
    let rule = |text: &str| scene(AISLE, text);
    for (text, place) in [
        (
            zone(r#"{ "name": "", "cells": [[0, 0]] }"#),
            "zones[0].name",
        ),
        (zone(r#"{ "name": "a", "cells": [] }"#), "zones[0].cells"),
        (zone(r#"{ "name": "a" }"#), "zones[0]"),
        (
            zone(r#"{ "name": "a", "cells": [[0, 0], [0, 0]] }"#),
            "zones[0].cells[1]",
        ),
        (
            zone(r#"{ "name": "a", "cells": [[9, 0]] }"#),
            "zones[0].cells[0]",
        ),
        (
            zone(r#"{ "name": "a", "rect": [2, 0, 1, 0] }"#),
            "zones[0].rect",
        ),
        (
            zone(r#"{ "name": "a", "rect": [0, 0, 4294967295, 4294967295] }"#),
            "zones[0].rect",
        ),
        (zone(&format!("{AISLE}, {AISLE}")), "zones[1].name"),
        (
            rule(r#"{ "kind": "closed", "zone": "aisle" }"#),
            "constraints[0].zone",
        ),
        (
            rule(r#"{ "kind": "gap", "steps": 0 }"#),
            "constraints[0].steps",
        ),
        (
            rule(r#"{ "kind": "gap", "steps": 4294967295 }"#),
            "constraints[0].steps",
        ),
        (
            rule(r#"{ "kind": "apart", "distance": 1 }"#),
            "constraints[0].distance",
        ),
        (
            rule(r#"{ "kind": "apart", "distance": 2, "from": 3, "to": 2 }"#),
            "constraints[0].from",
        ),
        (
            rule(r#"{ "kind": "turns", "quarter": 1, "agents": [] }"#),
            "constraints[0].agents",
        ),
        (
            rule(r#"{ "kind": "turns", "quarter": 1, "agents": ["B"] }"#),
            "constraints[0].agents[0]",
        ),
        (
            rule(r#"{ "kind": "one-way", "lane": [[0, 0], [2, 0]] }"#),
            "constraints[0].lane[1]",
        ),
        (
            rule(r#"{ "kind": "one-way", "lane": [[0, 0]] }"#),
            "constraints[0].lane",
        ),
        (
            rule(r#"{ "kind": "one-way", "lane": [[1, 0], [1, 1]] }"#),
            "constraints[0].lane[1]",
        ),
        (
            rule(r#"{ "kind": "visit", "cell": [1, 1] }"#),
            "constraints[0].cell",
        ),
        (
            rule(r#"{ "kind": "visit", "cell": [0, 0], "stay": 3, "from": 1, "to": 3 }"#),
            "constraints[0].stay",
        ),
        (
            rule(r#"{ "kind": "sequence", "agent": "A3", "cells": [[0, 0]] }"#),
            "constraints[0].agent",
        ),
        (
            rule(r#"{ "kind": "avoid", "zone": "aisle, \"3\"", "weight": 0 }"#),
            "constraints[0].weight",
        ),
    ] {
        let faults = native::read_instance(&text).unwrap_err();
        assert_eq!(faults[0].place, place, "{text}: {faults:?}");
        assert!(faults[0].line.is_some(), "{faults:?}");
    }
}

#[test]
fn keys_belong_to_their_kind() {
    for (text, found) in [
        (
            r#"{ "kind": "gap", "steps": 1, "from": 2 }"#,
            "the unknown key \"from\"",
        ),
        (r#"{ "kind": "gap" }"#, "no key \"steps\""),
        (r#"{ "kind": "arrive" }"#, "no key \"by\""),
        (
            r#"{ "kind": "arrive", "from": 1, "by": 2, "weight": 1 }"#,
            "the unknown key \"weight\"",
        ),
        (
            r#"{ "kind": "sequence", "agent": "A1", "cells": [[0, 0]], "agents": ["A1"] }"#,
            "the unknown key \"agents\"",
        ),
        (
            r#"{ "kind": "gap", "steps": 1, "off": true, "note": "" }"#,
            "the unknown key \"note\"",
        ),
        (r#"{ "kind": "wide" }"#, "\"wide\""),
    ] {
        let fault = native::read_scene(&scene(AISLE, text)).unwrap_err();
        assert!(fault.found.contains(found), "{text}: {fault}");
        assert!(fault.place.starts_with("constraints[0]"), "{fault}");
    }
}

#[test]
fn a_scene_that_is_edited_keeps_only_rules_of_what_is_there() {
    let mut scene = native::read_scene(&scene(AISLE, &ALL.join(","))).unwrap();
    scene.agents.pop();
    scene.rename_in_rules("A1", "B1");
    scene.agents[0].name = "B1".into();
    scene.map = vec!["..".into()];
    scene.settle_rules(&Grid::from_rows(&scene.map).unwrap());
    assert_eq!(scene.zones[0].rect, Some([1, 0, 1, 0]));
    assert!(scene.zones[0].has(Cell::new(1, 0)));
    let kinds: Vec<&str> = scene
        .constraints
        .iter()
        .map(Constraint::kind_name)
        .collect();
    assert_eq!(
        kinds,
        [
            "capacity",
            "closed",
            "gap",
            "apart",
            "arrive",
            "arrive",
            "depart",
            "no-waiting",
            "turns",
            "avoid"
        ]
    );
}
