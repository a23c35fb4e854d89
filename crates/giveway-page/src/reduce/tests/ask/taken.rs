//! What a person takes from an answer: the other plan, a repair.

use std::rc::Rc;

use giveway_solve::Status;

use super::{answered, asked};
use crate::ask::card;
use crate::reduce::tests::after;
use crate::{Action, AskAction, Phase, PlayAction, ViewAction, words};

#[test]
fn the_other_plan_is_shown_and_taken() {
    let state = answered(&asked());
    let this = state.document.answer.clone();
    assert_eq!(state.shown(), this.as_ref());
    let shown = after(&state, [Action::Ask(AskAction::ShowOther(true))]);
    assert_ne!(shown.shown(), this.as_ref());
    assert_eq!(shown.document.answer, this, "nothing is taken yet");
    let back = after(&shown, [Action::Ask(AskAction::ShowOther(false))]);
    assert_eq!(back.shown(), this.as_ref());

    let taken = after(&shown, [Action::Ask(AskAction::TakeOther)]);
    assert_eq!(taken.document.mode.asking(), None);
    let answer = taken.document.answer.unwrap();
    // It costs more than what was proved.
    assert_eq!(answer.solved.status, Status::Feasible);
    assert_eq!(answer.solved.costs.unwrap().charges, 4);
}

/// Nobody searched for it, so it is not the best that a search had when it was stopped.
#[test]
fn a_plan_that_was_taken_is_not_called_the_best_so_far() {
    let shown = after(
        &answered(&asked()),
        [Action::Ask(AskAction::ShowOther(true))],
    );
    let taken = after(&shown, [Action::Ask(AskAction::TakeOther)]);
    assert_eq!(taken.phase(), Phase::Found);
    let standing = words::standing(&taken);
    assert_eq!(standing.badge, words::Badge::Found);
    let sentence = "A plan: makespan 18, sum of costs 35, 4 charges. There is a better plan.";
    assert_eq!(standing.sentence, sentence);
    let claims = crate::inspect::whole(&taken).claims;
    assert!(
        claims.iter().all(|claim| !claim.contains("so far")),
        "{claims:?}"
    );
}

#[test]
fn where_there_is_room_the_other_plan_is_beside_this_one() {
    let state = answered(&asked());
    assert_eq!(state.beside(), None);
    let wide = after(&state, [Action::View(ViewAction::SetWide(true))]);
    assert_eq!(wide.beside(), None, "it is opened by hand");
    let wide = after(&wide, [Action::Ask(AskAction::ShowOther(true))]);
    let other = wide.document.mode.asking().as_ref().unwrap().other.clone();
    assert_eq!(wide.beside(), other.as_ref());
    assert!(card(&wide).unwrap().other.unwrap().is_beside);

    // A window that grows while the other plan has the place of this one.
    let grown = after(
        &state,
        [
            Action::Ask(AskAction::ShowOther(true)),
            Action::View(ViewAction::SetWide(true)),
        ],
    );
    assert_eq!(grown.shown(), state.document.answer.as_ref());
    assert_eq!(grown.beside(), other.as_ref());
    let left = after(&wide, [Action::Ask(AskAction::Close)]);
    assert_eq!(left.beside(), None);
}

#[test]
fn two_plans_play_to_the_end_of_the_longer_one() {
    let mut state = after(
        &answered(&asked()),
        [
            Action::View(ViewAction::SetWide(true)),
            Action::Ask(AskAction::ShowOther(true)),
        ],
    );
    let asking = state.document.mode.asking_mut().unwrap();
    let mut other = asking.other.as_deref().unwrap().clone();
    other.solved.costs.as_mut().unwrap().makespan = 20;
    asking.other = Some(Rc::new(other));
    assert_eq!(state.last_time(), 20);
    let end = after(&state, [Action::Play(PlayAction::Seek(99))]);
    assert_eq!(end.view.playback.time, 20);
    let narrow = after(
        &end,
        [
            Action::View(ViewAction::SetWide(false)),
            Action::Ask(AskAction::ShowOther(false)),
        ],
    );
    assert_eq!(narrow.view.playback.time, 18);
}

#[test]
fn a_repair_is_an_edit_that_can_be_undone() {
    let state = answered(&asked());
    let before = state.document.draft.clone();
    let repaired = after(&state, [Action::Ask(AskAction::TakeRepair(0))]);
    assert_eq!(repaired.document.draft.agents()[0].waypoints.len(), 2);
    assert_eq!(repaired.phase(), Phase::Solving);
    assert!(repaired.plan().is_some(), "its plan is there already");
    assert_eq!(repaired.document.mode.asking(), None);
    let undone = after(&repaired, [Action::Undo]);
    assert_eq!(undone.document.draft, before);
    let none = after(&state, [Action::Ask(AskAction::TakeRepair(7))]);
    assert_eq!(none, state);
}
