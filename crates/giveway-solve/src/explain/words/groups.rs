//! Groups of facts, as phrases.

use giveway_model::words::and;
use giveway_model::{Cell, tr};

use crate::explain::{Fact, FactGroupKind, FactKind};

use super::joined::{in_blocks, together};

/// A group of facts as a phrase: one fact as it is, several in short.
pub(crate) fn fact_group(
    kind: FactGroupKind,
    facts: &[&Fact],
    agents: &[String],
    aisle: &[Cell],
) -> String {
    if let [fact] = facts {
        return fact.text.clone();
    }
    let obstacles = || {
        let cells: Vec<Cell> = facts.iter().filter_map(|fact| fact.cell).collect();
        in_blocks(&cells)
    };
    match (kind, aisle) {
        (FactGroupKind::Agent, _) => match agents {
            [agent] => tr!("{agent} with {parts}", agent, parts = and(&parts(facts))),
            _ => together(facts),
        },
        (FactGroupKind::Agents, _) => tr!("what {robots} must do", robots = and(agents)),
        (FactGroupKind::Collisions, _) if facts.len() * 2 < agents.len() * (agents.len() - 1) => {
            together(facts)
        }
        (FactGroupKind::Collisions, _) => {
            tr!(
                "{robots} must not collide with each other",
                robots = and(agents)
            )
        }
        (FactGroupKind::Aisle, [first, .., last]) => {
            tr!("the aisle from {first} to {last}", first, last)
        }
        (FactGroupKind::Aisle | FactGroupKind::Shelf, _) => {
            tr!("the shelf at {cells}", cells = obstacles())
        }
        (FactGroupKind::Shelves, _) => tr!("the shelves at {cells}", cells = obstacles()),
        (FactGroupKind::Rule | FactGroupKind::Rules, _) => {
            let texts: Vec<String> = facts.iter().map(|fact| fact.text.clone()).collect();
            and(&texts)
        }
    }
}

/// What the facts about one robot are: `its task`, `its waypoint (2, 1)`, `its battery`.
fn parts(facts: &[&Fact]) -> Vec<String> {
    let mut parts = Vec::new();
    let of = |kind| facts.iter().filter(move |fact| fact.kind == kind);
    let has = |kind| of(kind).next().is_some();
    if has(FactKind::Task) || has(FactKind::Presence) {
        parts.push(tr!("its task").to_owned());
    }
    let waypoints: Vec<String> = of(FactKind::Waypoint)
        .filter_map(|fact| Some(fact.cell?.to_string()))
        .collect();
    match waypoints.as_slice() {
        [] => {}
        [cell] => parts.push(tr!("its waypoint {cell}", cell)),
        _ => parts.push(tr!("its waypoints {cells}", cells = and(&waypoints))),
    }
    if has(FactKind::Battery) {
        parts.push(tr!("its battery").to_owned());
    }
    if has(FactKind::Stay) {
        parts.push(tr!("its place at its goal").to_owned());
    }
    if has(FactKind::Rest) {
        parts.push(tr!("the place where it rests").to_owned());
    }
    if has(FactKind::Breakdown) {
        parts.push(tr!("its breakdown").to_owned());
    }
    parts
}
