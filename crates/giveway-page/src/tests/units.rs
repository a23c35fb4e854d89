//! Real units of a scene: no claim is about them, and with others its plan stays.

use super::rules::{fresh, solved};
use crate::reduce::tests::after;
use crate::{Action, Edit, SolveAction, State};

#[test]
fn other_units_keep_the_plan_and_undo_takes_them_back() {
    let before = solved(&fresh());
    let measure = |text: &str| crate::number::measure(text).unwrap();
    let units = giveway_model::Units {
        cell: measure("0.8"),
        step: measure("1,5"),
    };
    let told = crate::words::standing(&before).sentence;
    let state = after(&before, [Action::Edit(Edit::Units(Some(units)))]);
    assert!(state.document.fresh_answer().is_some());
    assert_eq!(
        crate::words::standing(&state).sentence,
        told,
        "a claim has no units"
    );
    assert_eq!(state.document.draft.scene().units, Some(units));
    let grid = state.document.draft.grid();
    let side = |cells: u32| giveway_model::words::length(units, cells);
    let sides = format!("{} x {}", side(grid.width()), side(grid.height()));
    let contents = |state: &State| crate::inspect::whole(state).contents;
    assert!(contents(&state).ends_with(&sides), "{}", contents(&state));
    assert!(!contents(&before).contains(" m"), "no metres without units");
    let again = crate::link::kept(&crate::link::keep(&state)).unwrap();
    assert_eq!(again.document.draft.scene().units, Some(units), "kept");
    assert!(again.document.fresh_answer().is_some());
    let undone = after(&state, [Action::Undo]);
    assert_eq!(undone.document, before.document);
    assert!(
        after(&undone, [Action::Redo])
            .document
            .fresh_answer()
            .is_some()
    );
}

/// 0.8 m and 1.5 s.
fn units() -> Edit {
    let measure = |text: &str| crate::number::measure(text).unwrap();
    let (cell, step) = (measure("0.8"), measure("1.5"));
    Edit::Units(Some(giveway_model::Units { cell, step }))
}

/// A plan that was gone on with has worlds of its own: each is told in the scene's units.
#[test]
fn a_plan_gone_on_with_stays_and_each_of_its_worlds_has_the_units() {
    let before = super::change::adopted();
    let course = |state: &State| {
        let answer = state.document.fresh_answer().expect("the plan stays");
        answer.course.clone().expect("it was gone on with")
    };
    let state = after(&before, [Action::Edit(units())]);
    let (was, is) = (course(&before), course(&state));
    assert_eq!(is.steps, was.steps);
    assert_eq!(is.worlds.len(), was.worlds.len());
    let units = state.document.draft.scene().units;
    assert!(units.is_some());
    for world in &is.worlds {
        assert_eq!(world.draft.scene().units, units, "from {}", world.from);
    }
    let again = crate::link::kept(&crate::link::keep(&state)).unwrap();
    assert_eq!(course(&again).worlds, is.worlds, "kept");
}

/// The plan of a planner of the textbook stays, and that there is no plan.
#[test]
fn a_planners_plan_stays_and_that_there_is_none() {
    let crossing = super::page(&[".b.", "a.A", ".B."], &[giveway_model::Cost::SumOfCosts]);
    let plan = SolveAction::Plan(giveway_solve::plan::Planner::Prioritised);
    let planned = super::answered(&after(&crossing, [Action::Solve(plan)]));
    let state = after(&planned, [Action::Edit(units())]);
    let answer = state.document.fresh_answer().expect("the plan stays");
    assert!(answer.by.is_some());
    let corridor = super::page(&["aB.bA"], &[giveway_model::Cost::SumOfCosts]);
    let impossible = super::answered(&after(&corridor, [Action::Solve(SolveAction::Solve)]));
    let state = after(&impossible, [Action::Edit(units())]);
    let answer = state.document.fresh_answer().expect("the answer stays");
    assert_eq!(answer.solved.status, giveway_solve::Status::Impossible);
}
