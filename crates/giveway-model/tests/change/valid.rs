//! Plans that go on in a world that has changed.

use super::judge;

/// The plan is valid, with these costs: makespan, sum of costs, charges, moves,
/// waits.
#[track_caller]
fn costs(map: &[&str], agents: &str, changes: &str, paths: &str, expected: [u32; 5]) {
    let report = judge(map, agents, changes, paths);
    assert_eq!(report.violations, []);
    let costs = report.costs.unwrap();
    let found = [
        costs.makespan,
        costs.sum_of_costs,
        costs.charges,
        costs.moves,
        costs.waits,
    ];
    assert_eq!(found, expected);
}

#[test]
fn an_agent_joins_and_counts_from_time_0() {
    let added = "2 add-agent B 20 10";
    costs(
        &["...", "..."],
        "A 00 01",
        added,
        "A 00 01; B@2 20 10",
        [3, 4, 0, 2, 0],
    );
}

#[test]
fn a_removed_agent_leaves_all_costs_and_its_cell() {
    let gone = "1 remove-agent B; 1 add-obstacle 20";
    costs(
        &["...", "..."],
        "A 00 01; B 20 00",
        gone,
        "A 00 01; B@0-1 20",
        [1, 1, 0, 1, 0],
    );
}

#[test]
fn a_removed_agent_may_be_in_transit() {
    costs(
        &["~~"],
        "A 00 10",
        "2 remove-agent A",
        "A@0-2 00 ..",
        [0; 5],
    );
}

#[test]
fn a_slow_move_under_way_ends_at_its_own_speed() {
    costs(
        &["~~."],
        "A 00 20",
        "1 set-normal 00 10",
        "A 00 .. 10 20",
        [3, 3, 0, 2, 0],
    );
    costs(
        &["..."],
        "A 00 20",
        "1 set-slow 00 10 20",
        "A 00 10 .. 20",
        [3, 3, 0, 2, 0],
    );
}

#[test]
fn the_tail_of_a_slow_move_is_free() {
    costs(
        &["~~."],
        "A 00 20",
        "1 add-obstacle 00",
        "A 00 .. 10 20",
        [3, 3, 0, 2, 0],
    );
    costs(
        &["~~."],
        "A 00 20",
        "1 add-agent B 00 00",
        "A 00 .. 10 20; B@1 00",
        [3, 4, 0, 2, 0],
    );
}

#[test]
fn who_sleeps_uses_no_battery_and_does_not_wait() {
    let woken = "A~1-4 00 10 10 10 10 20 10";
    let added = "4 add-agent B 00 30";
    let slept = ["....", "...."];
    let paths = format!("{woken}; B@4 00 01 11 21 31 30");
    costs(
        &slept,
        "A 00 10 battery 3/3",
        added,
        &paths,
        [9, 15, 0, 8, 0],
    );
}

#[test]
fn who_is_woken_at_rest_sleeps_on_until_the_last_change() {
    let paths = "A~1-3 00 10 10 10 20 10; B@3 01 00";
    let changes = "2 add-obstacle 21; 3 add-agent B 01 00";
    costs(&["...", "..."], "A 00 10", changes, paths, [5, 9, 0, 4, 0]);
}

#[test]
fn who_stands_at_its_goal_and_goes_on_anyway_is_awake() {
    let paths = "A 00 10 10 10 20 10; B@3 01 00";
    let changes = "2 add-obstacle 21; 3 add-agent B 01 00";
    costs(&["...", "..."], "A 00 10", changes, paths, [5, 9, 0, 4, 2]);
    // Its battery drains meanwhile.
    let paths = "A 00 10 10 10 20 10; B@3 01 00";
    let agents = "A 00 10 battery 4/4";
    let report = judge(&["...", "..."], agents, changes, paths);
    assert_eq!(report.violations.len(), 1, "{:?}", report.violations);
}

#[test]
fn who_is_removed_at_its_goal_slept() {
    for paths in ["A@0-3 20 10", "A@0-3 20 10 10"] {
        let agents = "A 20 10 battery 1/6";
        costs(&["..."], agents, "3 remove-agent A", paths, [0; 5]);
    }
}

#[test]
fn what_is_past_is_listed_as_it_was() {
    let changes = "3 add-charger 00";
    let agents = "A 00 10; vanish";
    let mut plan = super::plan("A 00 10 10 10");
    plan.knows = Some(3);
    let instance = super::instance(&["..."], agents);
    let report =
        giveway_model::check::check_changes(&instance, &super::changes(changes), &plan).unwrap();
    assert!(report.is_valid(), "{:?}", report.violations);
    let costs = report.costs.unwrap();
    assert_eq!((costs.makespan, costs.waits), (3, 2));
}

#[test]
fn an_added_waypoint_is_visited_anew() {
    let paths = "A 00 10 20 10 20";
    costs(
        &["..."],
        "A 00 20 via 10",
        "2 add-waypoint A 10",
        paths,
        [4, 4, 0, 4, 0],
    );
    // Where it stands is a visit; a rest that is not listed goes on.
    costs(
        &["..."],
        "A 00 10",
        "3 add-waypoint A 10",
        "A 00 10",
        [3, 3, 0, 1, 0],
    );
}

#[test]
fn a_waypoint_may_be_dropped_and_a_goal_set() {
    costs(
        &["..."],
        "A 00 20 via 00 10",
        "1 drop-waypoint A 10",
        "A 00 10 20",
        [2, 2, 0, 2, 0],
    );
    costs(
        &["..."],
        "A 00 20",
        "1 set-goal A 10",
        "A 00 10",
        [1, 1, 0, 1, 0],
    );
}

#[test]
fn levels_are_set_and_chargers_come() {
    let changes = "1 set-battery A 1; 1 add-charger 10";
    costs(
        &["...."],
        "A 00 30 battery 9/9",
        changes,
        "A 00 10+ 20 30",
        [3, 3, 1, 3, 0],
    );
}

#[test]
fn a_breakdown_is_waited_out() {
    costs(
        &["..."],
        "A 00 20",
        "1 delay-agent A 2",
        "A 00 10 10 10 20",
        [4, 4, 0, 2, 2],
    );
    costs(
        &["~~."],
        "A 00 20",
        "1 delay-agent A 1",
        "A 00 .. 10 10 20",
        [4, 4, 0, 2, 1],
    );
}

#[test]
fn who_vanishes_at_the_time_of_a_change_is_still_there() {
    let paths = "A 00 10 20 10";
    costs(
        &["..."],
        "A 00 20; vanish",
        "2 set-goal A 10",
        paths,
        [3, 3, 0, 3, 0],
    );
}

#[test]
fn an_obstacle_may_come_and_go() {
    let changes = "1 add-obstacle 20; 2 move-obstacle 20 21; 3 remove-obstacle 21";
    costs(
        &["...", "..."],
        "A 00 20",
        changes,
        "A 00 10 10 20",
        [3, 3, 0, 2, 1],
    );
}

#[test]
fn who_is_removed_in_transit_was_there_for_changes_before() {
    // B is half way into the slow zone at time 2, and removed at its goal at time 3.
    let agents = "A 02 01; B 20 00 battery 7/8; vanish";
    let changes = "2 set-battery B 8; 3 remove-agent B";
    let paths = "A 02 01; B@0-3 20 10 ..";
    costs(
        &["~~.", "...", "..."],
        agents,
        changes,
        paths,
        [1, 1, 0, 1, 0],
    );
}
