//! Why a change contradicts the world: what was found, what was expected.

use super::apply::{Reason, Taken};
use super::{ConstraintRef, MAX_CHANGES, MAX_DELAY, MAX_TIME};
use crate::constraint::MAX_CONSTRAINTS;
use crate::{Cell, Grid, MAX_AGENTS, MAX_CAPACITY, tr, tr_later};

fn reason(found: impl Into<String>, expected: impl Into<String>) -> Reason {
    (found.into(), expected.into())
}

pub(super) fn too_late(at: u32) -> Reason {
    reason(
        tr!("the time {time}", time = at),
        tr!("at most {most}", most = MAX_TIME),
    )
}

pub(super) fn too_long(steps: u32) -> Reason {
    reason(
        tr!("a delay of {steps} steps", steps),
        tr!("at most {most}", most = MAX_DELAY),
    )
}

pub(super) fn too_many_changes(count: usize) -> Reason {
    reason(
        tr!("{count} changes", count),
        tr!("at most {most}", most = MAX_CHANGES),
    )
}

pub(super) fn unknown(name: &str) -> Reason {
    reason(
        tr!("the unknown robot \"{name}\"", name),
        tr_later!("a robot that is there"),
    )
}

pub(super) fn removed(name: &str) -> Reason {
    reason(
        tr!("{name}, which was removed", name),
        tr_later!("a robot that is there"),
    )
}

pub(super) fn stopped(name: &str) -> Reason {
    reason(
        tr!("{name}, which has broken down for good", name),
        tr_later!("a robot that still runs; only remove-agent takes this one away"),
    )
}

pub(super) fn stands_at(cell: Cell, name: &str) -> Reason {
    reason(
        tr!(
            "the obstacle at {cell}, which is {name}, broken down for good",
            cell,
            name
        ),
        tr_later!("remove-agent with its name, which takes it away"),
    )
}

pub(super) fn vanished(name: &str, at: u32) -> Reason {
    reason(
        tr!("{name}, which has vanished by time {at}", name, at),
        tr_later!("a robot that is there"),
    )
}

pub(super) fn just_added(name: &str) -> Reason {
    reason(
        tr!("{name}, which joins at the same time", name),
        tr_later!("a robot that was there before"),
    )
}

pub(super) fn off_map(cell: Cell, grid: &Grid) -> Reason {
    reason(
        format!("{cell}"),
        tr!(
            "a cell of the {width} x {height} map",
            width = grid.width(),
            height = grid.height()
        ),
    )
}

pub(super) fn no_name() -> Reason {
    reason(tr_later!("a robot with an empty name"), tr_later!("a name"))
}

pub(super) fn used_name(name: &str) -> Reason {
    reason(
        tr!("the name \"{name}\" of another robot, now or earlier", name),
        tr_later!("a name of its own"),
    )
}

pub(super) fn too_many() -> Reason {
    reason(
        tr_later!("one more robot"),
        tr!("at most {most}", most = MAX_AGENTS),
    )
}

pub(super) fn twice(cell: Cell) -> Reason {
    reason(
        tr!("the waypoint {cell} again", cell),
        tr_later!("each waypoint once"),
    )
}

pub(super) fn capacity(capacity: u32, initial: u32) -> Reason {
    reason(
        tr!("a battery of {initial} of {capacity}", initial, capacity),
        tr!(
            "a level up to the capacity, which is at most {most}",
            most = MAX_CAPACITY
        ),
    )
}

pub(super) fn blocked(cell: Cell) -> Reason {
    reason(
        tr!("the obstacle {cell}", cell),
        tr_later!("a cell without one"),
    )
}

pub(super) fn no_obstacle(cell: Cell) -> Reason {
    reason(
        tr!("{cell}, which is not an obstacle", cell),
        tr_later!("an obstacle"),
    )
}

pub(super) fn in_obstacle(cell: Cell) -> Reason {
    reason(tr!("the obstacle {cell}", cell), tr_later!("a free cell"))
}

pub(super) fn charger(cell: Cell, is_there: bool) -> Reason {
    if is_there {
        reason(
            tr!("the charger {cell}", cell),
            tr_later!("a cell without one"),
        )
    } else {
        reason(
            tr!("{cell}, which is not a charger", cell),
            tr_later!("a charger"),
        )
    }
}

pub(super) fn waypoint_again(name: &str, cell: Cell) -> Reason {
    reason(
        tr!("{cell}, which {name} already has to visit", cell, name),
        tr_later!("another cell"),
    )
}

pub(super) fn no_waypoint(name: &str, cell: Cell) -> Reason {
    reason(
        tr!("{cell}, which is not a waypoint of {name}", cell, name),
        tr_later!("one of its waypoints"),
    )
}

pub(super) fn unlimited(name: &str) -> Reason {
    reason(
        tr!("a level for {name}, which has no battery", name),
        tr_later!("a robot with one"),
    )
}

pub(super) fn level(name: &str, level: u32, capacity: u32) -> Reason {
    reason(
        tr!("the level {level} for {name}", level, name),
        tr!("at most the capacity, {capacity}", capacity),
    )
}

pub(super) fn occupied(name: &str, cell: Cell, other: Taken<'_>, at: u32) -> Reason {
    let (place, other) = (cell, other_at(other, at));
    reason(
        tr!("{name} at {place}, {other}", name, place, other),
        tr_later!("a cell that is free then"),
    )
}

pub(super) fn obstacle_on(cell: Cell, other: Taken<'_>, at: u32) -> Reason {
    let (place, other) = (cell, other_at(other, at));
    reason(
        tr!("an obstacle at {place}, {other}", place, other),
        tr_later!("a cell that is free then"),
    )
}

/// The agent at a cell, or on its way into it.
fn other_at(other: Taken<'_>, at: u32) -> String {
    let name = other.name;
    if other.is_entering {
        tr!("a cell" => "which {name} is entering at time {at}", name, at)
    } else {
        tr!("a cell" => "where {name} is at time {at}", name, at)
    }
}

pub(super) fn shared_goal(cell: Cell, a: &str, b: &str) -> Reason {
    reason(
        tr!("{cell} as the goal of both {a} and {b}", cell, a, b),
        tr_later!("different goals, since robots stay at their goals"),
    )
}

pub(super) fn too_many_constraints() -> Reason {
    reason(
        tr_later!("one more rule"),
        tr!("at most {most}", most = MAX_CONSTRAINTS),
    )
}

pub(super) fn unknown_constraint(which: &ConstraintRef) -> Reason {
    let found = match which {
        ConstraintRef::Name(name) => tr!("the unknown rule '{name}'", name),
        ConstraintRef::Index(index) => tr!("the unknown rule number {n}", n = index),
    };
    reason(found, tr_later!("a rule that is there"))
}

pub(super) fn constraint_name(name: &str) -> Reason {
    let found = if name.is_empty() {
        tr!("an empty name").to_owned()
    } else {
        tr!("the name '{name}' of another rule", name)
    };
    reason(found, tr_later!("a name of its own"))
}
