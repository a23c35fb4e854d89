//! Vertex and swap collisions, following, chains and cycles.

use crate::picture::check;

#[test]
fn two_agents_at_one_vertex() {
    check(
        "
        ...
        #.#
        ",
        "
        A 00 10 20
        B 11 10 00 | to 00
        ",
        "1 vertex A B 10",
    );
}

#[test]
fn three_agents_at_one_vertex_are_three_pairs() {
    check(
        "
        ...
        ...
        ",
        "
        A 00 10 20
        B 11 10 00
        C 20 10 11
        ",
        "
        1 vertex A B 10
        1 vertex A C 10
        1 vertex B C 10
        ",
    );
}

#[test]
fn a_swap_over_a_normal_edge() {
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
fn the_edge_of_a_swap_is_as_the_first_agent_goes() {
    check(
        "...",
        "
        A 20 20 10
        B 10 10 20
        ",
        "1 swap A B 20-10",
    );
}

#[test]
fn crossing_one_edge_at_different_times_is_no_swap() {
    check(
        "
        ...
        #.#
        ",
        "
        A 00 10 11
        B 20 20 10 00
        ",
        "",
    );
}

#[test]
fn following_is_allowed() {
    check(
        "....",
        "
        A 10 20 30
        B 00 10 20
        ",
        "",
    );
}

#[test]
fn a_chain_moves_as_one() {
    check(
        "....",
        "
        C 00 10
        B 10 20
        A 20 30
        ",
        "",
    );
}

#[test]
fn a_cycle_of_four_rotates() {
    check(
        "
        ..
        ..
        ",
        "
        A 00 10
        B 10 11
        C 11 01
        D 01 00
        ",
        "",
    );
}

#[test]
fn a_cycle_of_four_rotates_over_slow_edges() {
    check(
        "
        ~~
        ~~
        ",
        "
        A 00 .. 10
        B 10 .. 11
        C 11 .. 01
        D 01 .. 00
        ",
        "",
    );
}

#[test]
fn a_cycle_of_six_rotates_over_slow_and_normal_edges() {
    // Only the three cells on top are slow: their two edges take two steps, and
    // the others wait a step for them.
    check(
        "
        ~~~
        ...
        ",
        "
        A 00 .. 10
        B 10 .. 20
        C 20 20 21
        D 21 21 11
        E 11 11 01
        F 01 01 00
        ",
        "",
    );
}

#[test]
fn three_of_a_cycle_rotate_where_the_fourth_cell_is_empty() {
    check(
        "
        ..
        ..
        ",
        "
        A 00 10
        B 10 11
        C 11 01
        ",
        "",
    );
    check(
        "
        ~~
        ~~
        ",
        "
        A 00 .. 10
        B 10 .. 11
        C 11 .. 01
        ",
        "",
    );
}

#[test]
fn a_cycle_of_two_is_a_swap() {
    check(
        "~~",
        "
        A 00 .. 10
        B 10 .. 00
        ",
        "0 slow-swap A B 00-10",
    );
}

#[test]
fn collisions_come_by_time_then_rule_then_agents() {
    check(
        "
        ....
        ....
        ",
        "
        A 00 10 10
        B 10 00 10 00
        C 11 21 21 11 | to 01
        D 21 11 11 21
        ",
        "
        0 swap A B 00-10
        0 swap C D 11-21
        2 vertex A B 10
        2 swap C D 21-11
        3 goal C 11
        ",
    );
}
