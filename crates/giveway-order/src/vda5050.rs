//! Orders of VDA 5050, released in the order of the graph.
//!
//! A fleet's control releases a node to a robot once the robot before it has reached its next
//! node: by then the cell is free. So robots do not follow each other in one step, and lose a
//! step at each link without slack.

use std::collections::BTreeMap;

use giveway_model::sorting::{map, sort_by_key};
use giveway_model::{Cell, Units};
use serde::Serialize;
use serde_json::{Value, json};

use crate::waypoints::World;
use crate::{AgentOrder, Link, Order, Rotation};

/// The version of the protocol that the messages are written in.
const VERSION: &str = "2.1.0";

/// The messages of a fleet: an order for each robot, and the updates that release its nodes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Vda5050 {
    /// The first order of each robot: its nodes up to the first one that waits for another
    /// robot are released, the rest is its horizon.
    pub orders: Vec<Value>,
    /// The updates, in an order in which they can be sent.
    pub updates: Vec<Update>,
}

/// An update of an order, and what has to be so before it is sent.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Update {
    /// Robots that have to have reached nodes.
    pub after: Vec<Reached>,
    /// The order message: its first node is the last one released before; its horizon are the
    /// nodes that the next update releases.
    pub order: Value,
}

/// A robot has reached a node.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Reached {
    /// Its serial number: the name of the agent.
    pub serial_number: String,
    /// The number of the node in its order.
    pub sequence_id: u32,
    /// Whether it has to be taken off the floor there, too.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub gone: bool,
}

/// The messages for an order; `height` is the number of rows of the map, whose name is
/// the messages' `mapId`. Time stamps count from 1970-01-01T00:00:00Z, the begin of the plan.
pub fn vda5050(order: &Order, name: &str, height: u32, units: Option<Units>) -> Vda5050 {
    let writer = Writer {
        world: World::new(height, units),
        map: if name.is_empty() { "floor" } else { name },
    };
    let after = releases(order);
    let mut orders = Vec::new();
    let mut waiting: Vec<Waiting> = Vec::new();
    // Up to which node each robot is released; it has its first node from the begin.
    let mut base: BTreeMap<&str, usize> = BTreeMap::new();
    for agent in &order.agents {
        let visits = agent.visits.len();
        let waits = (1..visits).filter(|&visit| after.contains_key(&key(agent, visit)));
        let mut ends: Vec<usize> = waits.collect();
        ends.push(visits);
        let released = ends.first().copied().unwrap_or(visits);
        base.insert(&agent.agent, released);
        orders.push(writer.message(agent, (0, 0), (0, released, visits)));
        for (number, pair) in (1..).zip(ends.windows(2)) {
            let [from, to] = *pair else { continue };
            let next = ends.get(number as usize + 1).copied().unwrap_or(to);
            let Some(release) = after.get(&key(agent, from)) else {
                continue;
            };
            let parts = (from.saturating_sub(1), to, next);
            waiting.push(Waiting {
                time: release.time,
                agent: &agent.agent,
                from,
                released: to,
                update: Update {
                    after: release.after.clone(),
                    order: writer.message(agent, (number, release.time), parts),
                },
            });
        }
    }
    sort_by_key(&mut waiting, |it| it.time);
    Vda5050 {
        orders,
        updates: in_turn(waiting, &mut base),
    }
}

/// An update that waits to be sent.
struct Waiting<'a> {
    time: u32,
    agent: &'a str,
    /// Up to which node the update before it releases.
    from: usize,
    /// Up to which node it releases.
    released: usize,
    update: Update,
}

/// The updates in an order in which what each waits for is released before.
fn in_turn<'a>(mut waiting: Vec<Waiting<'a>>, base: &mut BTreeMap<&'a str, usize>) -> Vec<Update> {
    let mut sent = Vec::new();
    loop {
        let mut later = Vec::new();
        let before = waiting.len();
        for it in waiting {
            let is_released = |reached: &Reached| {
                let released = base.get(reached.serial_number.as_str());
                released.is_some_and(|&end| (reached.sequence_id as usize) < 2 * end)
            };
            let is_next = base.get(it.agent) == Some(&it.from);
            if is_next && it.update.after.iter().all(is_released) {
                base.insert(it.agent, it.released);
                sent.push(it.update);
            } else {
                later.push(it);
            }
        }
        if later.is_empty() || later.len() == before {
            // None is left over: the moves of an order do not wait in a circle.
            sent.extend(later.into_iter().map(|it| it.update));
            return sent;
        }
        waiting = later;
    }
}

