//! Moves and waits, also in slow zones.

use super::{check, check_within};

#[test]
fn an_edge_with_one_end_in_the_zone_is_not_slow() {
    check(
        "a ~ A",
        "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
    );
}

#[test]
fn a_slow_move_takes_two_steps_and_is_one_move() {
    check(
        "~a ~A \n minimise makespan,moves,waits",
        "optimal: makespan 2, moves 1, waits 0; complete",
    );
}

#[test]
fn a_short_zone_is_crossed() {
    check(
        "a ~ ~ A
         . . . .
         minimise makespan,moves",
        "optimal: makespan 4, moves 3; complete",
    );
}

#[test]
fn a_long_zone_is_gone_around() {
    check(
        "a ~ ~ ~ ~ A
         . . . . . .
         minimise makespan,moves",
        "optimal: makespan 7, moves 7; complete",
    );
}

#[test]
fn fewest_moves_go_through_the_long_zone() {
    check(
        "a ~ ~ ~ ~ A
         . . . . . .
         minimise moves,makespan",
        "optimal: moves 5, makespan 8; complete",
    );
}

#[test]
fn a_slow_move_that_cannot_end_by_the_horizon_is_not_begun() {
    check_within("~a ~A", 1, "impossible; within 1");
    check_within(
        "~a ~A",
        2,
        "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
    );
}

#[test]
fn waiting_in_the_zone_is_waiting_as_anywhere() {
    check(
        "#  b  #
         ~a .  A
         #  B  #
         battery b 2/2
         minimise makespan,sum-of-costs,moves,waits",
        "optimal: makespan 3, sum-of-costs 5, moves 4, waits 1; complete",
    );
}
