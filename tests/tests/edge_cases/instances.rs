//! Instances that are none, or nearly.

use super::{check, check_within, picture};
use giveway_model::Instance;

#[test]
fn no_agents_at_all_is_fine() {
    check(
        ". #",
        "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
    );
    check(
        ". # \n minimise waits,moves",
        "optimal: waits 0, moves 0; complete",
    );
}

#[test]
fn no_agents_and_horizon_0() {
    check_within(
        ".",
        0,
        "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
    );
}

#[test]
fn an_agent_alone_on_the_only_cell() {
    check(
        "aA",
        "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
    );
}

#[test]
fn a_goal_behind_obstacles() {
    check("a # A", "impossible; complete");
}

#[test]
fn a_waypoint_behind_obstacles() {
    check("a A # a!", "impossible; complete");
}

#[test]
fn two_goals_on_one_cell_are_an_error_where_agents_stay() {
    let shared = "a AB b";
    let faults = Instance::new(picture::scene(shared)).unwrap_err();
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert_eq!(faults[0].place, "agents[1].goal");
}
