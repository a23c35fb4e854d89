//! What changed while the plan ran, in a link: the time, a letter for the kind,
//! and what that needs, joined by points.

mod steps;

use giveway_model::change::{Change, Changes, What};
use giveway_model::format::link::message;
use giveway_model::{Agent, Cell, Plan, Version};

use super::scene::{read_agent, write_agent};
use super::text::{escape, numbers, unescape};
use crate::MAX_AGENTS;

pub(super) use steps::{read_steps, write_steps};

/// The latest time of a change, the most times, and the most changes.
pub(super) const LATEST: u32 = 100_000;
pub(super) const TIMES: usize = 200;
const CHANGES: usize = 20_000;
/// The most steps that all agents together are not there yet.
const LATE: u32 = 1_000_000;

/// A list of changes.
pub(super) fn write(changes: &[Change]) -> String {
    let one = |change: &Change| {
        let (letter, rest) = kind(&change.what);
        format!("{}{letter}{rest}", change.at)
    };
    changes.iter().map(one).collect::<Vec<_>>().join(";")
}

fn kind(what: &What) -> (char, String) {
    let at = |cell: &Cell| format!("{}.{}", cell.x, cell.y);
    let all = |cells: &[Cell]| cells.iter().map(at).collect::<Vec<_>>().join(".");
    let of = |agent: &str, cell: &Cell| format!("{}.{}", escape(agent), at(cell));
    match what {
        What::AddAgent { agent } => ('a', write_agent(agent)),
        What::RemoveAgent { agent } => ('r', escape(agent)),
        What::AddObstacle { cell } => ('o', at(cell)),
        What::RemoveObstacle { cell } => ('f', at(cell)),
        What::MoveObstacle { from, to } => ('m', all(&[*from, *to])),
        What::SetSlow { cells } => ('s', all(cells)),
        What::SetNormal { cells } => ('n', all(cells)),
        What::AddCharger { cell } => ('c', at(cell)),
        What::RemoveCharger { cell } => ('k', at(cell)),
        What::SetGoal { agent, cell } => ('g', of(agent, cell)),
        What::AddWaypoint { agent, cell } => ('w', of(agent, cell)),
        What::DropWaypoint { agent, cell } => ('d', of(agent, cell)),
        What::SetBattery { agent, level } => ('b', format!("{}.{level}", escape(agent))),
        What::DelayAgent { agent, steps } => ('p', format!("{}.{steps}", escape(agent))),
        What::StopAgent { agent } => ('h', escape(agent)),
        What::AddConstraint { constraint } => ('l', escape(&message::write(constraint))),
        What::RemoveConstraint { constraint } => ('u', escape(&message::write(constraint))),
    }
}

/// The changes that a text tells; `None` where it is none, or tells more than a
/// page takes. They may contradict the world.
pub(super) fn read(text: &str, agents: usize) -> Option<Changes> {
    let mut changes = Vec::new();
    for part in text.split(';').filter(|part| !part.is_empty()) {
        changes.push(read_one(part)?);
        if changes.len() > CHANGES {
            return None;
        }
    }
    let joins = changes.iter().filter(|change| joins(change).is_some());
    let late = joins.clone().map(|change| change.at);
    let late = late.fold(0, u32::saturating_add);
    if agents + joins.count() > MAX_AGENTS || late > LATE {
        return None;
    }
    let changes = Changes {
        giveway: Version,
        changes,
    };
    (changes.by_time().len() <= TIMES).then_some(changes)
}

fn joins(change: &Change) -> Option<&Agent> {
    match &change.what {
        What::AddAgent { agent } => Some(agent),
        _ => None,
    }
}

fn read_one(text: &str) -> Option<Change> {
    let digits = text.find(|c: char| !c.is_ascii_digit())?;
    let (at, rest) = text.split_at(digits);
    let at = at.parse().ok().filter(|&at: &u32| at <= LATEST)?;
    let mut letters = rest.chars();
    let (letter, rest) = (letters.next()?, letters.as_str());
    let cells = || -> Option<Vec<Cell>> {
        let numbers = numbers(rest)?;
        let (pairs, []) = numbers.as_chunks::<2>() else {
            return None;
        };
        Some(pairs.iter().map(|&[x, y]| Cell::new(x, y)).collect())
    };
    let cell = || match cells()?[..] {
        [cell] => Some(cell),
        _ => None,
    };
    let name = || rest.split_once('.').and_then(|(name, _)| unescape(name));
    let after = || numbers(rest.split_once('.')?.1);
    let its_cell = || match after()?[..] {
        [x, y] => Some(Cell::new(x, y)),
        _ => None,
    };
    let count = || match after()?[..] {
        [count] => Some(count),
        _ => None,
    };
    let what = match letter {
        'a' => What::AddAgent {
            agent: read_agent(rest)?,
        },
        'r' => What::RemoveAgent {
            agent: unescape(rest)?,
        },
        'o' => What::AddObstacle { cell: cell()? },
        'f' => What::RemoveObstacle { cell: cell()? },
        'm' => match cells()?[..] {
            [from, to] => What::MoveObstacle { from, to },
            _ => return None,
        },
        's' => What::SetSlow { cells: cells()? },
        'n' => What::SetNormal { cells: cells()? },
        'c' => What::AddCharger { cell: cell()? },
        'k' => What::RemoveCharger { cell: cell()? },
        'g' => What::SetGoal {
            agent: name()?,
            cell: its_cell()?,
        },
        'w' => What::AddWaypoint {
            agent: name()?,
            cell: its_cell()?,
        },
        'd' => What::DropWaypoint {
            agent: name()?,
            cell: its_cell()?,
        },
        'b' => What::SetBattery {
            agent: name()?,
            level: count()?,
        },
        'p' => What::DelayAgent {
            agent: name()?,
            steps: count()?,
        },
        'h' => What::StopAgent {
            agent: unescape(rest)?,
        },
        'l' => What::AddConstraint {
            constraint: message::read(&unescape(rest)?)?,
        },
        'u' => What::RemoveConstraint {
            constraint: message::read(&unescape(rest)?)?,
        },
        _ => return None,
    };
    Some(Change { at, what })
}

/// Those who joined, in the order in which they came.
pub(super) fn joined(changes: &Changes) -> Vec<Agent> {
    let times = changes.by_time();
    let all = times.iter().flat_map(|(_, list)| list);
    all.filter_map(|(_, change)| joins(change))
        .cloned()
        .collect()
}

/// The times at which agents join and are removed, put into their plan.
pub(super) fn put_times(plan: &mut Plan, changes: &Changes) {
    for change in &changes.changes {
        match &change.what {
            What::AddAgent { agent } if change.at > 0 => {
                plan.from.insert(agent.name.clone(), change.at);
            }
            What::RemoveAgent { agent } => {
                plan.until.insert(agent.clone(), change.at);
            }
            _ => {}
        }
    }
}
