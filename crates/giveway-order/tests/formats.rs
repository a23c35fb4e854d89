//! The order as way-points, as DOT, and as VDA 5050 orders.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod messages;

use giveway_model::change::{Changes, History};
use giveway_model::format::native::{read_instance, read_plan};
use giveway_model::{Instance, Plan};
use giveway_order::{Order, OrderGraph, csv, dot, waypoints};
use messages::{Schemas, messages};
use serde_json::{Value, json};

/// Two robots follow each other around a corner; the first one charges at its start.
const CORNER: &str = r##"{ "giveway": 1, "name": "corner", "map": ["+..", "#.."],
  "units": { "cell": 0.85, "step": 1.5 }, "agents": [
    { "name": "A \"1\"", "start": [0, 0], "goal": [2, 1], "battery": { "capacity": 9, "initial": 1 } },
    { "name": "A,2", "start": [1, 1], "goal": [0, 0], "heading": "west" }] }"##;
const CORNER_PLAN: &str = r#"{ "giveway": 1, "charges": { "A \"1\"": [0] }, "paths": {
    "A \"1\"": [[0, 0], [1, 0], [2, 0], [2, 1]],
    "A,2": [[1, 1], [1, 1], [1, 0], [0, 0]] } }"#;

/// Four robots in a circle.
const RING: &str = r#"{ "giveway": 1, "map": ["~~", "~~"], "agents": [
    { "name": "A", "start": [0, 0], "goal": [1, 0] }, { "name": "B", "start": [1, 0], "goal": [1, 1] },
    { "name": "C", "start": [1, 1], "goal": [0, 1] }, { "name": "D", "start": [0, 1], "goal": [0, 0] }] }"#;
const RING_PLAN: &str = r#"{ "giveway": 1, "paths": {
    "A": [[0, 0], null, [1, 0]], "B": [[1, 0], null, [1, 1]],
    "C": [[1, 1], null, [0, 1]], "D": [[0, 1], null, [0, 0]] } }"#;

fn order(instance: &str, plan: &str) -> (Instance, Order) {
    let instance = read_instance(instance).unwrap();
    let plan: Plan = read_plan(plan).unwrap();
    assert!(giveway_model::check::check(&instance, &plan).is_valid());
    let (history, changes) = (History::new(&instance), Changes::default());
    let order = OrderGraph::new(&history, &changes, &plan).unwrap().order();
    (instance, order)
}

#[test]
fn way_points_are_in_metres_seconds_and_degrees() {
    let (instance, order) = order(CORNER, CORNER_PLAN);
    let units = instance.to_scene().units;
    assert_eq!(
        csv(&order, 2, units),
        "agent,visit,column,row,x_m,y_m,arrives_s,leaves_s,heading_deg\n\
         \"A \"\"1\"\"\",0,0,0,0.425,1.275,0,0,0\n\
         \"A \"\"1\"\"\",1,1,0,1.275,1.275,1.5,1.5,0\n\
         \"A \"\"1\"\"\",2,2,0,2.125,1.275,3,3,0\n\
         \"A \"\"1\"\"\",3,2,1,2.125,0.425,4.5,,-90\n\
         \"A,2\",0,1,1,1.275,0.425,0,1.5,180\n\
         \"A,2\",1,1,0,1.275,1.275,3,3,90\n\
         \"A,2\",2,0,0,0.425,1.275,4.5,,180\n"
    );
    let points = waypoints(&order, 2, None);
    assert_eq!((points[3].x, points[3].y), (2.5, 0.5));
    assert_eq!((points[3].arrives, points[3].leaves), (3.0, None));
    assert!(
        csv(&order, 2, None).starts_with("agent,visit,column,row,x_cells,y_cells,arrives_steps,")
    );
}

