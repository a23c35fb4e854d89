//! Agents that break down for good: each stands where it is as an obstacle.

use giveway_model::change::History;
use giveway_model::{Cell, Ground, Instance, Plan};

use super::{changes, instance, judge, plan};

const LANE: [&str; 2] = ["...+", "...."];

/// A goes along the lane, B rests beside it.
fn lane() -> (Instance, Plan) {
    let agents = "A 00 30; B 01 01";
    (instance(&LANE, agents), plan("A 00 10 20 30; B 01"))
}

#[track_caller]
fn refused(lines: &str, expected: &str) {
    let (instance, plan) = lane();
    let faults = History::of(&instance, &changes(lines), &plan).unwrap_err();
    let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
    assert_eq!(told.join("; "), expected);
}

#[test]
fn it_is_an_obstacle_and_leaves_all_costs() {
    let report = judge(
        &LANE,
        "A 00 30; B 01 20",
        "1 stop-agent A",
        "A 00 10; B 01 11 21 20",
    );
    assert!(report.is_valid(), "{:?}", report.violations);
    let costs = report.costs.unwrap();
    assert_eq!((costs.makespan, costs.sum_of_costs), (3, 3));
    // Nobody goes through it.
    let report = judge(
        &LANE,
        "A 00 30; B 01 20",
        "1 stop-agent A",
        "A 00 10; B 01 11 10 20",
    );
    assert!(!report.is_valid());
}

#[test]
fn it_stands_where_the_plan_has_it() {
    let (instance, plan) = lane();
    let history = History::of(&instance, &changes("2 stop-agent A"), &plan).unwrap();
    let place = Cell::new(2, 0);
    assert_eq!(history.grid(1).ground(place), Some(Ground::Free));
    assert_eq!(history.grid(2).ground(place), Some(Ground::Obstacle));
    let stopped = history.timelines()[0].stands().unwrap();
    assert_eq!((stopped.cell, stopped.ground), (place, Ground::Free));
    // Also one that has arrived, beyond the end of the plan.
    let history = History::of(&instance, &changes("9 stop-agent B"), &plan).unwrap();
    let stopped = history.timelines()[1].stands().unwrap();
    assert_eq!(stopped.cell, Cell::new(0, 1));
}

#[test]
fn a_slow_move_under_way_ends_first() {
    let scene = instance(&["~~."], "A 00 20");
    let plan = plan("A 00 .. 10 20");
    let history = History::of(&scene, &changes("1 stop-agent A"), &plan).unwrap();
    let stopped = history.timelines()[0].stands().unwrap();
    let head = Cell::new(1, 0);
    assert_eq!((stopped.cell, stopped.ground.is_slow()), (head, true));
    // Its head counts as occupied, its tail does not.
    assert_eq!(history.grid(1).ground(head), Some(Ground::Obstacle));
    assert!(history.grid(1).is_vertex(Cell::new(0, 0)));
    let report = judge(&["~~."], "A 00 20", "1 stop-agent A", "A 00 .. 10");
    assert!(report.is_valid(), "{:?}", report.violations);
}

/// The path of a stopped agent ends at the time from which it stands.
#[test]
fn its_path_ends_where_it_stands() {
    let breaks = |paths: &str| {
        let report = judge(&LANE, "A 00 30; B 01 01", "2 stop-agent A", paths);
        let all = report.violations.iter();
        all.map(|it| format!("{} {} {}", it.time, it.rule.name(), it.agents.join(" ")))
            .collect::<Vec<_>>()
    };
    let none: [&str; 0] = [];
    assert_eq!(breaks("A 00 10 20; B 01"), none);
    assert_eq!(breaks("A 00 10 20 30; B 01"), ["3 shape A"]);
    assert_eq!(breaks("A 00 10; B 01"), ["1 shape A"]);
    assert_eq!(breaks("A@0-2 00 10; B 01"), ["1 shape A", "2 shape A"]);
    // One that rested may be listed up to its arrival.
    let rested = |paths: &str| judge(&LANE, "A 00 10; B 01 01", "3 stop-agent A", paths);
    assert!(rested("A 00 10; B 01").is_valid());
    assert!(rested("A 00 10 10 10; B 01").is_valid());
}

