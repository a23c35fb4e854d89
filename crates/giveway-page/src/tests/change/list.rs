//! What changes is listed: by every tool, one step of undo each.

use giveway_model::Cell;
use giveway_model::change::What;

use super::{changing, joined, list, running};
use crate::changing::{facts, in_words};
use crate::reduce::tests::{after, stroke};
use crate::rules::RuleAction;
use crate::tests::{saying, seek, select};
use crate::{
    Action, BoardAction, ChangeAction, Draft, Edit, Phase, PlayAction, Selection, State, Tool,
};

#[test]
fn the_world_can_change_only_while_a_plan_runs() {
    let fresh = State::new(Draft::default());
    let refused = after(&fresh, [Action::Change(ChangeAction::Begin)]);
    assert!(refused.document.mode.changing().is_none() && refused.view.notice.is_some());
    let state = changing();
    assert_eq!(state.phase(), Phase::Changing);
    assert!(!state.view.playback.playing);
    assert!(saying(&state).starts_with("The world changes at time 1"));
    assert_eq!(state.last_time(), 1, "what comes later is not known");
    let past = after(&state, [seek(4), Action::Play(PlayAction::StepBack)]);
    assert_eq!(past.view.playback.time, 0);
    let edited = after(&past, stroke(Tool::Obstacle, &[(0, 2)]));
    assert_eq!(edited.view.playback.time, 1, "what changes does so then");
}

#[test]
fn every_tool_lists_a_change() {
    let state = after(&changing(), stroke(Tool::Obstacle, &[(0, 2), (1, 2)]));
    let both = ["New obstacle at (0, 2), and 1 more"];
    assert_eq!(list(&state), both, "a stroke is one entry");
    assert!(saying(&state).ends_with(": 1 change listed."));
    let back = after(&state, [Action::Change(ChangeAction::TakeBack(0))]);
    assert_eq!(list(&back), [""; 0], "and is taken back as one");
    let mixed = after(&state, stroke(Tool::Charger, &[(1, 1)]));
    let now = mixed.document.mode.changing().unwrap();
    let said = in_words(now.about.plan(), &now.list, now.at);
    assert_eq!(said, "New obstacle at (0, 2), and 2 more");
    let state = after(&state, stroke(Tool::Select, &[(1, 2), (0, 0)]));
    assert_eq!(list(&state), both);
    let state = after(&state, stroke(Tool::Erase, &[(0, 0)]));
    assert_eq!(list(&state), ["New obstacle at (0, 2)"]);
    let state = after(&state, stroke(Tool::Charger, &[(1, 1)]));
    let state = after(&state, stroke(Tool::SlowZone, &[(0, 1), (1, 1)]));
    let slow = facts(&state).unwrap().list.pop().unwrap();
    assert_eq!(slow.text, "2 cells become slow");
    assert_eq!(slow.detail.as_deref(), Some("(0, 1), (1, 1)"));
    let pick = [
        Action::Board(BoardAction::PickTool(Tool::Select)),
        select(0),
    ];
    let state = after(&state, pick);
    let state = after(&state, stroke(Tool::Goal, &[(2, 0)]));
    let state = after(&state, stroke(Tool::Waypoint, &[(1, 1)]));
    assert_eq!(
        list(&state)[3..],
        [
            "The goal of A1 is now (2, 0)",
            "A1 also has to visit (1, 1)"
        ]
    );
    let state = after(&state, stroke(Tool::Waypoint, &[(1, 1)]));
    assert_eq!(list(&state).len(), 4, "that one is taken back");
    // A2 is at (2, 1) at time 1.
    let state = after(&state, stroke(Tool::Erase, &[(2, 1)]));
    assert_eq!(list(&state)[4], "A2 is removed");
    assert!(!state.is_there(1));
    assert_eq!(
        state.document.draft,
        running().document.draft,
        "the scene itself is as it was"
    );
    assert!(!state.document.is_stale());
}

#[test]
fn beside_the_board_agents_break_down_and_batteries_go_down() {
    let (delay, longer) = (Edit::Delay(0, 2), Edit::Delay(0, 3));
    let state = after(&changing(), [Action::Edit(delay), Action::Edit(longer)]);
    assert_eq!(list(&state), ["A1 breaks down for 3 steps"]);
    let level = Edit::SetLevel(0, 2);
    let refused = after(&state, [Action::Edit(level)]);
    assert_eq!(list(&refused), list(&state));
    let notice = refused.view.notice.unwrap().sentence();
    assert!(notice.contains("A1, which has no battery"), "{notice}");
}

