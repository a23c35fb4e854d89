//! Rules that leave no plan are marked where they are: on the board, in the list, at their times.

use giveway_model::Question;

use super::{act, solved};
use crate::board::{Cast, Kind, kept_free, legend, reasons, rule_shapes, rules_now};
use crate::reduce::tests::after;
use crate::rules::{RuleAction, clash_times, in_clash_robots, list, short_way};
use crate::tests::answered;
use crate::{Action, AskAction, Draft, PlayAction, SolveAction, State, Tab, ViewAction};

/// The aisle is closed until 12, A1 has to arrive by 9: it has to pass the aisle, which takes it 10
/// steps at least.
fn scene() -> giveway_model::Scene {
    let mut scene = super::scene();
    scene.zones = vec![serde_json::from_str(r#"{ "name": "all", "rect": [2, 1, 4, 3] }"#).unwrap()];
    for rule in [
        r#"{ "kind": "closed", "zone": "all", "from": 2, "to": 12, "agents": ["A1"] }"#,
        r#"{ "kind": "arrive", "by": 9, "agents": ["A1"] }"#,
        r#"{ "kind": "capacity", "zone": "all", "most": 9 }"#,
    ] {
        scene.constraints.push(serde_json::from_str(rule).unwrap());
    }
    scene
}

fn stuck() -> State {
    let state = solved(&State::new(Draft::new(scene()).unwrap()));
    assert!(state.document.fresh_answer().unwrap().plan().is_none());
    state
}

fn asked() -> State {
    let ask = Action::Ask(AskAction::Ask(Question::Unsolvable));
    answered(&after(&stuck(), [ask]))
}

#[test]
fn rules_that_leave_no_plan_are_red_at_their_signs() {
    assert!(
        rules_now(&stuck(), stuck().world()).broken.is_empty(),
        "nobody asked why"
    );
    let state = asked();
    assert_eq!(rules_now(&state, state.world()).broken, [1, 2]);
    let shapes = rule_shapes(
        &state.document.draft,
        &rules_now(&state, state.world()),
        None,
    );
    assert!(shapes.zones[0].is_broken);
    let tags: Vec<(&str, bool)> = shapes
        .tags
        .iter()
        .map(|tag| (&*tag.text, tag.is_broken))
        .collect();
    assert_eq!(tags, [("by 9", true)]);
    // Each has its number there, as in the list of facts.
    let numbers: Vec<usize> = reasons(&state)
        .spots
        .iter()
        .map(|spot| spot.number)
        .collect();
    assert!(numbers.len() >= 2, "{numbers:?}");
}

#[test]
fn a_phone_has_a_tab_for_their_times() {
    assert!(!stuck().has_timeline(), "nobody asked why");
    let plan = Action::View(ViewAction::ShowTab(Tab::Plan));
    let asked = after(&asked(), [plan]);
    assert!(asked.has_timeline() && clash_times(&asked).is_some());
    // There is no plan to stand in a table.
    assert_eq!(asked.shown_tab(), Tab::Inspector);
    let times = after(&asked, [Action::View(ViewAction::ShowTab(Tab::Timeline))]);
    assert_eq!(times.shown_tab(), Tab::Timeline);
    // While a search goes on its bounds stand there.
    let searching = after(&times, [Action::Solve(SolveAction::Solve)]);
    assert!(searching.awaited().is_some() && !searching.has_timeline());
}

#[test]
fn the_shortest_way_of_the_robot_that_has_no_plan_is_shown() {
    assert!(in_clash_robots(&stuck()).is_empty(), "nobody asked why");
    let state = asked();
    assert_eq!(in_clash_robots(&state), [0]);
    let way = short_way(&state.document.draft, 0);
    let agent = &state.document.draft.agents()[0];
    assert_eq!(way.first(), Some(&agent.start));
    assert_eq!(way.last().copied(), agent.goal);
    let is_step = |pair: &[giveway_model::Cell]| {
        pair[0].x.abs_diff(pair[1].x) + pair[0].y.abs_diff(pair[1].y) == 1
    };
    assert!(way.windows(2).all(is_step), "{way:?}");
    let grid = state.document.draft.grid();
    assert!(
        way.iter()
            .all(|&cell| grid.ground(cell).unwrap().is_vertex())
    );
    // As long as the row of the deadline says: `its way takes at least 10 steps`.
    let note = clash_times(&state)
        .unwrap()
        .rows
        .into_iter()
        .find_map(|row| row.note);
    assert_eq!(
        note.unwrap(),
        format!("its way takes at least {} steps", way.len() - 1)
    );
    let kinds = legend(&state, &Cast::of(&state));
    assert!(kinds.contains(&Kind::Shortest));
    let off = after(&state, [act(RuleAction::Switch(1))]);
    assert!(in_clash_robots(&off).is_empty(), "another scene");
}

#[test]
fn a_short_way_goes_over_the_waypoints_in_the_order_of_a_rule() {
    let mut scene: giveway_model::Scene = serde_json::from_str(
        r#"{ "giveway": 1, "map": ["......"],
             "agents": [{ "name": "A1", "start": [2, 0], "goal": [2, 0], "waypoints": [[1, 0], [5, 0]] }] }"#,
    )
    .unwrap();
    let columns = |scene: &giveway_model::Scene| {
        let way = short_way(&Draft::new(scene.clone()).unwrap(), 0);
        way.into_iter().map(|cell| cell.x).collect::<Vec<_>>()
    };
    assert_eq!(
        columns(&scene),
        [2, 1, 2, 3, 4, 5, 4, 3, 2],
        "the nearest first"
    );
    let rule = r#"{ "kind": "sequence", "agent": "A1", "cells": [[5, 0], [1, 0]] }"#;
    scene.constraints = vec![serde_json::from_str(rule).unwrap()];
    assert_eq!(columns(&scene), [2, 3, 4, 5, 4, 3, 2, 1, 2]);
    scene.map = vec!["...#..".into()];
    assert_eq!(columns(&scene), [0; 0], "there is no way");
}

#[test]
fn they_stay_marked_when_the_question_is_left_and_go_with_the_clash() {
    let left = after(&asked(), [Action::Ask(AskAction::Close)]);
    assert_eq!(rules_now(&left, left.world()).broken, [1, 2]);
    let told: Vec<Option<String>> = list(&left)
        .unwrap()
        .rows
        .into_iter()
        .map(|row| row.broken)
        .collect();
    let part = Some("part of why there is no plan".to_owned());
    assert_eq!(told, [None, part.clone(), part, None]);
    let off = after(&left, [act(RuleAction::Switch(1))]);
    assert!(
        rules_now(&off, off.world()).broken.is_empty(),
        "another scene"
    );
    assert!(clash_times(&off).is_none());
    let back = after(&off, [Action::Undo]);
    assert_eq!(rules_now(&back, back.world()).broken, [1, 2]);
}

#[test]
fn their_times_stand_in_the_place_of_the_lanes() {
    let shown = clash_times(&asked()).unwrap();
    let rows: Vec<_> = shown
        .rows
        .iter()
        .map(|row| (&*row.title, row.what, row.times, row.ends, row.agent))
        .collect();
    assert_eq!(
        rows,
        [
            ("all", "closed", Some((2, 12)), None, None),
            ("A1", "may arrive", Some((8, 9)), Some(9), Some(0)),
        ]
    );
    assert_eq!(shown.last, 15);
    assert_eq!(
        shown.rows[1].note.as_deref(),
        Some("its way takes at least 8 steps")
    );
    assert!(clash_times(&stuck()).is_none());
}

#[test]
fn a_gap_and_a_distance_are_seen_when_looked_at() {
    let mut scene = super::scene();
    for rule in [
        r#"{ "kind": "gap", "steps": 2 }"#,
        r#"{ "kind": "apart", "distance": 2, "agents": ["A1", "A3"] }"#,
    ] {
        scene.constraints.push(serde_json::from_str(rule).unwrap());
    }
    let state = solved(&State::new(Draft::new(scene).unwrap()));
    assert!(kept_free(&state).is_empty(), "quiet until looked at");
    let light = |rule| {
        let lit = Some(crate::rules::Lit::Rule(rule));
        let at = Action::Play(PlayAction::Seek(2));
        kept_free(&after(&state, [act(RuleAction::Light(lit)), at]))
    };
    assert!(light(0).is_empty(), "a lane keeps no cells free");
    let plan = state.plan().unwrap().clone();
    // Behind each robot that has moved in the last two steps.
    let moved = |name: &str| {
        let path = plan.path(name);
        path[..2].iter().any(|at| *at != path[2])
    };
    let moving: Vec<usize> = [(0, "A1"), (1, "A2"), (2, "A3")]
        .into_iter()
        .filter(|(_, name)| moved(name))
        .map(|(agent, _)| agent)
        .collect();
    let agents = |rule| -> Vec<usize> { light(rule).iter().map(|kept| kept.agent).collect() };
    assert_eq!(agents(1), moving);
    assert!(!moving.is_empty());
    assert_eq!(agents(2), [0, 2], "around those that it binds");
}
