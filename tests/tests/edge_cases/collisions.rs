//! Collisions at vertices and along edges.

use super::check;

#[test]
fn one_of_two_that_cross_waits() {
    check(
        "#  b  #
         a  .  A
         #  B  #
         minimise makespan,sum-of-costs,waits",
        "optimal: makespan 3, sum-of-costs 5, waits 1; complete",
    );
}

#[test]
fn a_swap_in_a_corridor() {
    check("aB bA", "impossible; complete");
    check("aB . bA", "impossible; complete");
    check("aB . . bA", "impossible; complete");
}

#[test]
fn a_swap_with_a_bay() {
    check(
        "aB .  bA
         #  .  #",
        "optimal: makespan 4, sum-of-costs 7, charges 0; complete",
    );
}

#[test]
fn a_swap_on_a_ring() {
    check(
        "aB bA
         .  .",
        "optimal: makespan 3, sum-of-costs 4, charges 0; complete",
    );
}

#[test]
fn following_is_allowed() {
    check(
        "a bA B",
        "optimal: makespan 1, sum-of-costs 2, charges 0; complete",
    );
}

#[test]
fn a_chain_of_three_is_allowed() {
    check(
        "a bA cB C",
        "optimal: makespan 1, sum-of-costs 3, charges 0; complete",
    );
}

#[test]
fn three_on_a_square_go_around() {
    check(
        "aC bA
         .  cB",
        "optimal: makespan 2, sum-of-costs 4, charges 0; complete",
    );
}

#[test]
fn four_on_a_square_turn_in_place() {
    check(
        "aD bA
         dC cB",
        "optimal: makespan 1, sum-of-costs 4, charges 0; complete",
    );
}

#[test]
fn six_on_a_ring_turn_in_place() {
    check(
        "aF bA cB
         fE eD dC",
        "optimal: makespan 1, sum-of-costs 6, charges 0; complete",
    );
}

#[test]
fn four_on_a_slow_square_turn_in_place() {
    check(
        "~aD ~bA
         ~dC ~cB
         minimise makespan,sum-of-costs,moves",
        "optimal: makespan 2, sum-of-costs 8, moves 4; complete",
    );
}

#[test]
fn a_slow_swap() {
    // One step apart would be a way, if it were none: b would be in transit
    // when a comes to where b was.
    check("~aB ~bA", "impossible; complete");
    check("aB ~ ~ bA", "impossible; complete");
}

#[test]
fn a_slow_swap_of_agents_that_vanish() {
    check("~aB ~bA \n vanish", "impossible; complete");
}

#[test]
fn following_into_a_slow_edge_one_step_behind() {
    check(
        "a ~b ~ A B",
        "optimal: makespan 4, sum-of-costs 8, charges 0; complete",
    );
}

#[test]
fn entering_a_slow_edge_at_whose_end_another_still_stands() {
    // b must let c pass, and stands at (1, 1) for one step while a is on its
    // way there.
    check(
        "#  #   c
         ~a ~bA B
         #  #   C
         minimise makespan,sum-of-costs,waits",
        "optimal: makespan 2, sum-of-costs 6, waits 1; complete",
    );
}

#[test]
fn a_slow_chain() {
    check(
        "~a ~bA ~B",
        "optimal: makespan 2, sum-of-costs 4, charges 0; complete",
    );
}