#[test]
fn all_four_headings_and_borders_of_the_map_are_right() {
    let (_, order) = order(RING, RING_PLAN);
    let units = serde_json::from_str(r#"{ "cell": 2, "step": 0.5 }"#).unwrap();
    let points = waypoints(&order, 2, Some(units));
    let ends: Vec<_> = points.iter().filter(|it| it.visit == 1).collect();
    let told: Vec<_> = ends
        .iter()
        .map(|it| (it.x, it.y, it.heading, it.arrives))
        .collect();
    let expected = [
        (3.0, 3.0, Some(0), 1.0),
        (3.0, 1.0, Some(-90), 1.0),
        (1.0, 1.0, Some(180), 1.0),
        (1.0, 3.0, Some(90), 1.0),
    ];
    assert_eq!(told, expected);
}

#[test]
fn a_graph_in_dot_has_each_visit_and_each_link() {
    let (_, order) = order(CORNER, CORNER_PLAN);
    let text = dot(&order);
    assert!(text.contains(r#"label="A \"1\"";"#), "{text}");
    assert!(
        text.contains(r#""A \"1\"/2" -> "A,2/1" [style=bold, label="0"];"#),
        "{text}"
    );
    assert!(
        text.contains(r#""A \"1\"/1" -> "A,2/2" [style=dashed, label="2"];"#),
        "{text}"
    );
    assert_eq!(text.matches("[label=\"(").count(), 7);
    let (_, ring) = self::order(RING, RING_PLAN);
    assert_eq!(dot(&ring).matches("dir=both").count(), 4);
}

#[test]
fn orders_are_released_one_after_the_other() {
    let (instance, order) = order(CORNER, CORNER_PLAN);
    let messages = messages(&instance, &order);
    Schemas::published().accept(&messages);
    let [first, second] = messages.orders.as_slice() else {
        panic!("{messages:?}")
    };
    assert!(
        first["nodes"]
            .as_array()
            .unwrap()
            .iter()
            .all(|it| it["released"] == true)
    );
    assert_eq!(
        first["nodes"][0]["actions"][0]["actionType"],
        "startCharging"
    );
    assert_eq!(
        first["nodes"][0]["nodePosition"],
        json!({ "x": 0.425, "y": 1.275, "mapId": "corner" })
    );
    assert!((first["edges"][0]["maxSpeed"].as_f64().unwrap() - 0.85 / 1.5).abs() < 1e-9);
    let released = |it: &Value| -> Vec<bool> {
        let nodes = it["nodes"].as_array().unwrap().iter();
        nodes.map(|it| it["released"].as_bool().unwrap()).collect()
    };
    assert_eq!(released(second), [true, false, false]);
    let [one, two] = messages.updates.as_slice() else {
        panic!("{messages:?}")
    };
    assert_eq!(
        json!(one.after),
        json!([{ "serialNumber": "A \"1\"", "sequenceId": 4 }])
    );
    assert_eq!(
        (released(&one.order), &one.order["orderUpdateId"]),
        (vec![true, true, false], &json!(1))
    );
    assert_eq!(one.order["timestamp"], "1970-01-01T00:00:03.000Z");
    assert_eq!(
        json!(two.after),
        json!([{ "serialNumber": "A \"1\"", "sequenceId": 2 }])
    );
    assert_eq!(released(&two.order), [true, true]);
    assert_eq!(two.order["nodes"][0], one.order["nodes"][1]);
}

#[test]
fn robots_that_rotate_are_released_together() {
    let (instance, order) = order(RING, RING_PLAN);
    assert_eq!(
        (order.rotations.len(), order.rotations[0].moves.len()),
        (1, 4)
    );
    let messages = messages(&instance, &order);
    Schemas::published().accept(&messages);
    assert_eq!(messages.updates.len(), 4);
    assert!(messages.updates.iter().all(|it| it.after.len() == 4));
    // Without units nothing is said of speeds.
    assert_eq!(messages.orders[0]["edges"][0].get("maxSpeed"), None);
}
