//! The five costs: makespan, sum of costs, charges, moves, waits.

use giveway_model::check::{arrivals, costs};

use crate::picture::{check_costs, read};

#[test]
fn no_agents_cost_nothing() {
    check_costs(".", "", [0, 0, 0, 0, 0]);
}

#[test]
fn the_makespan_is_the_latest_arrival() {
    check_costs(
        "
        ....
        ....
        ",
        "
        A 00 10 20 30
        B 01 11
        ",
        [3, 4, 0, 4, 0],
    );
}

#[test]
fn a_slow_move_is_one_move() {
    check_costs(".~~.", "A 00 10 .. 20 30", [4, 4, 0, 3, 0]);
}

#[test]
fn waits_at_the_goal_before_leaving_it_again_count() {
    check_costs("...", "A 00 10 10 20 10", [4, 4, 0, 3, 1]);
}

#[test]
fn steps_after_the_arrival_are_no_waits() {
    check_costs("..", "A 00 00 10 10 10", [2, 2, 0, 1, 1]);
}

#[test]
fn a_plan_without_a_path_for_somebody_has_no_costs() {
    let (instance, mut plan) = read(
        "..",
        "
        A 00
        B 10
        ",
    );
    plan.paths.remove("B");
    assert_eq!(costs(&instance, &plan), None);
    assert_eq!(arrivals(&instance, &plan), [Some(0), None]);
}
