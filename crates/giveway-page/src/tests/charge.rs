//! Why a robot charges, with the solver's own answers.

use giveway_model::{Cell, Question};

use super::answered;
use crate::ask::card;
use crate::reduce::tests::after;
use crate::sample::solved;
use crate::{Action, AskAction};

#[test]
fn a_charge_that_could_be_elsewhere_says_where() {
    let state = solved();
    let plan = state.plan().unwrap();
    assert_eq!(plan.charges("A1"), [9]);
    let question = Question::Charge {
        agent: "A1".to_owned(),
        at: Some(Cell::new(6, 2)),
        time: Some(9),
    };
    let told = answered(&after(&state, [Action::Ask(AskAction::Ask(question))]));
    let other = told.document.mode.asking().unwrap().other.clone().unwrap();
    let time = other.plan().unwrap().charges("A1")[0];
    let cell = other.plan().unwrap().path("A1")[time as usize].unwrap();
    assert_ne!(cell, Cell::new(6, 2));
    let verdict = card(&told).unwrap().verdict.unwrap();
    assert_eq!(
        verdict.title,
        format!("It could charge at {cell} at time {time} instead")
    );
    assert_eq!(verdict.claim.as_deref(), Some("same cost"));
}