#[test]
fn what_contradicts_the_world_is_refused_and_nothing_changes() {
    // A1 is at (1, 0) at time 1.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(1, 0)]));
    assert_eq!(list(&state), Vec::<String>::new());
    assert_eq!(
        state.view.notice.unwrap().sentence(),
        "This contradicts the world: found an obstacle at (1, 0), where A1 is at time 1, \
         expected a cell that is free then."
    );
    // A stroke over it paints what can be.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(0, 0), (1, 0)]));
    assert_eq!(list(&state), ["New obstacle at (0, 0)"]);
    assert!(state.view.notice.is_some());
}

#[test]
fn the_scene_cannot_be_edited_while_the_world_changes() {
    let state = after(&changing(), [Action::Edit(Edit::BatteryFloor(2))]);
    assert!(state.view.notice.is_some() && !state.document.is_stale());
    assert_eq!(state.document.draft, running().document.draft);
}

#[test]
fn each_change_is_one_step_of_undo_and_can_be_taken_back() {
    let state = joined();
    assert_eq!(list(&state), ["A3 joins at (2, 2)"]);
    assert_eq!(state.view.selection, Selection::Agent(2));
    let state = after(&state, stroke(Tool::Obstacle, &[(0, 2)]));
    let undone = after(&state, [Action::Undo]);
    assert_eq!(list(&undone), ["A3 joins at (2, 2)"]);
    let redone = after(&undone, [Action::Redo]);
    assert_eq!(list(&redone).len(), 2);
    let back = after(&redone, [Action::Change(ChangeAction::TakeBack(0))]);
    assert_eq!(list(&back), ["New obstacle at (0, 2)"]);
    assert_eq!(back.view.selection, Selection::Nothing, "A3 is gone");
    let left = after(&back, [Action::Change(ChangeAction::Discard)]);
    assert_eq!(left.phase(), Phase::Planned);
    assert_eq!(list(&after(&left, [Action::Undo])).len(), 1);
    let all = [Action::Undo, Action::Undo, Action::Undo];
    assert!(after(&undone, all).document.mode.changing().is_none());
}

/// Undo says what it did: the list may be out of sight, behind a robot or a rule.
#[test]
fn undo_says_which_change_it_takes_back() {
    let state = after(&joined(), stroke(Tool::Obstacle, &[(0, 2)]));
    let told = |state: &State| state.view.notice.as_ref().map(crate::Notice::sentence);
    let undone = after(&state, [Action::Undo]);
    assert_eq!(told(&undone).unwrap(), "Undone: New obstacle at (0, 2).");
    let redone = after(&undone, [Action::Redo]);
    assert_eq!(
        told(&redone).unwrap(),
        "Listed again: New obstacle at (0, 2)."
    );

    // The card of a rule does not hide the step.
    let writing = after(&state, [Action::Rules(RuleAction::Begin)]);
    assert!(writing.is_writing_rule());
    let undone = after(&writing, [Action::Undo]);
    assert!(!undone.is_writing_rule());
    assert_eq!(list(&undone), ["A3 joins at (2, 2)"]);

    let compared = after(&super::compared(), [Action::Undo]);
    assert_eq!(
        told(&compared).unwrap(),
        "The new plans were put aside. What changes is still listed."
    );
    let left = after(&changing(), [Action::Undo]);
    assert!(left.document.mode.changing().is_none());
    assert_eq!(
        told(&left).unwrap(),
        "The world does not change any more: that was undone."
    );
    // Elsewhere what is undone is seen.
    let edited = after(&running(), stroke(Tool::Obstacle, &[(0, 2)]));
    assert_eq!(told(&after(&edited, [Action::Undo])), None);
}

#[test]
fn an_agent_that_has_its_cell_taken_back_loses_what_is_its_own() {
    let state = after(&joined(), stroke(Tool::Waypoint, &[(0, 1)]));
    let Some(What::AddAgent { agent }) = state
        .document
        .mode
        .changing()
        .as_ref()
        .unwrap()
        .list
        .first()
    else {
        panic!("it joins");
    };
    assert_eq!(agent.waypoints, [Cell::new(0, 1)]);
    let state = after(&state, stroke(Tool::Erase, &[(2, 2)]));
    assert_eq!(list(&state), Vec::<String>::new());
}

#[test]
fn a_change_that_another_needs_takes_it_along() {
    let state = after(&changing(), stroke(Tool::Erase, &[(1, 0)]));
    let state = after(&state, stroke(Tool::Agent, &[(1, 0), (1, 1)]));
    assert_eq!(list(&state), ["A1 is removed", "A3 joins at (1, 0)"]);
    let state = after(&state, [Action::Change(ChangeAction::TakeBack(0))]);
    assert_eq!(list(&state), Vec::<String>::new());
    assert!(state.view.notice.is_some());
}
