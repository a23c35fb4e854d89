//! Facts that can be left out, as clauses.

use giveway_model::{Cell, Instance, tr};

use crate::explain::{Core, FactKind, group::Group};

/// The most clauses of one sentence, and the most obstacles that are told one by one.
const MOST_CLAUSES: usize = 7;
const MOST_OBSTACLES: usize = 2;

/// A fact as a clause: `A1 must visit (2, 1)`.
pub(crate) fn fact(group: Group, instance: &Instance, within: Option<u32>) -> String {
    let agent = |a: usize| instance.agents().get(a);
    let name = |a: usize| agent(a).map_or("", |agent| agent.name.as_str());
    match group {
        Group::Task(a) => agent(a).map_or_else(String::new, |a| {
            tr!(
                "{agent} must go from {start} to {goal}",
                agent = a.name,
                start = a.start,
                goal = a.goal
            )
        }),
        Group::Waypoint(a, cell) => tr!("{name} must visit {cell}", name = name(a), cell),
        Group::Battery(a) => {
            let battery = agent(a).and_then(|agent| agent.battery);
            battery.map_or_else(String::new, |battery| {
                let (initial, capacity) = (battery.initial, battery.capacity);
                tr!(
                    "the battery of {name} holds {capacity} and starts at {initial}",
                    name = name(a),
                    capacity,
                    initial
                )
            })
        }
        Group::Obstacle(cell) => tr!("{cell} is an obstacle", cell),
        Group::Collision(a, b) => tr!("{a} and {b} must not collide", a = name(a), b = name(b)),
        Group::Stay(a) => {
            let goal = agent(a).map(|agent| agent.goal.to_string());
            tr!(
                "{name} stays at its goal {goal}",
                name = name(a),
                goal = goal.unwrap_or_default()
            )
        }
        Group::Floor => {
            let floor = instance.rules().battery_floor;
            tr!("no battery may fall below {floor}", floor)
        }
        Group::Slow => tr!("moves in the slow zone take 2 steps").to_owned(),
        Group::Deadline => {
            let within = within.unwrap_or_default();
            tr!("every robot must arrive by time {within}", within)
        }
        Group::Floor => {
            let floor = instance.rules().battery_floor;
            tr!("no battery may fall below {floor}", floor)
        }
    }
}

/// The facts of a set as one list of clauses, obstacles together.
pub(super) fn joined(core: &Core) -> String {
    let of = |fact: &&crate::explain::Fact| fact.kind == FactKind::Obstacle;
    let obstacles: Vec<Cell> = core
        .facts
        .iter()
        .filter(of)
        .filter_map(|f| f.cell)
        .collect();
    let is_short = obstacles.len() <= MOST_OBSTACLES;
    let mut clauses: Vec<String> = Vec::new();
    let others = core.facts.iter().filter(|fact| is_short || !of(fact));
    clauses.extend(others.map(|fact| fact.text.clone()));
    if !is_short {
        clauses.insert(
            clauses.len().min(MOST_CLAUSES - 1),
            obstacles_together(&obstacles),
        );
    }
    if clauses.len() > MOST_CLAUSES {
        let count = clauses.len() - MOST_CLAUSES;
        clauses.truncate(MOST_CLAUSES);
        clauses.push(tr!("{n} more fact" | "{n} more facts" % count));
    }
    clauses.join("; ")
}

/// Some obstacles, at least two, as one clause.
fn obstacles_together(cells: &[Cell]) -> String {
    let (Some(&first), Some(&last)) = (cells.first(), cells.last()) else {
        return String::new();
    };
    let length = first.x.abs_diff(last.x) + first.y.abs_diff(last.y);
    let is_straight = first.x == last.x || first.y == last.y;
    // Cells in their order: a run has no gaps if it is as long as they are many.
    if is_straight && length as usize + 1 == cells.len() {
        tr!(
            "the cells from {first} to {last} are obstacles",
            first,
            last
        )
    } else {
        let count = cells.len() - 1;
        tr!(
            "{first} and {n} other cell are obstacles"
                | "{first} and {n} other cells are obstacles" % count,
            first
        )
    }
}
