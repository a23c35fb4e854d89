//! What is claimed of costs and of horizons.

use super::{check, check_within};

#[test]
fn horizon_0() {
    check_within("a A", 0, "impossible; within 0");
}

#[test]
fn a_horizon_that_is_too_small() {
    check_within("a . . A", 2, "impossible; within 2");
}

#[test]
fn a_horizon_that_just_suffices() {
    check_within(
        "a . . A",
        3,
        "optimal: makespan 3, sum-of-costs 3, charges 0; complete",
    );
}

#[test]
fn impossible_at_every_horizon_is_complete_within_a_horizon_too() {
    check_within("a # A", 5, "impossible; complete");
}

#[test]
fn charges_first_are_complete_at_the_sum_of_the_minima() {
    check(
        "a + . . A \n battery a 1/9 \n minimise charges",
        "optimal: charges 1; complete",
    );
}

#[test]
fn waits_first_are_complete_at_zero() {
    check("a . A \n minimise waits", "optimal: waits 0; complete");
}

#[test]
fn charges_decide_who_waits() {
    let crossing = "#  b  #
         +a .  A
         #  B  #
         battery a 0/1";
    check(
        &format!("{crossing} \n minimise makespan,charges,waits"),
        "optimal: makespan 3, charges 1, waits 1; complete",
    );
    // Here b cannot be the one that waits. No agent needs two charges alone,
    // so the reach of the claim is left to the solver.
    check(
        &format!("{crossing} \n battery b 2/2 \n minimise charges,makespan"),
        "optimal: charges 2, makespan 3",
    );
}

#[test]
fn all_five_costs() {
    check(
        "aB .  bA
         #  .  #
         minimise waits,charges,moves,sum-of-costs,makespan",
        "optimal: waits 1, charges 0, moves 6, sum-of-costs 7, makespan 4",
    );
    check(
        "aB bA
         .  .
         minimise sum-of-costs,waits,charges,moves,makespan",
        "optimal: sum-of-costs 4, waits 0, charges 0, moves 4, makespan 3; complete",
    );
}

/// SAT finds these hard, so that their few joint states are exhausted. Standing at
/// the goal is free there, and must not be told as going on.
#[test]
fn time_that_costs_nothing() {
    check(
        "~c  ~aA
         ~bC ~Bc!
         minimise moves",
        "optimal: moves 8; complete",
    );
    check(
        "#    #  .   ~C
         ~bc! .B ~a  ~cA
         minimise charges,moves",
        "optimal: charges 0, moves 17; complete",
    );
}

/// The same, where already a first plan is hard to find among so many steps.
#[test]
fn far_more_time_than_is_needed() {
    check_within(
        "~c ~a ~  ~Ab
         ~  .C #  .Ba!
         minimise sum-of-costs,moves,charges",
        1000,
        "optimal: sum-of-costs 59, moves 21, charges 0; complete",
    );
}
