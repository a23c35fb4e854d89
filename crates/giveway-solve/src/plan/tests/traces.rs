//! Traces of planners, and what is said of them.

use serde_json::json;

use super::{CROSSING, planned, request, trace};
use crate::plan::{PlanRequest, PlanTrace, Planner, Went, words};

#[test]
fn a_constraint_tree_is_told_by_names_and_cells() {
    let edge = json!({ "agent": "A", "cell": [1, 1], "time": 1 });
    let with = |rule: &str| {
        let mut edge = edge.clone();
        edge["rule"] = rule.into();
        edge
    };
    let expected = json!({
        "giveway": 1,
        "planner": "cbs",
        "left_out": 0,
        "nodes": [
            {
                "id": 0, "parent": null, "constraint": null, "cost": 4, "conflicts": 1,
                "fate": "split", "turn": 0, "bypassed": 0,
                "paths": {
                    "A": [[0, 1], [1, 1], [2, 1]],
                    "B": [[1, 0], [1, 1], [1, 2]]
                },
                "conflict": {
                    "kind": "vertex", "agents": ["A", "B"], "cell": [1, 1], "time": 1, "delays": 2
                }
            },
            {
                "id": 1, "parent": 0, "constraint": with("not-at"), "cost": 5, "conflicts": 0,
                "paths": { "A": [[0, 1], [0, 1], [1, 1], [2, 1]] },
                "fate": "open"
            },
            {
                "id": 2, "parent": 0, "constraint": with("at"), "cost": 5, "conflicts": 0,
                "paths": { "B": [[1, 0], [1, 0], [1, 1], [1, 2]] },
                "fate": "best", "turn": 1, "bypassed": 0
            }
        ]
    });
    assert_eq!(trace(CROSSING, Planner::Cbs), expected);
}

#[test]
fn an_order_is_told_by_names() {
    let expected = json!({
        "giveway": 1,
        "planner": "prioritised",
        "orders": [{
            "order": ["A", "B"],
            "planned": [
                {
                    "agent": "A", "arrival": 2, "alone": 2, "around": [],
                    "path": [[0, 1], [1, 1], [2, 1]]
                },
                {
                    "agent": "B", "arrival": 3, "alone": 2, "around": ["A"],
                    "path": [[1, 0], [1, 0], [1, 1], [1, 2]]
                }
            ],
            "stuck": null
        }]
    });
    assert_eq!(trace(CROSSING, Planner::Prioritised), expected);
}

/// A1 to A3 in a row, with one bay behind them: whoever leads runs into a dead end.
const LAST_IN: &str = include_str!("../../../../../static/examples/last-in.json");

#[test]
fn who_is_stuck_tells_how_far_it_comes() {
    let order = ["A3", "A2", "A1"].map(str::to_owned).to_vec();
    let request = PlanRequest {
        order: Some(order),
        trace: true,
        ..request(LAST_IN, Planner::Prioritised)
    };
    let Some(PlanTrace {
        went: Went::Prioritised { orders },
        ..
    }) = planned(request).trace
    else {
        panic!("no orders");
    };
    let why = words::why_stuck(&orders[0]);
    assert_eq!(
        why.as_deref(),
        Some(
            "A1 cannot get past A2 and A3. At time 5 it stands at (6, 1), and has no free cell at \
             time 6."
        )
    );
    let around = [0, 1, 2].map(|place| words::around(&orders[0], place));
    assert_eq!(
        around,
        ["plans freely", "plans around A3", "around A3 and A2"]
    );
}

#[test]
fn every_planner_finds_a_plan_and_tells_how() {
    for planner in Planner::ALL {
        let told = trace(CROSSING, planner);
        assert_eq!(told["planner"], planner.name());
        let answer = planned(request(CROSSING, planner));
        assert!(
            answer.plan.is_some() && answer.costs.is_some(),
            "{answer:?}"
        );
    }
}
