//! Causes as sentences.

use giveway_model::Cell;

use super::{CauseKind, Method};
use crate::solve::clash_sentence;

/// What keeps an agent from what a method asks of it.
pub(super) fn cause(
    method: Method,
    agent: &str,
    kind: CauseKind,
    cell: Option<Cell>,
    agents: &[String],
) -> String {
    let place = cell.map_or("there".to_owned(), |cell| cell.to_string());
    let bounds = match method {
        Method::Revise => "its old path",
        Method::Tunnel(_) => "its tunnel",
        Method::Replan => "any path",
    };
    match (kind, method) {
        (CauseKind::Obstacle, Method::Replan) => {
            format!("{agent} has to go to {place}, where an obstacle is now.")
        }
        (CauseKind::Obstacle, _) => {
            format!("An obstacle at {place} is on the rest of the path of {agent}.")
        }
        (CauseKind::Goal, _) => format!("The goal of {agent} is {place} now, off {bounds}."),
        (CauseKind::Waypoint, _) => {
            format!("{agent} has to visit {place}, which is off {bounds}.")
        }
        (CauseKind::Battery, _) => format!("The battery of {agent} does not last on {bounds}."),
        (CauseKind::NoWay, _) => format!("{agent} cannot do its task within {bounds}, even alone."),
        (CauseKind::Blocked, Method::Replan) => {
            let names: Vec<&str> = agents.iter().map(String::as_str).collect();
            clash_sentence(&names)
        }
        (CauseKind::Blocked, _) if agents.len() < 2 => {
            format!("{agent} cannot arrive on {bounds}, however it waits.")
        }
        (CauseKind::Blocked, Method::Revise) => format!(
            "{} block each other: no waiting lets all of them keep to their old paths.",
            list(agents)
        ),
        (CauseKind::Blocked, Method::Tunnel(_)) => format!(
            "{} block each other: not all of them can keep to their tunnels.",
            list(agents)
        ),
    }
}

/// A list as part of a sentence.
fn list(names: &[String]) -> String {
    match names {
        [] => "The agents".to_owned(),
        [one] => one.clone(),
        [init @ .., last] => format!("{} and {last}", init.join(", ")),
    }
}
