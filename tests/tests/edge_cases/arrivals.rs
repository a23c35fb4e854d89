//! Arrivals: at goals, in passing, for good.

use super::{check, check_within};

#[test]
fn a_start_that_is_the_goal() {
    check(
        "aA .",
        "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
    );
    check_within(
        "aA .",
        0,
        "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
    );
}

#[test]
fn an_agent_at_its_goal_steps_aside_and_comes_back() {
    check(
        "b aA B
         # .  #
         minimise makespan,sum-of-costs,moves",
        "optimal: makespan 2, sum-of-costs 4, moves 4; complete",
    );
}

#[test]
fn a_wait_at_the_goal_counts_if_the_agent_leaves_it_again() {
    check(
        "b . aA B
         # # .  #
         minimise makespan,sum-of-costs,moves,waits",
        "optimal: makespan 3, sum-of-costs 6, moves 5, waits 1; complete",
    );
}

#[test]
fn an_agent_that_stays_blocks_its_goal() {
    check("b aA B", "impossible; complete");
}

#[test]
fn passing_over_the_goal_does_not_force_arrival() {
    check(
        "a A a!",
        "optimal: makespan 3, sum-of-costs 3, charges 0; complete",
    );
}

#[test]
fn a_start_or_a_goal_may_be_a_waypoint() {
    check(
        "aa! . Aa!",
        "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
    );
    check(
        "aAa!",
        "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
    );
}

#[test]
fn a_start_that_is_the_goal_with_a_waypoint_elsewhere() {
    check(
        "aA a!",
        "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
    );
}

#[test]
fn waypoints_are_visited_in_any_order() {
    check(
        "a! . a . a! A",
        "optimal: makespan 7, sum-of-costs 7, charges 0; complete",
    );
}

#[test]
fn a_waypoint_is_not_visited_in_transit() {
    // The way through the zone passes no vertex but its ends.
    check(
        "~a ~a! ~A",
        "optimal: makespan 4, sum-of-costs 4, charges 0; complete",
    );
}

#[test]
fn agents_that_vanish_may_share_a_goal_one_after_the_other() {
    check(
        "a AB b
         vanish",
        "optimal: makespan 2, sum-of-costs 3, charges 0; complete",
    );
}

#[test]
fn an_agent_that_vanishes_holds_its_goal_at_its_arrival() {
    // Two agents that could both be there at time 1, and a third.
    check(
        "a ABC b
         #  c  #
         vanish",
        "optimal: makespan 3, sum-of-costs 6, charges 0; complete",
    );
}

#[test]
fn an_agent_that_vanished_is_in_nobodys_way() {
    check(
        "b aA B
         vanish",
        "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
    );
}

#[test]
fn an_agent_that_vanishes_does_not_swap_before() {
    check("aB bA \n vanish", "impossible; complete");
}

#[test]
fn an_agent_that_would_vanish_may_step_aside_first() {
    // a has a waypoint behind b: it cannot be gone before b has passed.
    check(
        "b aA B a!
         # .  # #
         vanish",
        "optimal: makespan 4, sum-of-costs 6, charges 0; complete",
    );
}
