//! Plans that break a rule in the world of some time: each way is caught.

use super::judge;

/// What the plan breaks, as `time rule agents`.
#[track_caller]
fn breaks(map: &[&str], agents: &str, changes: &str, paths: &str, expected: &[&str]) {
    let report = judge(map, agents, changes, paths);
    let found: Vec<String> = report
        .violations
        .iter()
        .map(|v| format!("{} {} {}", v.time, v.rule.name(), v.agents.join(" ")))
        .collect();
    assert_eq!(found, expected);
    for violation in &report.violations {
        assert!(violation.message.ends_with('.'), "{}", violation.message);
    }
}

const LANE: [&str; 2] = ["....", "...."];

#[test]
fn who_comes_and_goes_at_another_time() {
    let added = "2 add-agent B 20 30";
    breaks(&LANE, "A 00 10", added, "A 00 10; B 20 30", &["0 shape B"]);
    breaks(
        &LANE,
        "A 00 10",
        added,
        "A 00 10; B@1 20 30",
        &["1 shape B"],
    );
    breaks(&LANE, "A 00 10", added, "A 00 10", &["2 shape B"]);
    let gone = "2 remove-agent A";
    breaks(&LANE, "A 00 30", gone, "A 00 10", &["2 shape A"]);
    breaks(
        &LANE,
        "A 00 30",
        gone,
        "A@0-3 00 10 20",
        &["2 shape A", "3 shape A"],
    );
    breaks(&LANE, "A 00 30", gone, "A@0-2 00", &["0 shape A"]);
    breaks(&LANE, "A 00 30", "", "A 00 10 20 30; C 01", &["0 shape C"]);
}

#[test]
fn starts_goals_and_waypoints() {
    let added = "1 add-agent B 30 31";
    breaks(&LANE, "A 00 10", added, "A 00 10; B@1 31", &["1 start B"]);
    breaks(
        &LANE,
        "A 00 10",
        "1 set-goal A 20",
        "A 00 10",
        &["1 goal A"],
    );
    breaks(
        &LANE,
        "A 00 20 via 10",
        "2 add-waypoint A 10",
        "A 00 10 20",
        &["2 waypoint A"],
    );
    breaks(
        &LANE,
        "A 00 10",
        "1 add-waypoint A 11",
        "A 00 10",
        &["1 waypoint A"],
    );
}

#[test]
fn obstacles_and_moves_of_the_time() {
    let blocked = "1 add-obstacle 20";
    breaks(
        &LANE,
        "A 00 30",
        blocked,
        "A 00 10 20 30",
        &["2 obstacle A"],
    );
    breaks(
        &LANE,
        "A 00 30",
        "2 set-slow 20 30",
        "A 00 10 20 30",
        &["2 move A"],
    );
    breaks(
        &["~~~~"],
        "A 00 20",
        "2 set-normal 10 20",
        "A 00 .. 10 .. 20",
        &["2 move A"],
    );
    // A slow move is not begun anew because the edge was slow once.
    breaks(
        &["~~~~"],
        "A 00 10",
        "0 set-normal 00 10",
        "A 00 .. 10",
        &["0 move A"],
    );
}

#[test]
fn breakdowns() {
    let delay = "1 delay-agent A 2";
    breaks(&LANE, "A 00 20", delay, "A 00 10 10 20", &["2 move A"]);
    breaks(&LANE, "A 00 20", delay, "A 00 10 20", &["1 move A"]);
    breaks(
        &["~~."],
        "A 00 20",
        "1 delay-agent A 1",
        "A 00 .. 10 20",
        &["2 move A"],
    );
}

#[test]
fn collisions() {
    let added = "1 add-agent B 30 20";
    breaks(
        &LANE,
        "A 00 30",
        added,
        "A 00 10 20 30; B@1 30 20",
        &["2 vertex A B", "3 vertex A B"][..1],
    );
    breaks(
        &LANE,
        "A 00 30",
        added,
        "A 00 10 20 30; B@1 30 30 20",
        &["2 swap A B"],
    );
    // A rest counts from the arrival on, and ends with the removal.
    breaks(
        &LANE,
        "A 00 10; B 30 01",
        "5 add-obstacle 31",
        "A 00 10; B 30 20 10 00 01",
        &["2 vertex A B"],
    );
    let gone = "2 remove-agent A";
    breaks(
        &LANE,
        "A 00 10; B 30 01",
        gone,
        "A@0-2 00 10; B 30 20 10 00 01",
        &[],
    );
}

#[test]
fn a_slow_move_under_way_is_on_its_edge() {
    let map = ["~~.", "..."];
    let slow = "A 00 .. 10; B 20 20 10 .. 00 01";
    breaks(&map, "A 00 10; B 20 01", "", slow, &["2 vertex A B"]);
    let changed = "1 set-normal 00 10";
    let swap = "A 00 .. 10 20; B 10 10+ 00";
    let swap = swap.replace('+', "");
    breaks(&map, "A 00 20; B 10 00", changed, &swap, &["1 swap A B"]);
    let slow_swap = "A 00 .. 10 20; B 10 10 .. 00";
    breaks(
        &map,
        "A 00 20; B 10 00",
        "",
        slow_swap,
        &["1 slow-swap A B"],
    );
}

#[test]
fn nobody_sets_off_to_an_obstacle() {
    let map = [".#."];
    let removed = "2 remove-obstacle 10";
    breaks(&map, "A 00 20", removed, "A 00 00 00 10 20", &[]);
    let early = "A 00 00 10 20";
    breaks(&map, "A 00 20", removed, early, &["1 obstacle A"]);
}

#[test]
fn batteries_and_charges() {
    let map = ["..+.."];
    let set = "1 set-battery A 1";
    breaks(
        &map,
        "A 00 30 battery 9/9",
        set,
        "A 00 10 20 30",
        &["3 battery A"],
    );
    let taken = "1 remove-charger 20";
    breaks(
        &map,
        "A 00 30 battery 9/9",
        taken,
        "A 00 10 20+ 30",
        &["2 charge A"],
    );
    // A charge shows that it was awake.
    let woken = "4 set-goal A 10";
    breaks(
        &map,
        "A 10 20 battery 9/9",
        woken,
        "A 10 20 20+ 20 20 10",
        &[],
    );
    breaks(
        &map,
        "A 10 20 battery 2/2",
        woken,
        "A~1-4 10 20 20 20 20 10",
        &[],
    );
    // One that was about to go on anyway was awake, and so is one of which the
    // plan does not say that it slept. What it says counts as far as it rests.
    breaks(
        &map,
        "A 10 20 battery 2/2",
        woken,
        "A 10 20 20 20 20 10",
        &["3 battery A"],
    );
    breaks(
        &map,
        "A 10 20 battery 2/2",
        woken,
        "A~0-4 10 20 20 20 20 10",
        &[],
    );
    breaks(
        &map,
        "A 10 20 battery 2/2",
        woken,
        "A~0-3 10 20 20 20 20 10",
        &["3 battery A"],
    );
    breaks(
        &map,
        "A 10 20 battery 1/1",
        woken,
        "A~1-4 10 20 20 20 20 10",
        &["5 battery A"],
    );
}

#[test]
fn an_agent_that_has_vanished_is_gone() {
    breaks(
        &LANE,
        "A 00 10; B 01 11; vanish",
        "3 add-agent C 10 20",
        "A 00 10; B 01 11; C@3 10 20",
        &[],
    );
    breaks(
        &LANE,
        "A 00 10; vanish",
        "1 add-agent C 00 10",
        "A 00 10; C@1 00 10",
        &[],
    );
}
