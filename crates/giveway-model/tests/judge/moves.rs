//! Waits, moves, slow moves and obstacles of one agent.

use crate::picture::check;

#[test]
fn waits_and_moves_to_all_four_sides_are_fine() {
    check(
        "
        ...
        ...
        ...
        ",
        "A 11 11 10 11 21 11 12 11 01",
        "",
    );
}

#[test]
fn a_slow_move_takes_two_steps() {
    check(".~~.", "A 00 10 .. 20 30", "");
}

#[test]
fn a_slow_edge_in_one_step_is_too_fast() {
    check("~~", "A 00 10", "0 move A 00-10");
}

#[test]
fn an_edge_with_one_end_in_the_slow_zone_is_normal() {
    check(".~", "A 00 10", "");
    check(".~", "A 00 .. 10", "0 move A 00-10");
}

#[test]
fn the_inside_of_the_zone_is_slow_towards_all_sides() {
    check(
        "
        ~~
        ~*
        ",
        "A 00 .. 10 .. 11 .. 01 .. 00",
        "",
    );
}

#[test]
fn waiting_inside_the_zone_is_as_anywhere() {
    check("~~~", "A 00 00 .. 10 10 10 .. 20", "");
}

#[test]
fn nobody_stops_inside_a_slow_move() {
    check("~~", "A 00 .. .. 10", "0 move A 00-10");
}

#[test]
fn nobody_turns_inside_a_slow_move() {
    check("~~", "A 00 .. 00 .. 10", "0 move A 00");
}

#[test]
fn a_jump_is_no_move() {
    check(
        "
        ...
        ...
        ",
        "A 00 20 01 01",
        "
        0 move A 00-20
        1 move A 20-01
        ",
    );
    check("~~~", "A 00 .. 20", "0 move A 00-20");
}

#[test]
fn a_diagonal_is_no_move() {
    check(
        "
        ..
        ..
        ",
        "A 00 11",
        "0 move A 00-11",
    );
}

#[test]
fn an_obstacle_is_no_vertex() {
    check(".#.", "A 00 10 20", "1 obstacle A 10");
}

#[test]
fn each_time_in_an_obstacle_counts() {
    check(
        ".#.",
        "A 00 10 10 20",
        "
        1 obstacle A 10
        2 obstacle A 10
        ",
    );
}

#[test]
fn off_the_map_is_no_vertex() {
    check("..", "A 00 01 00 10", "1 obstacle A 01");
}
