//! Zones and lanes that are marked on the board, by pointer and by keys.

use giveway_model::{Cell, Constraint};

use super::{act, fresh, marked, solved};
use crate::draw::{Shape, row};
use crate::reduce::tests::{after, stroke};
use crate::rules::{RuleAction, card};
use crate::{Action, BoardAction, State, Tool};

#[test]
fn a_zone_goes_on_is_taken_away_and_has_a_name() {
    let press = Action::Board(BoardAction::Press(Cell::new(2, 4)));
    let state = after(&marked(), [press, Action::Board(BoardAction::Release)]);
    assert_eq!(state.document.draft.scene().zones[0].cells().count(), 4);
    let state = after(
        &state,
        [
            Action::Board(BoardAction::Mark {
                cell: Cell::new(2, 4),
                takes: true,
                is_rect: false,
            }),
            Action::Board(BoardAction::Release),
            act(RuleAction::RenameZone("middle aisle".into())),
        ],
    );
    let zone = &state.document.draft.scene().zones[0];
    assert_eq!((&*zone.name, zone.cells().count()), ("middle aisle", 3));
    let shown = card(&state).unwrap();
    assert_eq!(shown.sentence, "At most 1 robot in middle aisle");
    let added = after(
        &state,
        [
            act(RuleAction::Add),
            act(RuleAction::OfZone("middle aisle".into())),
        ],
    );
    let renamed = after(&added, [act(RuleAction::RenameZone("x".into()))]);
    let told = renamed.document.draft.scene().constraints[1].sentence();
    assert_eq!(told, "At most 1 robot in 'x'", "its rules follow");
    let gone = after(&renamed, [act(RuleAction::RemoveZone)]);
    let scene = gone.document.draft.scene();
    assert!(scene.zones.is_empty() && scene.constraints.len() == 1 && card(&gone).is_none());
}

#[test]
fn a_rectangle_is_drawn_and_a_second_zone_begins() {
    let rect = |from, to| {
        vec![
            Action::Board(BoardAction::PickTool(Tool::Zone)),
            Action::Board(BoardAction::Mark {
                cell: from,
                takes: false,
                is_rect: true,
            }),
            Action::Board(BoardAction::Drag(vec![Cell::new(6, 4), to])),
            Action::Board(BoardAction::Release),
        ]
    };
    let state = after(&fresh(), rect(Cell::new(4, 1), Cell::new(5, 3)));
    assert_eq!(
        state.document.draft.scene().zones[0].cells().count(),
        6,
        "the last corner counts"
    );
    let state = after(&state, rect(Cell::new(0, 4), Cell::new(1, 4)));
    let names: Vec<&str> = state
        .document
        .draft
        .scene()
        .zones
        .iter()
        .map(|zone| &*zone.name)
        .collect();
    assert_eq!(names, ["zone 1", "zone 2"], "the tool was picked again");
}

#[test]
fn the_rectangle_is_a_shape_of_the_tool_zone() {
    let drawn = after(
        &fresh(),
        [
            Action::Board(BoardAction::PickTool(Tool::Zone)),
            Action::Board(BoardAction::PickShape(Shape::Rectangle)),
            Action::Board(BoardAction::Press(Cell::new(4, 1))),
            Action::Board(BoardAction::Drag(vec![Cell::new(5, 3)])),
            Action::Board(BoardAction::Release),
        ],
    );
    let zone = &drawn.document.draft.scene().zones[0];
    assert_eq!(zone.cells().count(), 6);
    assert_eq!(row(&drawn).unwrap().shapes, [Shape::Pen, Shape::Rectangle]);
}

#[test]
fn a_lane_is_led_taken_back_turned_and_ends_at_obstacles() {
    let lanes = |state: &State| -> Vec<String> {
        let rules = state.document.draft.scene().constraints.iter();
        rules.map(Constraint::sentence).collect()
    };
    let turned = after(&fresh(), stroke(Tool::OneWay, &[(3, 0), (2, 0)]));
    assert_eq!(lanes(&turned), ["One way from (5, 0) to (0, 0)"]);
    let same = after(&fresh(), stroke(Tool::OneWay, &[(2, 0), (3, 0)]));
    assert_eq!(same.document.draft, fresh().document.draft);
    let new = after(&fresh(), stroke(Tool::OneWay, &[(4, 4), (6, 4), (5, 4)]));
    assert_eq!(
        lanes(&new)[1],
        "One way from (4, 4) to (5, 4)",
        "taken back"
    );
    let ended = after(
        &fresh(),
        stroke(Tool::OneWay, &[(2, 0), (2, 4), (2, 3), (3, 3)]),
    );
    assert_eq!(lanes(&ended)[1], "One way from (2, 0) to (2, 3)");
    let none = after(&fresh(), stroke(Tool::OneWay, &[(4, 4)]));
    assert_eq!(none.document.draft, fresh().document.draft);
    assert!(!none.history.can_undo());
}

