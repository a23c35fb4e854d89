//! Starts, goals, waypoints, arrival, and the two rules at the goal.

use crate::picture::{check, check_costs};

#[test]
fn a_path_begins_at_the_start() {
    check("...", "A 10 20 | from 00", "0 start A 10");
}

#[test]
fn a_path_ends_at_the_goal() {
    check("...", "A 00 10 | to 20", "1 goal A 10");
}

#[test]
fn a_waypoint_is_visited_by_the_arrival() {
    check("...", "A 00 10 | via 20 10", "1 waypoint A 20");
}

#[test]
fn every_waypoint_missed_counts() {
    check(
        "....",
        "A 00 10 | via 30 20",
        "
        1 waypoint A 20
        1 waypoint A 30
        ",
    );
}

#[test]
fn a_start_or_goal_that_is_a_waypoint_counts() {
    check("..", "A 00 10 | via 00 10", "");
    check("..", "A 00 | via 00", "");
}

#[test]
fn waypoints_are_visited_in_any_order() {
    check("....", "A 00 10 20 30 | via 20 10", "");
}

#[test]
fn a_waypoint_at_the_arrival_itself_counts() {
    check("...", "A 00 10 20 | via 20", "");
}

#[test]
fn a_waypoint_is_visited_at_a_vertex_not_in_passing() {
    check("~~~", "A 00 .. 10 .. 20 | via 10", "");
    check(
        "~~",
        "A 00 .. .. | to 10, via 10",
        "
        0 goal A 00
        0 waypoint A 10
        2 shape A
        ",
    );
}

#[test]
fn passing_over_the_goal_does_not_force_arrival() {
    check_costs("...", "A 00 10 20 10", [3, 3, 0, 3, 0]);
}

#[test]
fn a_goal_reached_before_the_last_waypoint_is_no_arrival() {
    check_costs("...", "A 00 10 20 10 | via 20", [3, 3, 0, 3, 0]);
}

#[test]
fn start_at_the_goal_is_arrival_0() {
    check_costs(".", "A 00", [0, 0, 0, 0, 0]);
}

#[test]
fn start_at_the_goal_may_step_aside_and_come_back() {
    check_costs(
        "
        ...
        #.#
        ",
        "
        A 10 11 10
        B 00 10 20
        ",
        [2, 4, 0, 4, 0],
    );
}

#[test]
fn trailing_repeats_of_the_goal_are_cut() {
    check_costs("..", "A 00 10 10 10", [1, 1, 0, 1, 0]);
    check_costs("..", "A 00 00 00", [0, 0, 0, 0, 0]);
}

#[test]
fn trailing_repeats_are_cut_under_vanish_too() {
    check(
        "...",
        "
        rules vanish
        A 00 10 10 10
        B 20 20 10 00
        ",
        "",
    );
}

#[test]
fn repeats_of_another_cell_are_not_cut() {
    check("...", "A 00 10 10 | to 20", "2 goal A 10");
}

#[test]
fn an_arrived_agent_blocks_its_goal() {
    check(
        "...",
        "
        A 10
        B 00 00 10 20
        ",
        "2 vertex A B 10",
    );
}

#[test]
fn an_arrived_agent_blocks_its_goal_for_good() {
    check(
        "....",
        "
        A 00 10
        B 30 20 20 20 20 20 10 20 10 20
        ",
        "
        6 vertex A B 10
        8 vertex A B 10
        ",
    );
}

#[test]
fn nobody_swaps_with_an_arriving_agent() {
    check(
        "..",
        "
        A 00 10
        B 10 00
        ",
        "0 swap A B 00-10",
    );
}

#[test]
fn under_vanish_the_goal_is_free_after_the_arrival() {
    check(
        "...",
        "
        rules vanish
        A 00 10
        B 20 20 10 00
        ",
        "",
    );
}

#[test]
fn under_vanish_the_goal_is_held_at_the_arrival() {
    check(
        "...",
        "
        rules vanish
        A 00 10
        B 20 10 00
        ",
        "1 vertex A B 10",
    );
}

#[test]
fn under_vanish_an_agent_at_its_goal_from_the_start_holds_it_at_time_0_only() {
    check(
        "...",
        "
        rules vanish
        A 10
        B 00 10 20
        ",
        "",
    );
}

#[test]
fn under_vanish_two_agents_have_one_goal_at_different_times() {
    check(
        "...",
        "
        rules vanish
        A 00 10
        B 20 20 10
        ",
        "",
    );
}

#[test]
fn under_vanish_two_agents_at_one_goal_at_one_time_collide() {
    check(
        "...",
        "
        rules vanish
        A 00 10
        B 20 10
        ",
        "1 vertex A B 10",
    );
}

#[test]
fn under_vanish_swaps_count_up_to_the_arrival() {
    check(
        "..",
        "
        rules vanish
        A 00 10
        B 10 00
        ",
        "0 swap A B 00-10",
    );
}

#[test]
fn an_agent_that_ends_elsewhere_is_judged_as_if_arrived_there() {
    check(
        "...",
        "
        A 00 10 | to 20
        B 20 20 20 10 00 | to 00
        ",
        "
        1 goal A 10
        3 vertex A B 10
        ",
    );
}

#[test]
fn two_that_rest_at_one_cell_collide_once() {
    check(
        "....",
        "
        A 00 10
        B 20 20 10 | to 20
        C 30 30 30 30 30 30 20 30
        ",
        "
        2 goal B 10
        2 vertex A B 10
        ",
    );
}
