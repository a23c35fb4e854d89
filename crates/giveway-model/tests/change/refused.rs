//! Changes that contradict the world: refused with the reason.

use giveway_model::change::{History, MAX_TIME};

use super::{changes, instance, plan};

/// A walks 00 10 20 30, B sleeps at 01 from the beginning, C goes a slow way
/// from 03 to 13 and on.
const MAP: [&str; 4] = ["....", "....", "#..+", "~~.."];
const AGENTS: &str = "A 00 30; B 01 01 battery 4/5; C 03 23 via 13";
const PLAN: &str = "A 00 10 20 30; B 01; C 03 .. 13 23";

#[track_caller]
fn refused(lines: &str, expected: &str) {
    let instance = instance(&MAP, AGENTS);
    let plan = plan(PLAN);
    let mut history = History::new(&instance);
    let untouched = history.clone();
    let changes = changes(lines);
    let (at, list) = changes.by_time().pop().unwrap();
    let faults = history.apply(at, &list, &plan).unwrap_err();
    let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
    assert_eq!(told.join("; "), expected);
    assert_eq!(history, untouched, "nothing changes");
}

#[test]
fn obstacles_where_somebody_is() {
    refused(
        "1 add-obstacle 10",
        "changes[0]: found an obstacle at (1, 0), where A is at time 1, expected a cell that is free then",
    );
    // The head of a slow move counts, and a sleeper.
    refused(
        "1 add-obstacle 13; 1 move-obstacle 02 01",
        "changes[0]: found an obstacle at (1, 3), which C is entering at time 1, expected a cell that is free then; \
         changes[1]: found an obstacle at (0, 1), where B is at time 1, expected a cell that is free then",
    );
}

#[test]
fn obstacles_that_are_there_or_not() {
    refused(
        "1 add-obstacle 02",
        "changes[0]: found the obstacle (0, 2), expected a cell without one",
    );
    refused(
        "1 remove-obstacle 10",
        "changes[0]: found (1, 0), which is not an obstacle, expected an obstacle",
    );
    refused(
        "1 add-obstacle 44",
        "changes[0]: found (4, 4), expected a cell of the 4 x 4 map",
    );
    refused(
        "1 set-slow 02",
        "changes[0]: found the obstacle (0, 2), expected a free cell",
    );
    refused(
        "1 add-charger 32",
        "changes[0]: found the charger (3, 2), expected a cell without one",
    );
    refused(
        "1 remove-charger 00",
        "changes[0]: found (0, 0), which is not a charger, expected a charger",
    );
}

#[test]
fn agents_that_cannot_come() {
    refused(
        "1 add-agent D 10 11",
        "changes[0]: found D at (1, 0), where A is at time 1, expected a cell that is free then",
    );
    refused(
        "1 add-agent D 11 22; 1 add-agent E 11 21",
        "changes[1]: found E at (1, 1), where D is at time 1, expected a cell that is free then",
    );
    refused(
        "1 add-agent A 11 22",
        "changes[0]: found the name \"A\" of another robot, now or earlier, expected a name of its own",
    );
    refused(
        "1 add-agent D 11 30",
        "changes[0]: found (3, 0) as the goal of both A and D, expected different goals, since robots stay at their goals",
    );
    refused(
        "1 add-agent D 11 02",
        "changes[0]: found the obstacle (0, 2), expected a free cell",
    );
}

#[test]
fn agents_that_are_not_there() {
    refused(
        "1 remove-agent D",
        "changes[0]: found the unknown robot \"D\", expected a robot that is there",
    );
    refused(
        "1 remove-agent A; 1 set-goal A 10",
        "changes[1]: found A, which was removed, expected a robot that is there",
    );
}

#[test]
fn a_vanished_agent_is_gone() {
    let instance = instance(&["..."], "A 00 10; vanish");
    let plan = plan("A 00 10");
    let of = |lines: &str| History::of(&instance, &changes(lines), &plan);
    assert!(of("1 remove-agent A").is_ok());
    assert_eq!(
        of("2 remove-agent A").unwrap_err()[0].found,
        "A, which has vanished by time 2"
    );
}

#[test]
fn a_name_is_used_for_ever() {
    let instance = instance(&["..."], "A 00 10");
    let plan = plan("A@0-1 00");
    let lines = "1 remove-agent A; 2 add-agent A 00 10";
    let faults = History::of(&instance, &changes(lines), &plan).unwrap_err();
    assert_eq!(faults[0].place, "changes[1]");
}

#[test]
fn goals_waypoints_and_levels() {
    refused(
        "1 set-goal B 30",
        "changes[0]: found (3, 0) as the goal of both A and B, expected different goals, since robots stay at their goals",
    );
    refused(
        "1 drop-waypoint A 10",
        "changes[0]: found (1, 0), which is not a waypoint of A, expected one of its waypoints",
    );
    refused(
        "1 add-waypoint C 13",
        "changes[0]: found (1, 3), which C already has to visit, expected another cell",
    );
    refused(
        "1 set-battery B 6",
        "changes[0]: found the level 6 for B, expected at most the capacity, 5",
    );
    refused(
        "1 set-battery A 6",
        "changes[0]: found a level for A, which has no battery, expected a robot with one",
    );
}

#[test]
fn times_far_away() {
    let late = format!("{} remove-agent A", MAX_TIME + 1);
    refused(
        &late,
        "changes[0]: found the time 1000001, expected at most 1000000",
    );
    let instance = instance(&MAP, AGENTS);
    let plan = plan(PLAN);
    // A time beyond the makespan is fine.
    let lines = format!("{MAX_TIME} set-goal B 21");
    assert!(History::of(&instance, &changes(&lines), &plan).is_ok());
}

#[test]
fn what_is_accepted() {
    let instance = instance(&MAP, AGENTS);
    let plan = plan(PLAN);
    let of = |lines: &str| History::of(&instance, &changes(lines), &plan);
    // An obstacle on somebody's goal or unvisited waypoint.
    assert!(of("1 add-obstacle 30").is_ok());
    assert!(of("0 add-obstacle 13").is_ok());
    // Cells that become free at that time; goals that are exchanged.
    assert!(of("1 remove-agent A; 1 add-obstacle 10").is_ok());
    assert!(of("1 add-obstacle 00; 1 add-obstacle 03").is_ok());
    assert!(of("1 set-goal A 01; 1 set-goal B 30").is_ok());
    assert!(of("3 add-waypoint C 13").is_ok());
}
