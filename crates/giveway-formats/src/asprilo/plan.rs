//! The walks of robots, and what they do on the way.

use std::collections::BTreeMap;

use super::facts::{Doing, Id, Warehouse};
use crate::limits::Steps;
use crate::{
    CellOrder, Conventions, Handling, Move, Origin, Up, Walk, WrittenAgent, WrittenAt, WrittenPlan,
};
use giveway_model::format::text::at_byte;
use giveway_model::words::count;
use giveway_model::{Fault, LeftOutRule, MAX_AGENTS, tr};

/// The numbers as the language of asprilo documents them.
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
    // At the last action of the robot.
    let fault_of = |robot: Id, fault: Fault| {
        let doings = warehouse.doings.get(&robot);
        let last = doings.and_then(BTreeMap::last_key_value);
        at_byte(text, last.map_or(0, |(_, &(_, offset))| offset), fault)
    };
    if robots.is_empty() {
        if usize::try_from(last).is_ok_and(|last| last > MAX_AGENTS) {
            let expected = tr!("at most {most} robots", most = MAX_AGENTS);
            let fault = Fault::at("", tr!("robot {robot}", robot = last), expected);
            return Err(fault_of(last, fault));
        }
        robots = (1..=last).collect();
    }
    for &robot in warehouse.doings.keys() {
        if robots.binary_search(&robot).is_err() {
            let found = tr!("an action of robot {robot}, which is nowhere", robot);
            let fault = Fault::at("", found, tr!("a robot that has a place"));
            return Err(fault_of(robot, fault));
        }
    }
    let mut steps = Steps::default();
    let mut agents = Vec::with_capacity(robots.len());
    for robot in robots {
        let doings = warehouse.doings.get(&robot);
        let moves = doings.map(|doings| walk(doings, &mut steps)).transpose();
        let moves = moves
            .map_err(|fault| fault_of(robot, fault))?
            .unwrap_or_default();
        agents.push(WrittenAgent {
            name: Some(name(robot)),
            handling: doings.map_or_else(Vec::new, handling),
            ..WrittenAgent::walking(Walk::Fixed(moves), WrittenAt::Whole)
        });
    }
    let doings = warehouse.doings.values().flat_map(BTreeMap::values);
    let standing = doings.filter(|(doing, _)| !matches!(doing, Doing::Move(..)));
    let standing = standing.count();
    Ok(WrittenPlan {
        left_out: Vec::from_iter((standing > 0).then_some(LeftOutRule::Handling)),
        notes: notes(warehouse, standing),
        ..WrittenPlan::new(agents, DOCUMENTED)
    })
}

fn walk(doings: &BTreeMap<i32, (Doing, usize)>, steps: &mut Steps) -> Result<Vec<Move>, Fault> {
    let last = doings.last_key_value().map_or(0, |(&time, _)| time);
    let length = usize::try_from(last).unwrap_or_default();
    steps.add(length)?;
    let mut moves = vec![Move::Wait; length];
    for (&time, &(doing, _)) in doings {
        let index = usize::try_from(time - 1).unwrap_or_default();
        if let (Doing::Move(x, y), Some(step)) = (doing, moves.get_mut(index)) {
            *step = Move::of_offset((x.into(), y.into())).unwrap_or(Move::Wait);
        }
    }
    Ok(moves)
}

/// The remarks on a plan with so many actions that are no moves.
fn notes(warehouse: &Warehouse, standing: usize) -> Vec<String> {
    let mut notes = match standing {
        0 => Vec::new(),
        1 => vec!["One action that is no move is shown as a wait and not judged.".to_owned()],
        n => vec![format!(
            "{} that are no moves (pickup, putdown, deliver and the like) are shown as waits and not judged.",
            count(n, "action")
        )],
    };
    // With nodes the scene tells them.
    if warehouse.nodes.is_empty() {
        notes.extend(warehouse.unknown().sentence());
    }
    notes
}

/// The goods that a robot lifts and delivers, and when.
fn handling(doings: &BTreeMap<i32, (Doing, usize)>) -> Vec<(usize, Handling)> {
    let handled = doings.iter().filter_map(|(&time, &(doing, _))| {
        let handling = match doing {
            Doing::PickUp => Handling::PickUp,
            Doing::Deliver(order, product, amount) => Handling::Deliver {
                order,
                product,
                amount,
            },
            Doing::Move(..) | Doing::Other => return None,
        };
        Some((usize::try_from(time).ok()?, handling))
    });
    handled.collect()
}
