//! Real units of a scene: no claim is about them, and with others its plan stays.

use super::rules::{fresh, solved};
use crate::reduce::tests::after;
use crate::{Action, Edit, State};

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
