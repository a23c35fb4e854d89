//! Why a change contradicts the world: what was found, what was expected.

use super::apply::Reason;
use super::{MAX_CHANGES, MAX_DELAY, MAX_TIME};
use crate::{Cell, Grid, MAX_AGENTS, MAX_CAPACITY};

fn reason(found: impl Into<String>, expected: impl Into<String>) -> Reason {
    (found.into(), expected.into())
}

pub(super) fn too_late(at: u32) -> Reason {
    reason(format!("the time {at}"), format!("at most {MAX_TIME}"))
}

pub(super) fn too_long(steps: u32) -> Reason {
    reason(
        format!("a delay of {steps} steps"),
        format!("at most {MAX_DELAY}"),
    )
}

pub(super) fn too_many_changes(count: usize) -> Reason {
    reason(format!("{count} changes"), format!("at most {MAX_CHANGES}"))
}

pub(super) fn unknown(name: &str) -> Reason {
    reason(
        format!("the unknown robot \"{name}\""),
        "a robot that is there",
    )
}

pub(super) fn removed(name: &str) -> Reason {
    reason(
        format!("{name}, which was removed"),
        "a robot that is there",
    )
}

pub(super) fn vanished(name: &str, at: u32) -> Reason {
    reason(
        format!("{name}, which has vanished by time {at}"),
        "a robot that is there",
    )
}

pub(super) fn just_added(name: &str) -> Reason {
    reason(
        format!("{name}, which joins at the same time"),
        "a robot that was there before",
    )
}

pub(super) fn off_map(cell: Cell, grid: &Grid) -> Reason {
    reason(
        format!("{cell}"),
        format!("a cell of the {} x {} map", grid.width(), grid.height()),
    )
}

pub(super) fn no_name() -> Reason {
    reason("a robot with an empty name", "a name")
}

pub(super) fn used_name(name: &str) -> Reason {
    reason(
        format!("the name \"{name}\" of another robot, now or earlier"),
        "a name of its own",
    )
}

pub(super) fn too_many() -> Reason {
    reason("one more robot", format!("at most {MAX_AGENTS}"))
}

pub(super) fn twice(cell: Cell) -> Reason {
    reason(format!("the waypoint {cell} again"), "each waypoint once")
}

pub(super) fn capacity(capacity: u32, initial: u32) -> Reason {
    reason(
        format!("a battery of {initial} of {capacity}"),
        format!("a level up to the capacity, which is at most {MAX_CAPACITY}"),
    )
}

pub(super) fn blocked(cell: Cell) -> Reason {
    reason(format!("the obstacle {cell}"), "a cell without one")
}

pub(super) fn no_obstacle(cell: Cell) -> Reason {
    reason(format!("{cell}, which is not an obstacle"), "an obstacle")
}

pub(super) fn in_obstacle(cell: Cell) -> Reason {
    reason(format!("the obstacle {cell}"), "a free cell")
}

pub(super) fn charger(cell: Cell, is_there: bool) -> Reason {
    if is_there {
        reason(format!("the charger {cell}"), "a cell without one")
    } else {
        reason(format!("{cell}, which is not a charger"), "a charger")
    }
}

pub(super) fn waypoint_again(name: &str, cell: Cell) -> Reason {
    reason(
        format!("{cell}, which {name} already has to visit"),
        "another cell",
    )
}

pub(super) fn no_waypoint(name: &str, cell: Cell) -> Reason {
    reason(
        format!("{cell}, which is not a waypoint of {name}"),
        "one of its waypoints",
    )
}

pub(super) fn unlimited(name: &str) -> Reason {
    reason(
        format!("a level for {name}, which has no battery"),
        "a robot with one",
    )
}

pub(super) fn level(name: &str, level: u32, capacity: u32) -> Reason {
    reason(
        format!("the level {level} for {name}"),
        format!("at most the capacity, {capacity}"),
    )
}

pub(super) fn occupied(name: &str, cell: Cell, other: &str, at: u32) -> Reason {
    reason(
        format!("{name} at {cell}, where {other} is at time {at}"),
        "a cell that is free then",
    )
}

pub(super) fn obstacle_on(cell: Cell, other: &str, at: u32) -> Reason {
    reason(
        format!("an obstacle at {cell}, where {other} is at time {at}"),
        "a cell that is free then",
    )
}

pub(super) fn shared_goal(cell: Cell, a: &str, b: &str) -> Reason {
    reason(
        format!("{cell} as the goal of both {a} and {b}"),
        "different goals, since robots stay at their goals",
    )
}
