//! The timeline's row of rules.

use giveway_model::Scene;

use super::{act, marked, scene, solved};
use crate::board::{Cast, Kind, legend};
use crate::reduce::tests::after;
use crate::rules::{Lit, RuleAction, Value, card, in_lit_zone, times_row};
use crate::steering::Lead;
use crate::{Action, BoardAction, Draft, Selection, State};

fn with(rules: &str) -> State {
    let mut text = serde_json::to_value(scene()).unwrap();
    text["zones"] = serde_json::json!([{ "name": "far", "cells": [[6, 0]] }]);
    text["constraints"] = serde_json::from_str(rules).unwrap();
    let scene: Scene = serde_json::from_value(text).unwrap();
    solved(&State::new(Draft::new(scene).unwrap()))
}

#[test]
fn rules_on_top_of_each_other_get_lines_and_more_than_three_fold() {
    let closed = |from: u32, to: u32| {
        format!(r#"{{ "kind": "closed", "zone": "far", "from": {from}, "to": {to} }}"#)
    };
    let rules = [
        closed(0, 3),
        closed(2, 5),
        closed(4, 1_000_000),
        closed(5, 6),
        closed(6, 7),
    ];
    let off = r#"{ "kind": "closed", "zone": "far", "from": 1, "to": 2, "off": true }"#;
    let always = r#"{ "kind": "capacity", "zone": "far", "most": 1 }"#;
    let state = with(&format!("[{}, {off}, {always}]", rules.join(", ")));
    let row = times_row(&state, 8).unwrap();
    let told: Vec<Vec<(usize, u32, u32)>> = row
        .lines
        .iter()
        .map(|line| line.iter().map(|of| (of.rule, of.from, of.to)).collect())
        .collect();
    assert_eq!(
        told,
        [
            vec![(0, 0, 3), (2, 4, 8)],
            vec![(1, 2, 5), (4, 6, 7)],
            vec![(3, 5, 6)]
        ]
    );
    assert_eq!((row.hidden, row.is_open), (0, false));
    assert!(row.lines[0][0].is_now && !row.lines[0][1].is_now);
    let four = [closed(0, 8), closed(0, 8), closed(0, 8), closed(0, 8)];
    let state = with(&format!("[{}]", four.join(", ")));
    let row = times_row(&state, 8).unwrap();
    assert_eq!((row.lines.len(), row.hidden), (3, 1));
    let open = after(&state, [act(RuleAction::AllTimes(true))]);
    let row = times_row(&open, 8).unwrap();
    assert_eq!((row.lines.len(), row.hidden, row.is_open), (4, 0, true));
    assert_eq!(times_row(&with(&format!("[{always}]")), 8), None);
}

#[test]
fn a_lit_zone_shows_who_is_in_it_when() {
    let state = marked();
    assert_eq!(state.lit_rule(), Some(&Lit::Zone("zone 1".into())));
    let stays = card(&state).unwrap().stays;
    for stay in &stays {
        let times = in_lit_zone(&state, &stay.name);
        assert_eq!(times.len(), 1, "{times:?}");
        assert_eq!(stay.when, format!("from {} to {}", times[0].0, times[0].1));
    }
    assert!(in_lit_zone(&state, "A3").is_empty());
    let explains = |state: &State| legend(state, &Cast::of(state)).contains(&Kind::InZone);
    assert!(explains(&state), "the legend says what the lines are");
    let dark = after(&state, [act(RuleAction::Light(None))]);
    assert!(!explains(&dark));
    assert!(in_lit_zone(&dark, "A1").is_empty());
}

#[test]
fn a_zone_is_lit_everywhere_while_its_tab_is_looked_at() {
    let state = with(r#"[{ "kind": "closed", "zone": "far", "from": 2, "to": 4 }]"#);
    let over = |is_over| act(RuleAction::OverZone("far".to_owned(), is_over));
    let lit = |state: &State| {
        let shapes = crate::board::rule_shapes(
            &state.document.draft,
            &crate::board::rules_now(state, state.world()),
            state.lit_rule(),
        );
        let row = times_row(state, 8).unwrap();
        let listed = crate::rules::list(state).unwrap();
        (
            shapes.zones[0].is_lit,
            row.lines[0][0].is_lit,
            listed.rows[0].is_lit,
        )
    };
    assert_eq!(lit(&state), (false, false, false));
    let seen = after(&state, [over(true)]);
    assert_eq!(lit(&seen), (true, true, true));
    assert_eq!(lit(&after(&seen, [over(false)])), (false, false, false));
    // Its rule, lit by a press, stays lit when the pointer goes.
    let pressed = act(RuleAction::OfTab("far".to_owned()));
    let left = after(&seen, [pressed, over(true), over(false)]);
    assert_eq!(left.lit_rule(), Some(&Lit::Rule(0)));
    assert_eq!(lit(&left), (true, true, true));
    // The pointer that leaves one zone does not darken another one.
    let other = act(RuleAction::OverZone("elsewhere".to_owned(), false));
    assert_eq!(lit(&after(&seen, [other])), (true, true, true));
}

#[test]
fn a_step_by_hand_against_a_rule_is_marked() {
    let state = with(r#"[{ "kind": "closed", "zone": "far", "from": 0, "to": 1000000 }]"#);
    assert!(crate::rules::broken(&state).next().is_none());
    let mut actions = vec![
        Action::Board(BoardAction::Select(Selection::Agent(1))),
        Action::Steer(Lead::Begin),
    ];
    // From (1, 0) to (6, 0).
    actions.extend((0..5).map(|_| Action::Steer(Lead::Step((1, 0)))));
    let led = after(&state, actions);
    let own = led.document.mode.steering().unwrap();
    assert_eq!(own.cell(), giveway_model::Cell::new(6, 0));
    let now = crate::board::rules_now(&led, led.world());
    assert_eq!(now.broken, [0]);
    let row = times_row(&led, led.last_time()).unwrap();
    assert_eq!(row.lines[0][0].broken, [5]);
    assert!(row.lines[0][0].label.ends_with("broken at 5"), "{row:?}");
}

#[test]
fn a_rule_is_shown_open_in_the_list() {
    let state = after(
        &marked(),
        [
            act(RuleAction::Fill(Value::Number(0, 2))),
            act(RuleAction::Add),
        ],
    );
    let shown = after(&state, [act(RuleAction::Show(1))]);
    let list = crate::rules::list(&shown).unwrap();
    assert!(list.rows[1].is_open && list.rows[1].is_lit && !list.rows[0].is_open);
}