/// What is left after it broke down, put behind the past, is a plan of the whole.
#[test]
fn the_rest_is_a_plan_of_the_whole() {
    use giveway_model::snapshot::Snapshot;
    let cases = [
        (
            &LANE[..],
            "A 00 30; B 01 31",
            "A 00 10 20 30; B 01 11 21 31",
            2,
        ),
        (
            &["~~.", "..."][..],
            "A 00 20; B 01 21",
            "A 00 .. 10 20; B 01 11 21",
            1,
        ),
        (
            &LANE[..],
            "A 00 10; B 01 21",
            "A 00 10; B 01 01 01 11 21",
            3,
        ),
    ];
    for (map, agents, paths, at) in cases {
        let (instance, plan) = (instance(map, agents), plan(paths));
        let past = History::new(&instance);
        let mut history = past.clone();
        let changes = changes(&format!("{at} stop-agent A"));
        let (_, list) = changes.by_time().pop().unwrap();
        history.apply(at, &list, &plan).unwrap();
        let snapshot = Snapshot::new(at, &instance, (&past, &history), &plan);
        let (path, charges) = {
            let trajectories = history.trajectories(&plan, at);
            assert_eq!(trajectories.len(), 1, "A is no agent any more");
            trajectories[0].rest(at)
        };
        let mut rest = Plan::default();
        rest.paths.insert("B".to_owned(), path);
        rest.charges.insert("B".to_owned(), charges);
        let whole = snapshot.whole(&rest);
        let report = giveway_model::check::check_changes(&instance, &changes, &whole).unwrap();
        assert!(
            report.is_valid(),
            "{agents}: {:?}\n{whole:?}",
            report.violations
        );
        assert!(!whole.until.contains_key("A"));
        let again = History::of(&instance, &changes, &whole).unwrap();
        assert_eq!(again.timelines()[0].stopped, history.timelines()[0].stopped);
        // A later change finds it there.
        let later = super::changes(&format!("{at} stop-agent A; 9 remove-agent A"));
        assert!(History::of(&instance, &later, &whole).is_ok());
    }
}

#[test]
fn only_its_removal_takes_it_away() {
    let (instance, plan) = lane();
    let of = |lines: &str| History::of(&instance, &changes(lines), &plan);
    let place = Cell::new(3, 0);
    let history = of("3 stop-agent A; 5 remove-agent A").unwrap();
    assert_eq!(history.grid(4).ground(place), Some(Ground::Obstacle));
    let charger = history.grid(5).ground(place).unwrap();
    assert!(charger.is_charger(), "the cell is what it was before");
    let timeline = &history.timelines()[0];
    assert_eq!((timeline.until, timeline.stands()), (Some(3), None));
    assert_eq!(timeline.stopped.and_then(|it| it.until), Some(5));
    refused(
        "2 stop-agent A; 3 remove-obstacle 20",
        "changes[1]: found the obstacle at (2, 0), which is A, broken down for good, \
         expected remove-agent with its name, which takes it away",
    );
    refused(
        "2 stop-agent A; 3 move-obstacle 20 10",
        "changes[1]: found the obstacle at (2, 0), which is A, broken down for good, \
         expected remove-agent with its name, which takes it away",
    );
}

#[test]
fn what_contradicts_it_is_refused() {
    let gone = "found A, which has broken down for good, expected a robot that still runs; \
                only remove-agent takes this one away";
    for later in ["3 set-goal A 10", "3 delay-agent A 2", "3 stop-agent A"] {
        refused(
            &format!("2 stop-agent A; {later}"),
            &format!("changes[1]: {gone}"),
        );
    }
    refused(
        "2 stop-agent D",
        "changes[0]: found the unknown robot \"D\", expected a robot that is there",
    );
    refused(
        "2 remove-agent A; 3 stop-agent A",
        "changes[1]: found A, which was removed, expected a robot that is there",
    );
    refused(
        "2 stop-agent A; 3 remove-agent A; 4 remove-agent A",
        "changes[2]: found A, which was removed, expected a robot that is there",
    );
    // Nobody comes where it stands.
    let (instance, plan) = lane();
    let of = |lines: &str| History::of(&instance, &changes(lines), &plan);
    assert!(of("2 stop-agent A; 2 add-agent E 20 10").is_err());
    assert!(of("2 stop-agent A; 2 add-agent E 10 00").is_ok());
    assert!(of("2 add-obstacle 20; 2 stop-agent A").is_err());
}
