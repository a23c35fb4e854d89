//! Levels, floors and charges.

use giveway_model::check::levels;

use crate::picture::{check, check_costs, read};

/// The levels of the first agent of a valid plan.
#[track_caller]
fn check_levels(map: &str, plan: &str, expected: &[i64]) {
    check(map, plan, "");
    let (instance, plan) = read(map, plan);
    assert_eq!(levels(&instance, 0, &plan), expected);
}

#[test]
fn waits_and_moves_take_one_each() {
    check_levels("...", "A 00 00 10 20 | battery 9/9", &[9, 8, 7, 6]);
}

#[test]
fn each_half_of_a_slow_move_takes_one() {
    check_levels("~~", "A 00 .. 10 | battery 9/9", &[9, 8, 7]);
}

#[test]
fn a_level_equal_to_the_floor_is_fine() {
    check_levels("...", "A 00 10 20 | battery 2/2", &[2, 1, 0]);
    check_levels(
        "...",
        "
        A 00 10 20 | battery 3/3
        rules floor 1
        ",
        &[3, 2, 1],
    );
}

#[test]
fn a_level_below_the_floor_is_told_once_a_stretch() {
    check("....", "A 00 10 20 30 | battery 1/9", "2 battery A 20");
    check(
        "..+...",
        "A 00 10 20+ 30 40 50 | battery 1/2",
        "
        2 battery A 20
        ",
    );
    check(
        "..+...",
        "
        A 00 10 20+ 30 40 50 | battery 1/1
        ",
        "
        2 battery A 20
        5 battery A 50
        ",
    );
}

#[test]
fn the_level_counts_at_the_arrival_itself() {
    check("..", "A 00 10 | battery 0/9", "1 battery A 10");
}

#[test]
fn a_level_may_fall_below_the_floor_in_transit() {
    check("~~", "A 00 .. 10 | battery 0/9", "1 battery A");
}

#[test]
fn an_initial_level_below_the_floor_is_a_fault_of_the_plan_not_of_the_input() {
    check(
        "+.",
        "
        A 00+ 10 | battery 1/9
        rules floor 3
        ",
        "0 battery A 00",
    );
}

#[test]
fn an_agent_at_its_goal_uses_nothing() {
    check_levels(
        "....",
        "
        A 00 10 | battery 1/1
        B 20 20 20 20 20 30
        ",
        &[1, 0],
    );
}

#[test]
fn start_at_the_goal_with_an_empty_battery_is_fine() {
    check_levels(".", "A 00 | battery 0/0", &[0]);
}

#[test]
fn an_agent_may_charge_at_its_start_at_time_0() {
    check_levels("+...", "A 00+ 10 20 30 | battery 0/5", &[0, 5, 4, 3]);
}

#[test]
fn an_agent_may_charge_in_consecutive_steps_and_each_counts() {
    check_levels("+..", "A 00+ 00+ 10 | battery 3/4", &[3, 4, 4]);
    check_costs("+..", "A 00+ 00+ 10 | battery 3/4", [2, 2, 2, 1, 1]);
}

#[test]
fn an_agent_may_charge_and_leave_by_a_slow_move() {
    check_levels("*~", "A 00+ .. 10 | battery 0/5", &[0, 5, 4]);
}

#[test]
fn passing_a_charger_without_choosing_to_charge_changes_nothing() {
    check_levels(".+.", "A 00 10 20 | battery 5/9", &[5, 4, 3]);
}

#[test]
fn a_charge_of_a_full_battery_is_allowed() {
    check_levels("+.", "A 00+ 10 | battery 5/5", &[5, 5]);
}

#[test]
fn two_agents_without_batteries_have_no_levels() {
    check_levels("..", "A 00 10", &[]);
}

#[test]
fn no_charge_off_a_charger() {
    check("...", "A 00+ 10 20 | battery 9/9", "0 charge A 00");
}

#[test]
fn a_charge_off_a_charger_fills_nothing() {
    check(
        "...",
        "A 00 10+ 20 | battery 1/9",
        "
        1 charge A 10
        2 battery A 20
        ",
    );
}

#[test]
fn no_charge_in_transit() {
    check("**", "A 00 ..+ 10 | battery 9/9", "1 charge A");
}

#[test]
fn no_charge_at_the_arrival() {
    check("++", "A 00 10+ | battery 9/9", "1 charge A");
}

#[test]
fn no_charge_after_the_arrival() {
    check("++", "A 00 10 10+ 10 | battery 9/9", "2 charge A");
}

#[test]
fn no_charge_at_the_goal_that_is_the_start() {
    check("+", "A 00+ 00 | battery 9/9", "0 charge A");
}

#[test]
fn a_charge_at_the_goal_before_the_arrival_is_fine() {
    check_levels(".+.", "A 00 10+ 20 10 | battery 1/5, via 20", &[1, 0, 5, 4]);
}

#[test]
fn no_charge_without_a_battery() {
    check("+.", "A 00+ 10", "0 charge A");
}
