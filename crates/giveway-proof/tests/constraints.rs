//! Rules of a scene's own in certificates: what they say of times after the last one of a
//! formula, and of robots that rest or vanish.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::format::native;
use giveway_model::{Condition, Cost, Instance};
use giveway_proof::exhaust::{Exhausted, exhaust_kind, least};
use giveway_proof::{Budget, Claim, Outcome, plain, prove};

/// Whether there is a plan of at most a makespan: one robot goes from the left end of a
/// corridor of four cells to the right one, under a rule.
fn has_plan(rule: &str, vanish: bool, last: u32) -> bool {
    let claim = Claim::default().within(Some(last));
    let formula = plain::formula(&corridor(rule, vanish), &claim, &Budget::default()).unwrap();
    match prove(&formula, &Budget::default()) {
        Outcome::Satisfiable => true,
        Outcome::Proof(_) => false,
        Outcome::Stopped => panic!("too large"),
    }
}

fn corridor(rule: &str, vanish: bool) -> Instance {
    let rules = if vanish { "vanish" } else { "stay" };
    let scene = format!(
        r#"{{ "giveway": 1, "map": ["...."], "rules": {{ "at_goal": "{rules}" }},
            "zones": [{{ "name": "end", "cells": [[3, 0]] }},
                      {{ "name": "middle", "cells": [[1, 0], [2, 0]] }}],
            "constraints": [{rule}],
            "agents": [{{ "name": "a", "start": [0, 0], "goal": [3, 0], "heading": "west" }}] }}"#
    );
    native::read_instance(&scene).unwrap_or_else(|faults| panic!("{faults:?} {scene}"))
}

/// The least makespan under a rule, by formulas and by a search of states.
fn makespan(rule: &str, vanish: bool) -> Option<u32> {
    let by_formula = (0..12).find(|&last| has_plan(rule, vanish, last));
    let budget = Budget {
        states: 20_000,
        ..Budget::default()
    };
    match least(&corridor(rule, vanish), 0, Cost::Makespan, &budget) {
        Exhausted::Plan(makespan) => assert_eq!(by_formula, Some(makespan), "{rule}"),
        Exhausted::NoPlan | Exhausted::Stopped => assert_eq!(by_formula, None, "{rule}"),
    }
    by_formula
}

