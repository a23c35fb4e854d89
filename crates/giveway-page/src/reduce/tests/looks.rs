//! A robot keeps its colour and its form whatever becomes of the others.

use super::{after, stroke};
use crate::board::Cast;
use crate::tests::adopted;
use crate::{
    Action, Edit, FileAction, Fold, Looks, SolveAction, State, Tool, ViewAction, link, sample,
};

/// The names of the robots on the board, with their looks.
fn looks(state: &State) -> Vec<(String, usize)> {
    let names = state
        .world()
        .agents()
        .iter()
        .map(|agent| agent.name.clone());
    names.zip(state.looks()).collect()
}

fn pair(name: &str, look: usize) -> (String, usize) {
    (name.to_owned(), look)
}

#[test]
fn a_robot_keeps_its_look_when_another_one_is_removed() {
    let state = sample::solved();
    assert_eq!(looks(&state), [pair("A1", 0), pair("A2", 1)]);
    let removed = after(&state, [Action::Edit(Edit::RemoveAgent(0))]);
    assert_eq!(looks(&removed), [pair("A2", 1)]);
    assert_eq!(Cast::of(&removed).looks[0], 1);
    // The next one gets the look that is free.
    let added = after(&removed, stroke(Tool::Agent, &[(1, 0), (2, 0)]));
    assert_eq!(looks(&added)[1].1, 0);
    let recoloured = after(&removed, [Action::Edit(Edit::Recolour(0, 7))]);
    assert_eq!(recoloured.document.colours.of(1), 7);
    let back = after(&removed, [Action::Undo]);
    assert_eq!(looks(&back), looks(&state));
}

#[test]
fn while_the_eraser_goes_over_a_robot_the_others_keep_theirs() {
    let mut actions = stroke(Tool::Erase, &[(0, 0)]);
    actions.pop();
    let state = after(&sample::solved(), actions);
    assert!(state.has_stroke());
    assert_eq!(looks(&state), [pair("A2", 1)]);
}

#[test]
fn links_and_kept_pages_have_the_looks() {
    let removed = after(&sample::solved(), [Action::Edit(Edit::RemoveAgent(0))]);
    let text = link::write(&removed);
    let opened = after(&State::new(crate::Draft::default()), [link::open(&text)]);
    assert_eq!(looks(&opened), [pair("A2", 1)]);
    let kept = link::kept(&link::keep(&removed)).unwrap();
    assert_eq!(looks(&kept), [pair("A2", 1)]);
    // Without any other word they are in their order.
    assert!(!link::write(&sample::solved()).contains("looks="));
}

#[test]
fn a_part_of_the_inspector_stays_unfolded_until_it_is_folded_or_another_scene_opens() {
    let state = sample::solved();
    assert_eq!(state.view.folds.of(Fold::Scene), None);
    let unfold = |fold, on| Action::View(ViewAction::Unfold(fold, on));
    let open = after(&state, [unfold(Fold::Scene, true)]);
    let edited = after(
        &open,
        [Action::Edit(Edit::Clear), Action::Solve(SolveAction::Solve)],
    );
    assert_eq!(edited.view.folds.of(Fold::Scene), Some(true));
    assert_eq!(edited.view.folds.of(Fold::Robot), None);
    let folded = after(&edited, [unfold(Fold::Scene, false)]);
    assert_eq!(folded.view.folds.of(Fold::Scene), Some(false));
    let scene = sample::draft().scene().clone();
    let other = after(&open, [Action::File(FileAction::Open(Box::new(scene)))]);
    assert_eq!(other.view.folds.of(Fold::Scene), None);
}

#[test]
fn one_that_joins_has_the_next_look() {
    let state = adopted();
    let expected = [pair("A1", 0), pair("A2", 1), pair("A3", 2)];
    assert_eq!(looks(&state), expected);
    assert_eq!(state.document.looks, Looks::default());
}
