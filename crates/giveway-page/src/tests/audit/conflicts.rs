//! From one broken rule to the next; how good the plan on the board is.

use super::{LEGAL, LEGAL_PATHS, MEETING, SCENE, audit, dropped, file, fresh};
use crate::audit::{AuditAction, conflicts, facts, question};
use crate::files::{Reading, read};
use crate::tests::answered as answer;
use crate::{Action, BoardAction, FileAction, PlayAction, Selection, State, keys, reduce, words};
use giveway_model::Cell;

/// A hall in which A1 and A2 meet, and then A2 and A3; A4 is alone.
const FOUR: &str = r#"{"giveway": 1, "map": ["....", "....", "...."],
    "agents": [
    {"name": "A1", "start": [0, 0], "goal": [2, 0]},
    {"name": "A2", "start": [2, 0], "goal": [0, 2]},
    {"name": "A3", "start": [0, 1], "goal": [1, 2]},
    {"name": "A4", "start": [3, 0], "goal": [3, 2]}]}"#;
const TWICE: &str = r#"{"giveway": 1, "paths": {
    "A1": [[0, 0], [1, 0], [2, 0]],
    "A2": [[2, 0], [1, 0], [1, 1], [1, 2], [0, 2]],
    "A3": [[0, 1], [0, 1], [1, 1], [1, 1], [1, 2]],
    "A4": [[3, 0], [3, 1], [3, 2]]}}"#;

fn state() -> State {
    dropped(&fresh(), &[("four.json", FOUR), ("p.json", TWICE)])
}

fn next(state: &State) -> State {
    reduce(state, Action::Audit(AuditAction::Next))
}

fn select(state: &State, agent: usize) -> State {
    let select = BoardAction::Select(Selection::Agent(agent));
    reduce(state, Action::Board(select))
}

fn sentence(state: &State) -> String {
    conflicts(state).unwrap().sentence
}

#[test]
fn all_conflicts_are_gone_through_and_begin_again() {
    let state = state();
    assert_eq!(sentence(&state), "2 conflicts.");
    let one = next(&state);
    assert_eq!(
        sentence(&one),
        "Conflict 1 of 2, at time 1: A1 and A2 are both at (1, 0)"
    );
    assert_eq!(one.view.playback.time, 1);
    assert_eq!(one.view.sought.unwrap().cell, Cell::new(1, 0));
    let two = next(&one);
    assert_eq!(
        sentence(&two),
        "Conflict 2 of 2, at time 2: A2 and A3 are both at (1, 1)"
    );
    assert_eq!(next(&two).view.playback.time, 1);
    // From another time it is the first one after that.
    let late = reduce(&one, Action::Play(PlayAction::Seek(2)));
    assert_eq!(sentence(&late), "2 conflicts.");
    assert_eq!(sentence(&next(&late)), sentence(&two));
}

#[test]
fn of_a_robot_only_its_own_are() {
    let third = select(&state(), 2);
    assert_eq!(sentence(&third), "A3 takes part in 1 conflict.");
    let gone = next(&third);
    assert_eq!(gone.view.playback.time, 2);
    assert_eq!(gone.view.selection, Selection::Agent(2));
    assert_eq!(next(&gone).view.playback.time, 2, "it is the only one");
    let alone = select(&gone, 3);
    let told = conflicts(&alone).unwrap();
    assert_eq!(
        (told.has_next, &*told.sentence),
        (false, "No conflict of A4.")
    );
    let stays = next(&alone);
    assert_eq!(stays.view.playback.time, 2);
    assert_eq!(stays.view.notice.unwrap().sentence(), "No conflict of A4.");
}

#[test]
fn the_list_shows_time_and_place() {
    let state = state();
    let row = facts(&state).unwrap().violations.pop().unwrap();
    let shown = reduce(&state, Action::Audit(AuditAction::Show(row.index)));
    assert_eq!(shown.view.playback.time, row.time);
    assert_eq!(shown.view.sought.unwrap().cell, Cell::new(1, 1));
    assert!(sentence(&shown).starts_with("Conflict 2 of 2, "));
    assert_eq!(next(&shown).view.playback.time, 1);
}

#[test]
fn the_key_is_for_plans_of_elsewhere() {
    let key = keys::Key {
        name: "n",
        ..keys::Key::default()
    };
    let next = keys::Command::Act(Action::Audit(AuditAction::Next));
    assert_eq!(keys::command(key, &state()), Some(next));
    assert_eq!(keys::command(key, &fresh()), None);
}

#[test]
fn a_legal_plan_has_none() {
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("p.txt", LEGAL_PATHS)]);
    assert_eq!(conflicts(&state), None);
    let notice = next(&state).view.notice.unwrap();
    assert_eq!(notice.sentence(), "This plan has no conflict.");
}

#[test]
fn a_plan_of_our_own_is_one_step_from_its_audit() {
    let files = [file("hall.json", SCENE), file("hall-plan.json", LEGAL)];
    let Ok(Reading::Linked(linked)) = read(&files) else {
        panic!("a scene with its plan")
    };
    let opened = reduce(
        &fresh(),
        Action::File(FileAction::OpenLink(Box::new(linked.linked))),
    );
    // It is played; while it is proved, and after, one press audits it.
    assert!(opened.document.mode.is_editing());
    for opened in [opened.clone(), answer(&opened)] {
        assert_eq!(question(&opened), Some("How good is this plan?"));
        let state = reduce(&opened, Action::Audit(AuditAction::Begin));
        let state = answer(&state);
        let told = facts(&state).unwrap();
        assert_eq!(told.title, "How good is this plan?");
        assert_eq!(told.facts, []);
        assert_eq!(
            told.verdict.sentence,
            "16.7 % above the best. There is a plan that costs 6, and this one costs 7."
        );
        let standing = words::standing(&state).sentence;
        assert!(
            standing.starts_with("This plan keeps every rule."),
            "{standing}"
        );
        assert_eq!(audit(&state).plan.answer.plan(), opened.document.plan());
        assert_eq!(question(&state), None);
        let back = reduce(&state, Action::Undo);
        assert_eq!(back.document, opened.document);
    }
}

#[test]
fn what_is_illegal_or_proved_is_not_asked_how_good_it_is() {
    let illegal = dropped(&fresh(), &[("hall.json", SCENE), ("p.json", MEETING)]);
    assert_eq!(question(&illegal), None);
    let state = State::new(audit(&illegal).plan.answer.draft.as_ref().clone());
    let solve = Action::Solve(crate::SolveAction::Solve);
    assert_eq!(question(&state), None);
    assert_eq!(question(&answer(&reduce(&state, solve))), None);
    let begun = reduce(&state, Action::Audit(AuditAction::Begin));
    assert_eq!(begun, state);
}
