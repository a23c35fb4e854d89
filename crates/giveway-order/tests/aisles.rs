//! Six robots at a crossing, with answers that were found by hand.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use giveway_model::change::{Changes, History};
use giveway_model::check::{Rule, check};
use giveway_model::format::native::{read_instance, read_plan};
use giveway_model::{Cell, Instance, Plan};
use giveway_order::{Lateness, LatenessError, Loss, OrderGraph, Outcome, losses, words};

const AISLES: &str = r#"{ "giveway": 1, "name": "two aisles",
  "map": ["..........", ".###.###..", "..........", ".###.###..", ".........."], "agents": [
    { "name": "A1", "start": [0, 4], "goal": [7, 0], "battery": { "capacity": 20, "initial": 12 } },
    { "name": "A2", "start": [9, 4], "goal": [4, 0] },
    { "name": "A3", "start": [6, 4], "goal": [3, 0] }, { "name": "A4", "start": [3, 0], "goal": [4, 4] },
    { "name": "A5", "start": [5, 0], "goal": [3, 4] }, { "name": "A6", "start": [4, 0], "goal": [9, 4] }] }"#;

const PLAN: &str = r#"{ "giveway": 1, "paths": {
    "A1": [[0,4],[0,3],[0,2],[1,2],[2,2],[3,2],[4,2],[4,1],[4,0],[5,0],[6,0],[7,0]],
    "A2": [[9,4],[9,4],[9,4],[8,4],[8,3],[8,2],[7,2],[6,2],[5,2],[4,2],[4,1],[4,0]],
    "A3": [[6,4],[7,4],[8,4],[8,3],[8,2],[7,2],[6,2],[5,2],[4,2],[4,1],[4,0],[3,0]],
    "A4": [[3,0],[3,0],[4,0],[4,1],[4,2],[4,3],[4,4]],
    "A5": [[5,0],[4,0],[4,1],[4,2],[4,3],[4,4],[3,4]],
    "A6": [[4,0],[4,1],[4,2],[4,3],[4,4],[5,4],[6,4],[7,4],[8,4],[9,4]] } }"#;

fn with<T>(read: impl FnOnce(&Instance, &OrderGraph<'_>) -> T) -> T {
    let instance = read_instance(AISLES).unwrap();
    let plan: Plan = read_plan(PLAN).unwrap();
    assert!(check(&instance, &plan).is_valid());
    let (history, changes) = (History::new(&instance), Changes::default());
    let graph = OrderGraph::new(&history, &changes, &plan).unwrap();
    read(&instance, &graph)
}

fn late(agent: &str, cell: [u32; 2], steps: u32) -> Lateness {
    Lateness {
        agent: agent.to_owned(),
        cell: Cell::new(cell[0], cell[1]),
        visit: 1,
        steps,
    }
}

fn arrivals(outcome: &Outcome) -> Vec<(&str, u32)> {
    let all = outcome.arrivals.iter();
    all.map(|it| (it.agent.as_str(), it.now.unwrap())).collect()
}

#[test]
fn each_cell_is_passed_in_order() {
    let order = with(|_, graph| graph.order());
    assert_eq!((order.links.len(), order.without_slack()), (31, 19));
    assert_eq!((order.rotations.len(), order.later.len()), (0, 0));
    let at = order.at(Cell::new(4, 2));
    let at: Vec<_> = at
        .map(|it| (it.first.agent.as_str(), it.second.agent.as_str(), it.slack))
        .collect();
    let expected = [
        ("A6", "A5", 0),
        ("A5", "A4", 0),
        ("A4", "A1", 1),
        ("A1", "A3", 1),
        ("A3", "A2", 0),
    ];
    assert_eq!(at, expected);
    let told = words::all(&order).join(" ");
    assert!(told.contains("19 links have no slack"), "{told}");
    assert!(told.contains("under the rule \"gap\" 1"), "{told}");
}

#[test]
fn a_late_robot_pushes_those_behind_it() {
    with(|instance, graph| {
        let outcome = graph.late(instance, &[late("A4", [4, 1], 3)]).unwrap();
        let expected = [
            ("A1", 13),
            ("A2", 12),
            ("A3", 12),
            ("A4", 9),
            ("A5", 6),
            ("A6", 9),
        ];
        assert_eq!(arrivals(&outcome), expected);
        let pushed: Vec<_> = outcome
            .pushed()
            .map(|it| (it.agent.as_str(), it.most))
            .collect();
        assert_eq!(pushed, [("A1", 2), ("A2", 1), ("A3", 1)]);
        // The battery of A1 had one step to spare.
        let spare = Loss::Battery {
            agent: "A1".to_owned(),
            spare: 1,
        };
        assert_eq!(losses(graph), [spare]);
        let broken: Vec<Rule> = outcome.violations.iter().map(|it| it.rule).collect();
        assert_eq!(broken, [Rule::Battery]);
        let told = words::outcome(&outcome).join(" ");
        assert_eq!(
            told,
            "If A4 comes 3 steps late to (4, 1), 3 robots are pushed: A1 by 2 steps, A2 by 1 step and A3 by 1 step. \
             The last robot arrives at 13, not at 11. This does not go well then: The battery of A1 is at -1 at time 13, \
             below the floor of 0."
        );
    });
}

#[test]
fn slack_takes_up_lateness() {
    with(|instance, graph| {
        let outcome = graph.late(instance, &[late("A4", [4, 1], 1)]).unwrap();
        assert_eq!(outcome.pushed().count(), 0);
        assert!(outcome.violations.is_empty());
        let told = words::outcome(&outcome).join(" ");
        let expected = "If A4 comes 1 step late to (4, 1), no other robot is pushed. \
             The last robot arrives at 11, as planned.";
        assert_eq!(told, expected);
    });
}

#[test]
fn a_lateness_that_is_none_is_refused() {
    with(|instance, graph| {
        let refused = |late: Lateness| graph.late(instance, &[late]).unwrap_err().1;
        assert_eq!(
            refused(late("B1", [4, 1], 1)),
            LatenessError::NoAgent("B1".to_owned())
        );
        let nowhere = late("A4", [9, 1], 1);
        assert_eq!(refused(nowhere.clone()), LatenessError::NoVisit(nowhere));
        assert_eq!(
            refused(late("A4", [4, 1], 10_001)),
            LatenessError::TooLong(10_001)
        );
        let twice = Lateness {
            visit: 2,
            ..late("A4", [4, 1], 1)
        };
        let fault = refused(twice).fault(3);
        assert_eq!(
            fault.to_string(),
            "late[3].visit: found visit 2 of A4 at (4, 1), expected one that the plan has"
        );
    });
}
