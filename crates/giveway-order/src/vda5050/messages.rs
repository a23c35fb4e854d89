//! Order messages of the protocol: nodes and edges.

use giveway_model::Cell;
use serde_json::{Value, json};

use super::stamp::stamp;
use crate::AgentOrder;
use crate::waypoints::World;

/// The version of the protocol that the messages are written in.
const VERSION: &str = "2.1.0";

/// Writes messages.
pub(super) struct Writer<'a> {
    pub(super) world: World,
    pub(super) map: &'a str,
}

impl Writer<'_> {
    /// The message with the visits from one on: up to a second one they are released, and up
    /// to a third one they are the horizon.
    pub(super) fn message(
        &self,
        agent: &AgentOrder,
        (update, time): (u32, u32),
        (first, released, end): (usize, usize, usize),
    ) -> Value {
        let visits = agent.visits.iter().enumerate();
        let visits = visits.skip(first).take(end.saturating_sub(first));
        let (mut nodes, mut edges) = (Vec::new(), Vec::new());
        for (number, visit) in visits {
            let is_released = number < released;
            if number > first
                && let Some(before) = agent.visits.get(number - 1)
            {
                edges.push(self.edge(
                    (before.cell, visit.cell),
                    number,
                    visit.is_slow(),
                    is_released,
                ));
            }
            let (x, y) = self.world.middle(visit.cell);
            let charge = json!({
                "actionId": format!("{}-{number}-charge", agent.agent),
                "actionType": "startCharging",
                "blockingType": "HARD",
            });
            nodes.push(json!({
                "nodeId": node_id(visit.cell),
                "sequenceId": 2 * number,
                "released": is_released,
                "nodePosition": { "x": x.number(), "y": y.number(), "mapId": self.map },
                "actions": if visit.charges { vec![charge] } else { Vec::new() },
            }));
        }
        json!({
            "headerId": update,
            "timestamp": stamp(self.world.time(time).number()),
            "version": VERSION,
            "manufacturer": "giveway",
            "serialNumber": agent.agent,
            "orderId": agent.agent,
            "orderUpdateId": update,
            "nodes": nodes,
            "edges": edges,
        })
    }

    /// The edge to the visit of a number.
    fn edge(
        &self,
        (from, to): (Cell, Cell),
        number: usize,
        is_slow: bool,
        released: bool,
    ) -> Value {
        let (start, end) = (node_id(from), node_id(to));
        let mut edge = json!({
            "edgeId": format!("{start}_{end}"),
            "sequenceId": 2 * number - 1,
            "released": released,
            "startNodeId": start,
            "endNodeId": end,
            "actions": [],
        });
        let speed = self.world.speed(if is_slow { 2 } else { 1 });
        if let (Some(speed), Some(edge)) = (speed, edge.as_object_mut()) {
            edge.insert("maxSpeed".to_owned(), json!(speed));
        }
        edge
    }
}

fn node_id(cell: Cell) -> String {
    format!("{}-{}", cell.x, cell.y)
}
