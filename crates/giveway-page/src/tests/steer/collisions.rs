//! What goes wrong on the way: collisions, and batteries that run empty.

use super::{BACK, DOWN, RIGHT, UP, WAIT, leading, told, warehouse};
use giveway_model::Cell;

use crate::board::{ConflictPlace, reasons};
use crate::reduce::tests::after;
use crate::steering::Lead;
use crate::tests::saying;
use crate::{Action, PlayAction};

#[test]
fn a_collision_shows_as_it_arises() {
    let state = after(&leading(0, 0), [DOWN]);
    assert_eq!(told(&state).violations, []);
    assert_eq!(reasons(&state).bursts, []);
    // A2 comes from (1, 1) at time 2, so that they cross.
    let state = after(&leading(0, 0), [DOWN, RIGHT]);
    let [met] = &told(&state).violations[..] else {
        panic!("{:?}", told(&state).violations);
    };
    assert_eq!(met.text, "A1 and A2 are both at (1, 1) at time 2.");
    assert!(met.is_lit);
    assert_eq!(
        saying(&state),
        "A1 is at (1, 1) at time 2. A1 and A2 are both at (1, 1) at time 2."
    );
    assert_eq!(
        reasons(&state).bursts,
        [ConflictPlace::Cell(Cell::new(1, 1))]
    );
    let earlier = after(&state, [Action::Play(PlayAction::StepBack)]);
    assert_eq!(reasons(&earlier).bursts, [], "only at its time");
    let state = after(&state, [BACK, WAIT, RIGHT]);
    let [swap] = &told(&state).violations[..] else {
        panic!("{:?}", told(&state).violations);
    };
    assert!(swap.is_lit, "the step lasts up to the time shown");
    let [ConflictPlace::Edge(edge)] = reasons(&state).bursts[..] else {
        panic!("between both");
    };
    assert!(edge.contains(&Cell::new(0, 1)) && edge.contains(&Cell::new(1, 1)));
    let state = after(&state, [BACK, BACK]);
    assert_eq!(told(&state).violations, []);
}

#[test]
fn an_agent_charges_in_the_step_after_that_was_chosen() {
    // A1 is on the charger (6, 2) at time 9, where it charges.
    let state = warehouse(9);
    assert_eq!(told(&state).charges, Some(false));
    let charge = Action::Steer(Lead::Charge);
    let state = after(&state, [charge.clone()]);
    assert_eq!(told(&state).charges, Some(true));
    assert_eq!(told(&state).violations, [], "it is no step yet");
    let moved = after(&state, [UP]);
    assert_eq!(
        told(&moved).place,
        "A1 is at (6, 1) at time 10, battery 10 of 10"
    );
    assert_eq!(told(&moved).charges, None);
    let back = after(&moved, [BACK]);
    assert_eq!(told(&back).charges, Some(true), "the choice stays");
    let without = after(&back, [charge, UP]);
    assert_eq!(
        told(&without).place,
        "A1 is at (6, 1) at time 10, battery 0 of 10"
    );
    let empty = after(&without, [WAIT]);
    assert!(
        saying(&empty).contains("The battery of A1 is at -1 at time 11"),
        "{}",
        saying(&empty)
    );
    assert_eq!(
        reasons(&empty).bursts,
        [ConflictPlace::Cell(Cell::new(6, 1))]
    );
}
