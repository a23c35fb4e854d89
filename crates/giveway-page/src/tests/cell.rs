//! Questions at a cell that many robots use.

use giveway_model::{Cell, Cost};

use super::{answered, page, select};
use crate::reduce::tests::after;
use crate::{Action, BoardAction, Selection, SolveAction, State, ask};

/// What is asked at the cell that all robots drive through.
fn asked(state: &State) -> Vec<String> {
    let groups = ask::offers(state);
    let offers = groups.into_iter().flat_map(|group| group.offers);
    offers.map(|offer| offer.text).collect()
}

#[test]
fn all_who_pass_can_be_asked_about_and_first_the_robot_that_was_selected() {
    // Four robots in a row drive through the cell at its right.
    let state = page(&["abcd..ABCD"], &[Cost::Makespan]);
    let state = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    let cell = Action::Board(BoardAction::Select(Selection::Cell(Cell::new(4, 0))));
    let pass = |name| format!("Why does {name} pass (4, 0)?");
    let all = ["A", "B", "C", "D"].map(pass);
    assert_eq!(asked(&after(&state, [cell.clone()])), all);
    let third = asked(&after(&state, [select(2), cell]));
    assert_eq!(third, ["C", "A", "B", "D"].map(pass));
}
