//! Plans that no order alone keeps safe, and those with moves that begin later.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use giveway_model::change::{Changes, History};
use giveway_model::check::check;
use giveway_model::format::native::{read_instance, read_plan};
use giveway_order::{NoOrder, Order, OrderGraph, words};

fn order(instance: &str, plan: &str) -> Result<Order, NoOrder> {
    let instance = read_instance(instance).unwrap();
    let plan = read_plan(plan).unwrap();
    let report = check(&instance, &plan);
    assert!(report.is_valid(), "{:?}", report.violations);
    let (history, changes) = (History::new(&instance), Changes::default());
    OrderGraph::new(&history, &changes, &plan).map(|graph| graph.order())
}

/// A slow move follows another one a step behind.
#[test]
fn a_slow_move_begins_once_its_end_is_being_left() {
    let order = order(
        r#"{ "giveway": 1, "map": ["~~~"], "agents": [
            { "name": "A", "start": [1, 0], "goal": [2, 0] },
            { "name": "B", "start": [0, 0], "goal": [1, 0] }] }"#,
        r#"{ "giveway": 1, "paths": {
            "A": [[1, 0], [1, 0], null, [2, 0]], "B": [[0, 0], null, [1, 0]] } }"#,
    )
    .unwrap();
    let [shift] = order.later.as_slice() else {
        panic!("{order:?}")
    };
    assert_eq!(
        (shift.agent.as_str(), shift.planned, shift.begins),
        ("B", 0, 1)
    );
    assert_eq!((order.links[0].slack, order.links.len()), (0, 1));
    let told = words::all(&order).join(" ");
    assert!(
        told.contains("B begins its move to (1, 0) at 1, not at 0 as in the plan."),
        "{told}"
    );
    assert!(told.contains("rule \"gap\" 2"), "{told}");
}

/// A comes slowly to (2, 1) a step before B leaves it. B's way out is closed until D has moved
/// twice, the first time into the cell that A leaves: begun together, D would be late.
#[test]
fn moves_that_would_wait_for_each_other_have_no_order() {
    // u = (1, 1), c = (2, 1) slow; D comes to u as A leaves it, goes on to v = (1, 0) while F
    // takes u, and B takes the cell of F.
    let none = order(
        include_str!("data/waits-for-itself.json"),
        include_str!("data/waits-for-itself.plan.json"),
    )
    .unwrap_err();
    let told = words::no_order(&none);
    assert!(
        told.starts_with("No order alone keeps this plan safe: "),
        "{told}"
    );
    let agents: Vec<&str> = none.moves.iter().map(|it| it.agent.as_str()).collect();
    for agent in ["A", "B", "D", "F", "G"] {
        assert!(agents.contains(&agent), "{agents:?}");
    }
}
