//! Orders of VDA 5050, released in the order of the graph.
//!
//! A fleet's control releases a node to a robot once the robot before it has reached its next
//! node: by then the cell is free. So robots do not follow each other in one step, and lose a
//! step at each link without slack.

mod messages;
mod releases;
mod stamp;

use std::collections::BTreeMap;

use giveway_model::Units;
use giveway_model::sorting::sort_by_key;
use serde::Serialize;
use serde_json::Value;

use crate::Order;
use crate::waypoints::World;
use messages::Writer;
use releases::{key, releases};

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
