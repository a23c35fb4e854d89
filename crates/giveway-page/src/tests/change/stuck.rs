//! No method has a plan: the cause is told, and a repair may make one.

use super::changing;
use crate::changing::columns;
use crate::reduce::tests::{after, stroke};
use crate::tests::{answer, answered, saying};
use crate::{Action, AskAction, ChangeAction, Phase, Tab, Tool, ViewAction};

#[test]
fn where_no_method_has_a_plan_nothing_can_be_adopted_and_the_cause_is_told() {
    // The goal of A1 is walled in, and no way of it leads there.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(2, 2)]));
    let asked = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    assert_eq!(asked.phase(), Phase::Asking, "why, and what would help");
    // The solver refuses the question, since the changes themselves give the cause.
    let state = after(&asked, [answer(&asked)]);
    let columns = columns(&state).unwrap();
    assert!(
        columns
            .iter()
            .all(|column| !column.has_plan() && !column.is_least)
    );
    assert!(columns[2].notes[0].contains("(2, 2), where there is an obstacle now"));
    assert_eq!(state.last_time(), 1);
    assert!(
        saying(&state).ends_with("have no plan."),
        "{}",
        saying(&state)
    );
    assert_eq!(
        after(&state, [Action::Change(ChangeAction::Adopt(0))]),
        state
    );
}

#[test]
fn where_no_method_has_a_plan_a_repair_makes_one() {
    // The goal of A2 is walled in.
    let state = after(&changing(), stroke(Tool::Obstacle, &[(1, 2)]));
    let state = after(&state, stroke(Tool::Obstacle, &[(0, 1)]));
    let state = answered(&after(&state, [Action::Change(ChangeAction::Adapt)]));
    let state = answered(&state);
    assert!(
        state.document.mode.comparing().is_some() && state.document.mode.asking().is_some(),
        "{:?} {:?}",
        state.view.notice,
        state.phase()
    );
    let looked = after(&state, [Action::View(ViewAction::ShowTab(Tab::Timeline))]);
    assert!(state.is_kept_alike(&looked), "there is nothing new to keep");
    let told = state.document.mode.asking().unwrap().told.clone().unwrap();
    assert!(!told.repairs.is_empty(), "{told:?}");
    let again = after(&state, [Action::Ask(AskAction::TakeRepair(0))]);
    assert_eq!(again.phase(), Phase::Adapting);
    let compared = answered(&again);
    assert_eq!(compared.phase(), Phase::Comparing);
    assert!(
        compared
            .document
            .mode
            .comparing()
            .unwrap()
            .preview()
            .is_some()
    );
    let undone = after(&again, [Action::Undo]);
    assert_eq!(
        undone.document.mode, state.document.mode,
        "the answer is still there"
    );
}
