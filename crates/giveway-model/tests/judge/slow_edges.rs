//! Two agents around one slow edge.

use crate::picture::check;

#[test]
fn a_slow_swap_at_offset_0() {
    check(
        "~~",
        "
        A 10 .. 00
        B 00 .. 10
        ",
        "0 slow-swap A B 10-00",
    );
}

#[test]
fn a_slow_swap_at_offset_1() {
    check(
        "
        ~~
        #.
        ",
        "
        A 00 .. 10 11 | to 11
        B 11 10 .. 00
        ",
        "1 slow-swap A B 00-10",
    );
    // The one that leaves later may stand first in the instance.
    check(
        "
        ~~
        #.
        ",
        "
        B 11 10 .. 00
        A 00 .. 10 11
        ",
        "1 slow-swap B A 10-00",
    );
}

#[test]
fn at_offset_2_there_is_no_slow_swap() {
    // A is at the far end when B leaves it: they meet at the vertex instead.
    check(
        "
        ~~
        #.
        ",
        "
        A 00 .. 10 11
        B 11 11 10 .. 00
        ",
        "
        2 vertex A B 10
        ",
    );
}

#[test]
fn one_behind_the_other_into_a_slow_edge() {
    check(
        ".~~~",
        "
        A 10 .. 20 .. 30
        B 00 10 .. 20
        ",
        "",
    );
}

#[test]
fn entering_while_another_stands_at_the_far_end_and_leaves_in_time() {
    check(
        "
        ~~
        #.
        ",
        "
        A 00 .. 10
        B 10 10 11
        ",
        "",
    );
}

#[test]
fn entering_while_another_stands_at_the_far_end_and_stays_too_long() {
    check(
        "
        ~~
        #.
        ",
        "
        A 00 .. 10
        B 10 10 10 11
        ",
        "2 vertex A B 10",
    );
}

#[test]
fn an_agent_in_transit_is_at_no_vertex() {
    // B passes over both ends of A's edge while A is inside.
    check(
        "
        .~.
        .~.
        ",
        "
        A 10 .. 11
        B 00 10 20 | to 20
        ",
        "",
    );
    check(
        "
        .~.
        .~.
        ",
        "
        A 10 .. 11
        B 01 11 21
        ",
        "",
    );
}

#[test]
fn two_in_transit_do_not_collide_by_that_alone() {
    check(
        "
        ~~~
        ~~~
        ",
        "
        A 00 .. 10
        B 01 .. 11
        C 20 .. 21
        ",
        "",
    );
}

#[test]
fn two_that_end_slow_moves_at_one_vertex() {
    check(
        "~~~",
        "
        A 00 .. 10 .. 20
        B 20 .. 10 .. 00
        ",
        "2 vertex A B 10",
    );
}

#[test]
fn entering_the_slow_edge_when_the_last_one_comes_out_and_moves_on() {
    check(
        "
        ~~.
        ..#
        ",
        "
        A 00 .. 10 20
        B 11 11 11 10 .. 00
        ",
        "",
    );
}
