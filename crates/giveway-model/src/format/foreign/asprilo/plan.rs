//! The walks of robots, and what they do on the way.

use std::collections::BTreeMap;

use super::facts::{Doing, Id, Node, Warehouse};
use crate::format::foreign::limits::Steps;
use crate::format::foreign::{
    CellOrder, Claimed, Conventions, Move, Origin, Up, Walk, WrittenAgent, WrittenAt, WrittenPlan,
};
use crate::format::text::position;
use crate::words::count;
use crate::{Fault, MAX_AGENTS, tr};

/// What the language of asprilo says of its numbers.
const DOCUMENTED: Conventions = Conventions {
    cells: CellOrder::ColumnRow,
    origin: Origin::One,
    up: Up::Lowers,
};

/// The name of a robot.
pub(super) fn name(robot: Id) -> String {
    format!("A{robot}")
}

/// The plan of a file, for its robots in ascending order. Where the file has none
/// of them, they are the robots from 1 to the last that does something.
pub(super) fn plan(text: &str, warehouse: &Warehouse) -> Result<WrittenPlan, Fault> {
    let mut robots: Vec<Id> = warehouse.robots.keys().copied().collect();
    let last = warehouse.doings.last_key_value().map_or(0, |(&id, _)| id);
    if robots.is_empty() {
        if usize::try_from(last).is_ok_and(|last| last > MAX_AGENTS) {
            let found = tr!("robot {robot}", robot = last);
            return Err(fault(
                text,
                warehouse,
                last,
                found,
                tr!("at most {most} robots", most = MAX_AGENTS),
            ));
        }
        robots = (1..=last).collect();
    }
    for &robot in warehouse.doings.keys() {
        if robots.binary_search(&robot).is_err() {
            let found = tr!("an action of robot {robot}, which is nowhere", robot);
            return Err(fault(
                text,
                warehouse,
                robot,
                found,
                tr!("a robot that has a place"),
            ));
        }
    }
    let mut steps = Steps::default();
    let mut agents = Vec::with_capacity(robots.len());
    for robot in robots {
        let moves = match warehouse.doings.get(&robot) {
            Some(doings) => walk(doings, &mut steps)
                .map_err(|error| fault(text, warehouse, robot, error.found, error.expected))?,
            None => Vec::new(),
        };
        agents.push(WrittenAgent {
            name: Some(name(robot)),
            ..WrittenAgent::walking(Walk::Fixed(moves), WrittenAt::Whole)
        });
    }
    Ok(WrittenPlan {
        map: None,
        agents,
        claimed: Claimed::default(),
        documented: DOCUMENTED,
        notes: notes(warehouse),
    })
}

fn fault(
    text: &str,
    warehouse: &Warehouse,
    robot: Id,
    found: String,
    expected: impl Into<String>,
) -> Fault {
    let doings = warehouse.doings.get(&robot);
    let last = doings.and_then(BTreeMap::last_key_value);
    let offset = last.map_or(0, |(_, &(_, offset))| offset);
    let (line, column) = position(text, offset);
    Fault::at("", found, expected).in_text(line, column)
}

fn walk(doings: &BTreeMap<i32, (Doing, usize)>, steps: &mut Steps) -> Result<Vec<Move>, Fault> {
    let last = doings.last_key_value().map_or(0, |(&time, _)| time);
    let length = usize::try_from(last).unwrap_or_default();
    steps.add(length)?;
    let mut moves = vec![Move::Wait; length];
    for (&time, &(doing, _)) in doings {
        let index = usize::try_from(time - 1).unwrap_or_default();
        if let (Doing::Move(x, y), Some(step)) = (doing, moves.get_mut(index)) {
            *step = match (x, y) {
                (-1, _) => Move::Left,
                (1, _) => Move::Right,
                (_, -1) => Move::Up,
                _ => Move::Down,
            };
        }
    }
    Ok(moves)
}

fn notes(warehouse: &Warehouse) -> Vec<String> {
    let doings = warehouse.doings.values().flat_map(BTreeMap::values);
    let standing = doings.filter(|(doing, _)| !matches!(doing, Doing::Move(..)));
    match standing.count() {
        0 => Vec::new(),
        1 => vec!["One action that is no move is shown as a wait.".to_owned()],
        n => vec![format!(
            "{} that are no moves (pickup, putdown, deliver and the like) are shown as waits.",
            count(n, "action")
        )],
    }
}

/// Where a robot is after the step at each time at which it does something; a robot
/// that leaves the map at the left or top stays at its border.
pub(super) fn places(start: Node, doings: &BTreeMap<i32, (Doing, usize)>) -> Vec<(Node, Doing)> {
    let (mut x, mut y) = start;
    let at_times = doings.values().map(|&(doing, _)| {
        if let Doing::Move(dx, dy) = doing {
            x = x.saturating_add_signed(dx).max(1);
            y = y.saturating_add_signed(dy).max(1);
        }
        ((x, y), doing)
    });
    at_times.collect()
}