/// What has to be so before a node is released.
struct Release {
    /// When that is in the order without lateness.
    time: u32,
    after: Vec<Reached>,
}

fn key(agent: &AgentOrder, visit: usize) -> (&str, u32) {
    (agent.agent.as_str(), visit as u32)
}

/// The nodes that wait for others, by agent and visit.
fn releases(order: &Order) -> BTreeMap<(&str, u32), Release> {
    let visits = map(order
        .agents
        .iter()
        .map(|it| (it.agent.as_str(), &it.visits)));
    let reached = |link: &Link| {
        let visit = link.first.visit;
        let count = visits
            .get(link.first.agent.as_str())
            .map_or(0, |it| it.len());
        let gone = visit as usize + 1 >= count;
        let after = Reached {
            serial_number: link.first.agent.clone(),
            sequence_id: 2 * if gone { visit } else { visit + 1 },
            gone,
        };
        let time = visits.get(link.first.agent.as_str()).and_then(|it| {
            let next = it.get(visit as usize + 1)?;
            Some(next.arrives)
        });
        Release {
            time: time.unwrap_or(link.first.time).max(link.second.time),
            after: vec![after],
        }
    };
    let mut releases = BTreeMap::new();
    for link in &order.links {
        let comes = (link.second.agent.as_str(), link.second.visit);
        releases.insert(comes, reached(link));
    }
    // Robots that rotate go once all of them stand ready.
    for rotation in &order.rotations {
        for it in &rotation.moves {
            let release = Release {
                time: rotation.time,
                after: ready(rotation),
            };
            releases.insert((it.agent.as_str(), it.visit), release);
        }
    }
    releases
}

/// Each robot of a rotation has reached the node that it then leaves.
fn ready(rotation: &Rotation) -> Vec<Reached> {
    let moves = rotation.moves.iter();
    let moves = moves.map(|it| Reached {
        serial_number: it.agent.clone(),
        sequence_id: 2 * it.visit.saturating_sub(1),
        gone: false,
    });
    moves.collect()
}

/// Writes messages.
struct Writer<'a> {
    world: World,
    map: &'a str,
}

impl Writer<'_> {
    /// The message with the visits from one on: up to a second one they are released, and up
    /// to a third one they are the horizon.
    fn message(
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

/// A time stamp so many seconds after the begin of 1970.
fn stamp(seconds: f64) -> String {
    #[expect(clippy::cast_sign_loss, reason = "times begin at 0")]
    let millis = (seconds * 1000.0).round() as u64;
    let (day, rest) = (millis / 86_400_000, millis % 86_400_000);
    let (year, month, day) = date(day);
    let (hour, minute) = (rest / 3_600_000, rest / 60_000 % 60);
    let (second, milli) = (rest / 1000 % 60, rest % 1000);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{milli:03}Z")
}

/// Year, month and day of a day from 1970 on (Gregorian calendar).
const fn date(day: u64) -> (u64, u64, u64) {
    let shifted = day + 719_468;
    let (era, of_era) = (shifted / 146_097, shifted % 146_097);
    let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = era * 400 + year_of_era + if month <= 2 { 1 } else { 0 };
    (year, month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_stamps_count_from_the_begin_of_1970() {
        assert_eq!(stamp(0.0), "1970-01-01T00:00:00.000Z");
        assert_eq!(stamp(3661.5), "1970-01-01T01:01:01.500Z");
        assert_eq!(stamp(86_400.0 * 59.0), "1970-03-01T00:00:00.000Z");
        assert_eq!(stamp(951_782_400.0), "2000-02-29T00:00:00.000Z");
        assert_eq!(stamp(1_709_251_199.999), "2024-02-29T23:59:59.999Z");
    }
}
