//! Rules as sentences, and sentences as rules: the two are inverse.

use giveway_model::constraint::{MAX_NUMBER, meant};
use giveway_model::{Constraint, condition::Times, constraint::ConstraintKind};

/// Names that could be taken for other words of a rule.
const NAMES: [&str; 12] = [
    "A1",
    "A 2",
    "and",
    "12",
    "Each",
    "it's",
    "a, b and c",
    "Größe-3",
    "robots",
    "x.",
    "keep",
    "arrives",
];

/// Whom a rule binds.
fn agents() -> Vec<Option<Vec<String>>> {
    let mut all = vec![None];
    for (i, &name) in NAMES.iter().enumerate() {
        let next = NAMES[(i + 1) % NAMES.len()];
        let third = NAMES[(i + 5) % NAMES.len()];
        let names = |names: &[&str]| Some(names.iter().map(|&name| name.to_owned()).collect());
        all.extend([
            names(&[name]),
            names(&[name, next]),
            names(&[next, name, third]),
        ]);
    }
    all
}

/// Rules of every kind in JSON, without whom they bind.
fn kinds() -> Vec<String> {
    let times = [
        "",
        r#", "from": 3"#,
        r#", "to": 5"#,
        r#", "from": 3, "to": 5"#,
    ];
    let mut all = Vec::new();
    for zone in ["aisle 3", "it's \\\"3\\\"", "''", "in 'x'"] {
        for times in times {
            all.push(format!(
                r#"{{ "kind": "capacity", "zone": "{zone}", "most": 1{times} }}"#
            ));
            all.push(format!(
                r#"{{ "kind": "capacity", "zone": "{zone}", "most": 2{times} }}"#
            ));
            all.push(format!(
                r#"{{ "kind": "closed", "zone": "{zone}"{times} }}"#
            ));
        }
        for most in ["", r#", "most": 1"#, r#", "most": 7"#] {
            all.push(format!(
                r#"{{ "kind": "no-waiting", "zone": "{zone}"{most} }}"#
            ));
        }
        all.push(format!(
            r#"{{ "kind": "avoid", "zone": "{zone}", "weight": 4 }}"#
        ));
    }
    for times in times {
        all.push(format!(r#"{{ "kind": "apart", "distance": 2{times} }}"#));
        for stay in ["", r#", "stay": 1"#, r#", "stay": 2"#] {
            all.push(format!(
                r#"{{ "kind": "visit", "cell": [4, 0]{stay}{times} }}"#
            ));
        }
    }
    let others = [
        r#"{ "kind": "one-way", "lane": [[4, 0], [3, 0], [2, 0]] }"#,
        r#"{ "kind": "one-way", "lane": [[4, 2], [4, 3]] }"#,
        r#"{ "kind": "one-way", "lane": [[4, 2], [4, 3], [5, 3]] }"#,
        r#"{ "kind": "gap", "steps": 1 }"#,
        r#"{ "kind": "gap", "steps": 2 }"#,
        r#"{ "kind": "arrive", "by": 3 }"#,
        r#"{ "kind": "arrive", "from": 3 }"#,
        r#"{ "kind": "arrive", "by": 7, "from": 3 }"#,
        r#"{ "kind": "arrive", "by": 7, "weight": 2 }"#,
        r#"{ "kind": "depart", "from": 2 }"#,
        r#"{ "kind": "turns", "quarter": 1 }"#,
        r#"{ "kind": "turns", "quarter": 3 }"#,
    ];
    all.extend(others.map(str::to_owned));
    all
}

#[track_caller]
fn check(rule: &Constraint) {
    let sentence = rule.sentence();
    let read = Constraint::from_words(&sentence);
    assert_eq!(read.as_ref(), Ok(rule), "{sentence}");
    // A full stop, and capital letters but in names, make no difference.
    assert_eq!(Constraint::from_words(&format!(" {sentence}. ")), read);
}

#[test]
fn what_is_said_is_read_as_it_was_meant() {
    for kind in kinds() {
        let rule: Constraint = serde_json::from_str(&kind).unwrap();
        for agents in agents() {
            check(&Constraint {
                agents,
                ..rule.clone()
            });
        }
    }
    for one in NAMES {
        for other in NAMES {
            let one = one.replace('"', "\\\"");
            check(
                &serde_json::from_str(&format!(
                    r#"{{ "kind": "sequence", "agent": "{one}", "cells": [[1, 0], [2, 1], [1, 0]] }}"#
                ))
                .unwrap(),
            );
            check(
                &serde_json::from_str(&format!(
                    r#"{{ "kind": "before", "first": {{ "agent": "{one}", "cell": [2, 0] }},
                          "second": {{ "agent": "{other}", "cell": [3, 0] }} }}"#
                ))
                .unwrap(),
            );
        }
    }
}

#[test]
fn for_ever_and_always_are_left_out() {
    let closed = |times| ConstraintKind::Closed {
        zone: "z".to_owned(),
        times,
    };
    let always = Times {
        from: Some(0),
        to: Some(MAX_NUMBER),
    };
    assert_eq!(meant(always).to, None);
    let rule = Constraint {
        kind: closed(always),
        agents: None,
        name: None,
        off: false,
    };
    assert_eq!(rule.sentence(), "No robot in 'z'");
    let read = Constraint::from_words("no robot in 'z' always").unwrap();
    assert_eq!(read.kind, closed(Times::default()));
}

#[test]
fn what_is_no_rule_names_the_word_where_it_stops_to_be_one() {
    let fault = |text: &str| {
        let fault = Constraint::from_words(text).unwrap_err();
        format!("{} | {}", fault.found, fault.expected)
    };
    assert_eq!(fault("at most"), "the end of the rule | a whole number");
    assert_eq!(
        fault("at most 1 robot in aisle"),
        "\"aisle\" | the name of a zone in single quotes"
    );
    assert_eq!(
        fault("no robot in 'a' from 3"),
        "the end of the rule | \"to\""
    );
    assert_eq!(
        fault("one way from (1, 2) to (3, 4)"),
        "\"to\" | the end of a straight lane, or \"along\" and all cells"
    );
    assert_eq!(fault("A1 arrives by 3 4"), "4 | no more words");
    assert_eq!(
        fault("at most 4294967296 robots in 'a'"),
        "\"4294967296\" | a whole number"
    );
    assert_eq!(
        fault(""),
        "the end of the rule | a rule such as \"At most 1 robot in 'aisle 3'\" or \"A1 arrives by 12\""
    );
    assert!(fault("whatever").contains("what a robot does"));
}
