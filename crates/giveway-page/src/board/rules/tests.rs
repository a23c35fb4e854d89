//! What rules put on the board.

use giveway_model::Cell;

use giveway_picture::first_stay;

use super::{RulesNow, SignKind, in_force, rule_shapes};
use crate::Draft;
use crate::rules::Lit;

/// An aisle with rules, a hall, a lane, a deadline.
fn draft(rules: &str) -> Draft {
    let text = format!(
        r###"{{ "giveway": 1,
          "map": [".......", "##.#.##", "##.#.##", "##.#.##", "......."],
          "agents": [{{ "name": "A1", "start": [0, 0], "goal": [0, 4] }},
                     {{ "name": "A2", "start": [1, 0], "goal": [3, 4] }}],
          "zones": [{{ "name": "aisle", "rect": [2, 1, 2, 3] }},
                    {{ "name": "hall", "cells": [[4, 0], [5, 0]] }}],
          "constraints": [{rules}] }}"###
    );
    Draft::new(serde_json::from_str(&text).unwrap()).unwrap()
}

fn holds(scene: &giveway_model::Scene, time: u32) -> RulesNow {
    RulesNow {
        holds: in_force(&scene.constraints, time),
        ..RulesNow::default()
    }
}

#[test]
fn a_tab_stays_off_what_a_cell_is_called() {
    // The upper edge of the hall lies below free cells; one of them is a goal.
    let text = r#"{ "giveway": 1, "map": ["....", "....", "...."],
        "agents": [{ "name": "A1", "start": [0, 2], "goal": [1, 0] }],
        "zones": [{ "name": "hall", "cells": [[1, 1], [2, 1], [3, 1]] }] }"#;
    let draft = Draft::new(serde_json::from_str(text).unwrap()).unwrap();
    let shapes = rule_shapes(&draft, &RulesNow::default(), None);
    assert_eq!(shapes.zones[0].tab, (222.0, 80.0), "one cell further on");
}

#[test]
fn what_is_broken_is_red_and_a_stay_counts_down() {
    let draft = draft(
        r#"{ "kind": "capacity", "zone": "aisle", "most": 1 },
           { "kind": "visit", "cell": [6, 0], "stay": 3 }"#,
    );
    let now = RulesNow {
        broken: vec![0],
        stays: vec![(Cell::new(6, 0), 2)],
        ..RulesNow::default()
    };
    let shapes = rule_shapes(&draft, &now, None);
    let red: Vec<bool> = shapes.zones.iter().map(|zone| zone.is_broken).collect();
    assert_eq!(red, [true, false]);
    let tags: Vec<(&str, &str)> = shapes
        .tags
        .iter()
        .map(|tag| (&*tag.text, tag.class))
        .collect();
    assert_eq!(tags, [("2", "stay now")]);
}

#[test]
fn the_first_stay_that_is_long_enough_counts() {
    use giveway_model::condition::Times;
    let (here, there) = (Cell::new(1, 0), Cell::new(2, 0));
    let path: Vec<Option<Cell>> = [here, here, there, here, here, here, there]
        .map(Some)
        .into();
    let first = |stay, from| {
        let times = Times { from, to: None };
        first_stay(&path, here, stay, times)
    };
    assert_eq!(
        [
            first(0, None),
            first(1, None),
            first(2, None),
            first(3, None)
        ],
        [Some(0), Some(0), Some(3), None]
    );
    assert_eq!(first(1, Some(1)), Some(3));
    // Who rests at the cell goes on to stay.
    assert_eq!(first_stay(&path[..6], here, 9, Times::default()), Some(3));
}

#[test]
fn a_zone_has_a_sign_for_each_rule_and_one_for_many() {
    let rules = r#"{ "kind": "capacity", "zone": "aisle", "most": 1 },
        { "kind": "closed", "zone": "aisle", "from": 3, "to": 5 },
        { "kind": "no-waiting", "zone": "aisle", "off": true }"#;
    let two = draft(rules);
    let shapes = rule_shapes(&two, &holds(two.scene(), 0), None);
    let [aisle, hall] = &shapes.zones[..] else {
        panic!("{shapes:?}");
    };
    assert_eq!(aisle.signs, [SignKind::Ring("1".into()), SignKind::Bar]);
    assert_eq!(aisle.times.as_deref(), Some("3\u{2013}5"));
    assert_eq!(hall.signs, [SignKind::Dot], "no rule of it is in force");
    assert_eq!(aisle.tab, (303.0, 128.0), "on the shelf to its right");
    let closed = |time| rule_shapes(&two, &holds(two.scene(), time), None).zones[0].is_closed;
    let times: Vec<bool> = (2..=6).map(closed).collect();
    assert_eq!(
        times,
        [false, true, true, true, false],
        "both ends included"
    );
    let more = format!(
        r#"{rules}, {{ "kind": "avoid", "zone": "aisle", "weight": 2 }},
        {{ "kind": "no-waiting", "zone": "aisle" }}"#
    );
    let many = draft(&more);
    let shapes = rule_shapes(&many, &holds(many.scene(), 0), None);
    assert_eq!(shapes.zones[0].signs, [SignKind::Ring("+4".into())]);
}

#[test]
fn what_is_looked_at_is_lit() {
    let rules = r#"{ "kind": "capacity", "zone": "aisle", "most": 1 }, { "kind": "one-way", "lane": [[4, 0], [3, 0], [3, 0]] }"#;
    let draft = draft(&rules.replace(", [3, 0]]", "]"));
    let lit = |lit: Lit| {
        let shapes = rule_shapes(&draft, &RulesNow::default(), Some(&lit));
        let zones: Vec<bool> = shapes.zones.iter().map(|zone| zone.is_lit).collect();
        (zones, shapes.lanes[0].is_lit)
    };
    assert_eq!(lit(Lit::Rule(0)), (vec![true, false], false));
    assert_eq!(lit(Lit::Zone("hall".into())), (vec![false, true], false));
    assert_eq!(lit(Lit::Rule(1)), (vec![false, false], true));
}

#[test]
fn lanes_have_chevrons_and_deadlines_tags() {
    let rules = r#"{ "kind": "one-way", "lane": [[0, 0], [1, 0], [2, 0], [2, 1]] },
        { "kind": "arrive", "by": 12, "agents": ["A2"] },
        { "kind": "depart", "from": 5, "agents": ["A1"] },
        { "kind": "sequence", "agent": "A1", "cells": [[2, 2], [3, 4]] },
        { "kind": "arrive", "by": 3, "off": true }"#;
    let draft = draft(rules);
    let shapes = rule_shapes(&draft, &RulesNow::default(), None);
    assert_eq!(
        shapes.lanes[0].borders,
        [(100, 50, 0), (200, 50, 0), (250, 100, 90)]
    );
    let tags: Vec<(Cell, &str, &str)> = shapes
        .tags
        .iter()
        .map(|tag| (tag.cell, &*tag.text, tag.class))
        .collect();
    assert_eq!(
        tags,
        [
            (Cell::new(3, 4), "by 12", "late"),
            (Cell::new(0, 0), "from 5", "early"),
            (Cell::new(2, 2), "1", "order"),
            (Cell::new(3, 4), "2", "order"),
        ]
    );
}