#[test]
fn rules_hold_of_robots_at_rest_for_ever() {
    let closed = |times: &str| format!(r#"{{ "kind": "closed", "zone": "end"{times} }}"#);
    // The last of the times, and whether the end is closed to one who stays, or comes by.
    for (times, stays, vanishes) in [
        ("", None, None),
        (r#", "to": 1000000"#, None, None),
        (r#", "from": 40"#, None, Some(3)),
        (r#", "from": 40, "to": 41"#, Some(42), Some(3)),
        (r#", "from": 2, "to": 5"#, Some(6), Some(6)),
        (r#", "from": 4, "to": 5"#, Some(6), Some(3)),
    ] {
        let rule = closed(times);
        // It may come only later than the formulas here say.
        let in_time = stays.filter(|&makespan| makespan < 12);
        let far = has_plan(&rule, false, 42);
        assert_eq!(far, stays.is_some(), "{times}");
        if stays == Some(42) {
            assert!(!has_plan(&rule, false, 41), "{times}");
        } else {
            assert_eq!(makespan(&rule, false), in_time, "{times}");
        }
        assert_eq!(makespan(&rule, true), vanishes, "{times}");
    }
}

#[test]
fn a_rest_is_a_visit_and_a_robot_that_is_gone_makes_none() {
    let visit = |more: &str| format!(r#"{{ "kind": "visit", "cell": [3, 0], {more} }}"#);
    assert_eq!(makespan(&visit(r#""stay": 90"#), false), Some(3));
    assert_eq!(makespan(&visit(r#""stay": 2, "from": 60"#), false), Some(3));
    assert_eq!(makespan(&visit(r#""stay": 2, "to": 4"#), false), None);
    assert_eq!(makespan(&visit(r#""stay": 2, "to": 5"#), false), Some(3));
    // It stays before, and comes back.
    assert_eq!(makespan(&visit(r#""stay": 2"#), true), Some(7));
    assert_eq!(makespan(&visit(r#""stay": 0"#), true), Some(3));
}

#[test]
fn arrivals_and_departures_have_their_times() {
    for vanish in [false, true] {
        let arrive = |times: &str| format!(r#"{{ "kind": "arrive", {times} }}"#);
        assert_eq!(makespan(&arrive(r#""by": 2"#), vanish), None);
        assert_eq!(makespan(&arrive(r#""by": 3"#), vanish), Some(3));
        assert_eq!(makespan(&arrive(r#""from": 6"#), vanish), Some(6));
        assert!(!has_plan(&arrive(r#""from": 20"#), vanish, 10));
        let depart = r#"{ "kind": "depart", "from": 4 }"#;
        assert_eq!(makespan(depart, vanish), Some(7));
        let depart = r#"{ "kind": "depart", "from": 1000000 }"#;
        assert!(!has_plan(depart, vanish, 10));
    }
}

#[test]
fn turns_begin_at_the_heading() {
    assert_eq!(
        makespan(r#"{ "kind": "turns", "quarter": 1 }"#, false),
        Some(5)
    );
    assert_eq!(
        makespan(r#"{ "kind": "turns", "quarter": 3 }"#, false),
        Some(9)
    );
    assert!(!has_plan(
        r#"{ "kind": "turns", "quarter": 1000000 }"#,
        false,
        10
    ));
    let off = r#"{ "kind": "turns", "quarter": 3, "off": true }"#;
    assert_eq!(makespan(off, false), Some(3));
}

#[test]
fn a_penalty_is_limited_as_it_is_weighed() {
    let rules = r#"{ "kind": "avoid", "zone": "middle", "weight": 1000000 },
        { "kind": "arrive", "by": 1, "weight": 7 }, { "kind": "depart", "from": 1 }"#;
    // Two times in the middle, and arrived at 4.
    for vanish in [false, true] {
        let instance = corridor(rules, vanish);
        for (most, is_enough) in [(0, false), (2_000_020, false), (2_000_021, true)] {
            let claim = Claim {
                most: BTreeMap::from([(Cost::Penalty, most)]),
                ..Claim::default().within(Some(9))
            };
            let formula = plain::formula(&instance, &claim, &Budget::default()).unwrap();
            let outcome = prove(&formula, &Budget::default());
            assert_eq!(outcome == Outcome::Satisfiable, is_enough, "{most}");
        }
        let least = least(&instance, 0, Cost::Penalty, &Budget::default());
        assert_eq!(least, Exhausted::Plan(2_000_021));
    }
}

#[test]
fn a_claim_about_a_rule_is_one_of_the_scene_with_it() {
    let rule = r#"{ "kind": "visit", "cell": [1, 0], "stay": 1 }"#;
    let about = |horizon| Claim {
        condition: Some(Condition::Keeps(Box::new(
            serde_json::from_str(rule).unwrap(),
        ))),
        ..Claim::default().within(Some(horizon))
    };
    let (free, with) = (corridor("", false), corridor(rule, false));
    for horizon in [3, 4] {
        let budget = Budget::default();
        let text = |instance: &Instance, claim: &Claim| {
            plain::formula(instance, claim, &budget).unwrap().text()
        };
        let plain = Claim::default().within(Some(horizon));
        assert_eq!(text(&free, &about(horizon)), text(&with, &plain));
        assert_ne!(text(&free, &about(horizon)), text(&free, &plain));
    }
    let sentence = about(3).sentence();
    let words = "this rule holds: \"Each robot stays 1 step at (1, 0)\"";
    assert!(sentence.contains(words), "{sentence}");
    // A rule of an unknown zone is none of a scene: nothing is proved about it.
    let unknown = r#"{ "kind": "closed", "zone": "attic" }"#;
    let claim = Claim {
        condition: Some(Condition::Keeps(Box::new(
            serde_json::from_str(unknown).unwrap(),
        ))),
        ..Claim::default().within(Some(9))
    };
    assert!(plain::formula(&free, &claim, &Budget::default()).is_err());
    assert_eq!(
        exhaust_kind(&free, &claim, &Budget::default()),
        Exhausted::Stopped
    );
}
