//! The acts of an agent in a plan, as parts of sentences.

use crate::check::{Step, Walk, steps};
use crate::condition::{first_visit, turns};
use crate::{Cell, Instance, tr};

/// Things that a sentence lists before it says how many there are more.
const LISTED: usize = 4;

/// Some things as a list: `a, b and c`.
pub(super) fn list(things: &[String]) -> String {
    match things {
        [] => String::new(),
        [one] => one.clone(),
        [init @ .., last] if things.len() <= LISTED => {
            tr!("list" => "{list} and {last}", list = init.join(", "), last)
        }
        _ => {
            let shown = things.get(..LISTED - 1).unwrap_or(things);
            tr!(
                "{list} and {more} more",
                list = shown.join(", "),
                more = things.len() - shown.len()
            )
        }
    }
}

/// Whole stays of an agent at a cell before its arrival: cell, first time at
/// it, last time at it.
pub(super) fn waits(instance: &Instance, walk: &Walk<'_>) -> Vec<(Cell, u32, u32)> {
    let mut waits: Vec<(Cell, u32, u32)> = Vec::new();
    for (time, step) in steps(instance.grid(), walk.path) {
        let (time, Some(cell)) = (time as u32, walk.at(time)) else {
            continue;
        };
        if step != Step::Wait {
            continue;
        }
        match waits.last_mut() {
            Some((at, _, until)) if *at == cell && *until == time => *until = time + 1,
            _ => waits.push((cell, time, time + 1)),
        }
    }
    waits
}

/// Where and when it waits, as a sentence.
pub(super) fn waiting(instance: &Instance, walk: &Walk<'_>) -> String {
    let waits: Vec<String> = waits(instance, walk)
        .into_iter()
        .map(|(cell, from, to)| tr!("at {cell} from time {from} to {to}", cell, from, to))
        .collect();
    if waits.is_empty() {
        return tr!("It never waits before its arrival.").to_owned();
    }
    tr!("It waits {times}.", times = list(&waits))
}

/// Where and when it charges, as a sentence.
pub(super) fn charging(walk: &Walk<'_>) -> String {
    let charges: Vec<String> = walk
        .charges
        .iter()
        .filter_map(|&time| {
            Some(tr!(
                "at {cell} at time {time}",
                cell = walk.at(time as usize)?,
                time
            ))
        })
        .collect();
    if walk.agent.battery.is_none() {
        return tr!("It has no battery.").to_owned();
    }
    if charges.is_empty() {
        return tr!("It never charges.").to_owned();
    }
    tr!("It charges {times}.", times = list(&charges))
}

/// Where it is at a time, as a sentence.
pub(super) fn whereabouts(instance: &Instance, walk: &Walk<'_>, time: u32) -> String {
    let arrival = walk.arrival();
    match walk.at(time as usize) {
        Some(cell) => tr!("At time {time} it is at {cell}.", time, cell),
        None if time as usize <= arrival => tr!("At time {time} it is in transit.", time),
        None if instance.keeps(walk.agent) => {
            tr!(
                "It has arrived at {goal} at time {arrival}.",
                goal = walk.end().unwrap_or(walk.agent.start),
                arrival
            )
        }
        None => tr!(
            "It arrived at time {arrival} and has been gone since then.",
            arrival
        ),
    }
}

/// When it goes over an edge, or where else it goes from there, as a sentence.
pub(super) fn going(instance: &Instance, walk: &Walk<'_>, from: Cell, to: Cell) -> String {
    let name = |(time, _, to): &(u32, Cell, Cell)| tr!("to {to} at time {time}", to, time);
    let leaves: Vec<_> = turns(instance, walk)
        .into_iter()
        .filter(|&(_, u, _)| u == from)
        .collect();
    let there: Vec<String> = leaves
        .iter()
        .filter(|&&(_, _, v)| v == to)
        .map(name)
        .collect();
    if !there.is_empty() {
        return tr!("It goes from {from} {ways}.", from, ways = list(&there));
    }
    if !leaves.is_empty() {
        let leaves: Vec<String> = leaves.iter().map(name).collect();
        return tr!("It goes from {from} {ways}.", from, ways = list(&leaves));
    }
    match first_visit(walk, from) {
        Some(_) if walk.agent.goal.is_none() => tr!("It stays at {from} to the end.", from),
        Some(_) => tr!("It stays at {from}, its goal, to the end.", from),
        None => tr!("It is never at {from}.", from),
    }
}

/// Its slow moves, as a sentence; nothing where it makes none.
pub(super) fn slowly(instance: &Instance, walk: &Walk<'_>) -> Option<String> {
    let moves: Vec<String> = steps(instance.grid(), walk.path)
        .filter_map(|(time, step)| match step {
            Step::SlowMove { from, to } => {
                Some(tr!("from {from} to {to} at time {time}", from, to, time))
            }
            _ => None,
        })
        .collect();
    (!moves.is_empty()).then(|| tr!("It moves slowly {ways}.", ways = list(&moves)))
}