#[test]
fn keys_mark_and_lead() {
    let step = |right, down, carries| {
        Action::Board(BoardAction::StepCursor {
            by: (right, down),
            carries,
        })
    };
    let at = |x, y| Action::Board(BoardAction::MoveCursor(Cell::new(x, y)));
    let pick = |tool| Action::Board(BoardAction::PickTool(tool));
    let lane = after(
        &fresh(),
        [
            pick(Tool::OneWay),
            at(4, 4),
            Action::Board(BoardAction::UseTool),
            step(1, 0, false),
            step(1, 0, false),
            Action::Board(BoardAction::UseTool),
        ],
    );
    let told = lane.document.draft.scene().constraints[1].sentence();
    assert_eq!(told, "One way from (4, 4) to (6, 4)");
    assert!(!lane.has_stroke());
    let zone = after(
        &fresh(),
        [
            pick(Tool::Zone),
            at(2, 1),
            step(0, 1, true),
            step(0, 1, true),
            Action::Board(BoardAction::UseTool),
        ],
    );
    assert_eq!(zone.document.draft.scene().zones[0].cells().count(), 3);
    assert!(card(&zone).is_some() && !zone.has_stroke());
    let dropped = after(
        &fresh(),
        [
            pick(Tool::OneWay),
            at(4, 4),
            Action::Board(BoardAction::UseTool),
            step(1, 0, false),
            Action::Board(BoardAction::Abandon),
        ],
    );
    assert_eq!(dropped.document.draft, fresh().document.draft);
}

#[test]
fn delete_removes_what_is_lit() {
    use crate::rules::Lit;
    let delete = Action::Board(BoardAction::Delete);
    let light = |lit| act(RuleAction::Light(Some(lit)));
    let rule = after(&fresh(), [light(Lit::Rule(0)), delete.clone()]);
    assert!(rule.document.draft.scene().constraints.is_empty() && rule.lit_rule().is_none());
    let zone = after(
        &marked(),
        [
            act(RuleAction::Add),
            light(Lit::Zone("zone 1".into())),
            delete,
        ],
    );
    let scene = zone.document.draft.scene();
    assert!(
        scene.zones.is_empty() && scene.constraints.len() == 1,
        "its rule goes, too"
    );
}

#[test]
fn a_stroke_from_a_cell_of_a_zone_goes_on_with_it_and_a_press_takes_the_cell_away() {
    let cells = |state: &State| state.document.draft.scene().zones[0].cells().count();
    let longer = after(
        &marked(),
        [
            Action::Board(BoardAction::Press(Cell::new(2, 3))),
            Action::Board(BoardAction::Drag(vec![Cell::new(2, 4)])),
            Action::Board(BoardAction::Release),
        ],
    );
    assert_eq!(cells(&longer), 4, "nothing is taken away");
    let press = [
        Action::Board(BoardAction::Press(Cell::new(2, 4))),
        Action::Board(BoardAction::Release),
    ];
    assert_eq!(cells(&after(&longer, press)), 3);
}

#[test]
fn a_zone_whose_rule_is_left_out_stays_and_says_so() {
    let cancelled = after(&marked(), [act(RuleAction::Cancel)]);
    assert!(card(&cancelled).is_none());
    assert_eq!(cancelled.document.draft.scene().zones.len(), 1);
    let told = cancelled.view.notice.as_ref().unwrap().sentence();
    assert_eq!(
        told,
        "zone 1 stays marked. Without a rule it changes nothing; Undo takes it back."
    );
    let back = after(&cancelled, [Action::Undo]);
    assert!(back.document.draft.scene().zones.is_empty());
    // With a rule of its own there is nothing to say.
    let added = solved(&after(&marked(), [act(RuleAction::Add)]));
    let edited = after(&added, [act(RuleAction::Edit(0)), act(RuleAction::Cancel)]);
    assert!(edited.view.notice.is_none());
}
