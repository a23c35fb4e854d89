//! What the browser keeps: whole documents, with their past.

use std::rc::Rc;

use giveway_solve::{Reason, Status};

use super::super::{From, LONGEST, keep, kept};
use super::bare;
use crate::reduce::tests::{after, stroke};
use crate::{
    Action, AskAction, Edit, Phase, PlayAction, Selection, State, Tool, ViewAction, reduce, sample,
};

/// The page after it was loaded again.
#[track_caller]
fn again(state: &State) -> State {
    let text = keep(state);
    kept(&text).unwrap_or_else(|notice| panic!("{notice:?}: {text}"))
}

fn link_of(state: &State) -> String {
    super::super::document::write(&state.document, From::Here)
}

/// What is kept of a page that was loaded again is what was kept of it before.
#[track_caller]
fn same(state: &State) -> State {
    let restored = again(state);
    assert_eq!(keep(&restored), keep(state));
    assert_eq!(restored.phase(), state.phase());
    restored
}

#[test]
fn the_page_is_as_it_was_left() {
    let state = reduce(&sample::solved(), Action::Play(PlayAction::Seek(7)));
    let restored = again(&state);
    assert_eq!(restored.phase(), Phase::Planned);
    assert_eq!(restored.view.playback.time, 7);
    let plan = |state: &State| state.document.answer.clone().unwrap().solved.clone();
    assert_eq!(plan(&restored).plan, plan(&state).plan);
    assert_eq!(plan(&restored).bounds, plan(&state).bounds);
    same(&state);
}

#[test]
fn a_stale_plan_is_kept_as_one() {
    let stale = sample::stale();
    let restored = again(&stale);
    assert!(restored.document.is_stale());
    assert_eq!(restored.plan(), stale.plan());
    same(&stale);
}

#[test]
fn that_there_is_no_plan_is_kept() {
    let mut impossible = sample::solved();
    let mut answer = (**impossible.document.answer.as_ref().unwrap()).clone();
    answer.solved.status = Status::Impossible;
    answer.solved.plan = None;
    answer.solved.costs = None;
    let agents = vec!["A1".to_owned(), "A2".to_owned()];
    let reason = Reason::Clash { agents };
    answer.solved.reason = Some(reason.clone());
    impossible.document.answer = Some(Rc::new(answer));
    let restored = again(&impossible);
    assert_eq!(restored.phase(), Phase::None);
    let kept = restored
        .document
        .answer
        .as_ref()
        .unwrap()
        .solved
        .reason
        .clone();
    assert_eq!(kept, Some(reason));
}

#[test]
fn what_was_done_can_be_undone_after_a_reload() {
    let mut state = after(&sample::solved(), stroke(Tool::Obstacle, &[(8, 2)]));
    let edits = [
        Edit::Recolour(1, 7),
        Edit::Within(Some(40)),
        Edit::Rename(0, "R2 & D2 \u{1f600}".to_owned()),
    ];
    state = after(&state, edits.map(Action::Edit));
    let mut restored = same(&state);
    while state.history.can_undo() {
        state = reduce(&state, Action::Undo);
        restored = reduce(&restored, Action::Undo);
        assert_eq!(link_of(&restored), link_of(&state));
    }
    assert!(!restored.history.can_undo());
    assert!(restored.history.is_touched());
}

#[test]
fn questions_are_kept_with_what_is_known_of_them() {
    let state = crate::reduce::tests::asked_and_answered();
    let wide = after(&state, [Action::View(ViewAction::SetWide(true))]);
    let restored = same(&wide);
    let told = |state: &State| state.document.mode.asking().unwrap().told.clone();
    assert_eq!(told(&restored), told(&state));
    assert!(told(&state).is_some());
    let shown = after(&state, [Action::Ask(AskAction::ShowOther(true))]);
    assert!(same(&shown).document.mode.asking().unwrap().shows_other);
}

#[test]
fn ways_to_go_on_are_kept() {
    let state = crate::tests::compared();
    assert_eq!(state.phase(), Phase::Comparing);
    same(&state);
    let adopted = crate::tests::adopted();
    let undone = reduce(&same(&adopted), Action::Undo);
    assert_eq!(undone.phase(), Phase::Comparing);
    assert_eq!(keep(&undone), keep(&reduce(&adopted, Action::Undo)));
}

#[test]
fn a_selection_is_kept() {
    for selection in [
        Selection::Agent(1),
        Selection::Cell(giveway_model::Cell::new(3, 1)),
        Selection::Nothing,
    ] {
        let mut state = sample::solved();
        state.view.selection = selection;
        assert_eq!(again(&state).view.selection, selection);
    }
}

#[test]
fn there_is_room_for_so_much_of_the_past() {
    let mut state = sample::solved();
    for n in 0..3000 {
        let name = format!("{n} {}", "x".repeat(50));
        state = reduce(&state, Action::Edit(Edit::Name(name)));
    }
    let text = keep(&state);
    assert!(text.len() <= 2 * LONGEST, "{}", text.len());
    let restored = kept(&text).unwrap();
    assert_eq!(restored.document.draft, state.document.draft);
    assert!(restored.history.can_undo());
}

#[test]
fn what_the_first_version_kept_is_read() {
    let text = bare(&sample::solved()) + "&claim=0.1.0.19.36.4.0.0.0.0.0.0!";
    let state = kept(&text).unwrap();
    assert_eq!(state.phase(), Phase::Planned);
    let newer = text.replacen("giveway=1", "giveway-kept=3", 1);
    let why = kept(&newer).unwrap_err().details().join(" ");
    assert!(why.contains("newer version"), "{why}");
    for broken in ["", "x", "giveway-kept=2", "giveway-kept=2\n+0.-.0"] {
        assert!(kept(broken).is_err(), "{broken}");
    }
    assert!(
        super::read(&text, From::Anywhere).is_err(),
        "no link claims"
    );
}
