//! Nodes that are released to a robot only once others have reached theirs.

use std::collections::BTreeMap;

use giveway_model::sorting::map;

use super::Reached;
use crate::{AgentOrder, Link, Order, Rotation};

/// What has to be so before a node is released.
pub(super) struct Release {
    /// When that is in the order without lateness.
    pub(super) time: u32,
    pub(super) after: Vec<Reached>,
}

pub(super) fn key(agent: &AgentOrder, visit: usize) -> (&str, u32) {
    (agent.agent.as_str(), visit as u32)
}

/// The nodes that wait for others, by agent and visit.
pub(super) fn releases(order: &Order) -> BTreeMap<(&str, u32), Release> {
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
