//! Changes and methods in words.

use giveway_model::Cell;
use giveway_model::change::What;
use giveway_model::words::and;
use giveway_solve::change::Method;

use super::costs::values;
use super::count;
use crate::changing::{Changing, Comparing, Tried};
use crate::timeline::work_done;
use crate::words::at;
use crate::{Adapting, Answer};

/// A change as a sentence without its stop, and what else there is to know.
///
/// ```
/// use giveway_model::change::What;
/// use giveway_page::words::change::sentence;
/// let delay = What::DelayAgent { agent: "A1".into(), steps: 3 };
/// assert_eq!(sentence(&delay).0, "A1 breaks down for 3 steps");
/// ```
pub fn sentence(what: &What) -> (String, Option<String>) {
    let told = match what {
        What::AddAgent { agent } => {
            let goal = at(agent.goal);
            let detail = match agent.waypoints.as_slice() {
                [] => format!("goal {goal}"),
                waypoints => format!("goal {goal}, by way of {}", cells(waypoints)),
            };
            let text = format!("{} joins at {}", agent.name, at(agent.start));
            return (text, Some(detail));
        }
        What::SetSlow { cells } if cells.len() > 1 => {
            let text = format!("{} become slow", count(cells.len(), "cell"));
            return (text, Some(self::cells(cells)));
        }
        What::SetNormal { cells } if cells.len() > 1 => {
            let text = format!("{} are no longer slow", count(cells.len(), "cell"));
            return (text, Some(self::cells(cells)));
        }
        What::SetSlow { cells } => format!("{} becomes slow", self::cells(cells)),
        What::SetNormal { cells } => format!("{} is no longer slow", self::cells(cells)),
        What::RemoveAgent { agent } => format!("{agent} is removed"),
        What::AddObstacle { cell } => format!("New obstacle at {}", at(*cell)),
        What::RemoveObstacle { cell } => format!("Obstacle at {} removed", at(*cell)),
        What::MoveObstacle { from, to } => {
            format!("Obstacle at {} moves to {}", at(*from), at(*to))
        }
        What::AddCharger { cell } => format!("New charger at {}", at(*cell)),
        What::RemoveCharger { cell } => format!("Charger at {} removed", at(*cell)),
        What::SetGoal { agent, cell } => format!("The goal of {agent} is now {}", at(*cell)),
        What::AddWaypoint { agent, cell } => format!("{agent} also has to visit {}", at(*cell)),
        What::DropWaypoint { agent, cell } => {
            format!("{agent} no longer has to visit {}", at(*cell))
        }
        What::SetBattery { agent, level } => format!("The battery of {agent} is at {level}"),
        What::DelayAgent { agent, steps } => {
            format!("{agent} breaks down for {}", count(*steps as usize, "step"))
        }
    };
    (told, None)
}

/// The most cells that are named one by one.
const NAMED: usize = 6;

fn cells(cells: &[Cell]) -> String {
    let named: Vec<String> = cells.iter().take(NAMED).map(|&cell| at(cell)).collect();
    match cells.len().saturating_sub(NAMED) {
        0 => named.join(", "),
        more => format!("{} and {more} more", named.join(", ")),
    }
}

/// A method by itself: `Tunnel 1`.
pub fn method(method: Method) -> String {
    match method {
        Method::Revise => "Revise".to_owned(),
        Method::Tunnel(width) => format!("Tunnel {width}"),
        Method::Replan => "Replan".to_owned(),
    }
}

/// A method within a sentence: `tunnel 1`.
pub fn method_in_words(method: Method) -> String {
    self::method(method).to_ascii_lowercase()
}

/// While changes are listed.
pub(super) fn changing(changing: &Changing) -> String {
    let at = changing.at;
    match changing.list.as_slice() {
        [] => format!(
            "The world changes at time {at}: change it with the tools, then find new plans."
        ),
        list => {
            let listed = count(list.len(), "change");
            format!("The world changes at time {at}: {listed} listed.")
        }
    }
}

/// While ways to go on are looked for.
pub(super) fn adapting(run: &Adapting) -> String {
    let at = run.changing.at;
    match work_done(run.size).as_str() {
        "" => format!("Looking for ways to go on from time {at}."),
        work => format!("Looking for ways to go on from time {at}; {work}."),
    }
}

/// `At time 2: revise has makespan 5; tunnel 1 and replan have makespan 4.`
pub(super) fn compared(comparing: &Comparing) -> String {
    let mut parts: Vec<(Option<u32>, Vec<String>)> = Vec::new();
    for Tried { method, told, .. } in &comparing.tried {
        let makespan = told.result.costs.map(|costs| costs.makespan);
        let name = method_in_words(*method);
        match parts.iter_mut().find(|(other, _)| *other == makespan) {
            Some((_, names)) => names.push(name),
            None => parts.push((makespan, vec![name])),
        }
    }
    let parts = parts.iter().map(|(makespan, names)| {
        let have = if names.len() == 1 { "has" } else { "have" };
        let names = and(names);
        match makespan {
            Some(makespan) => format!("{names} {have} makespan {makespan}"),
            None => format!("{names} {have} no plan"),
        }
    });
    let parts: Vec<String> = parts.collect();
    format!("At time {}: {}.", comparing.changing.at, parts.join("; "))
}

/// Of a plan that went on where the world changed.
pub(super) fn adopted(answer: &Answer) -> String {
    let at = answer.changed_last().unwrap_or(0);
    let objective = &answer.draft.scene().objective;
    let costs = answer.solved.costs.map(|costs| values(objective, &costs));
    let costs = costs.unwrap_or_default();
    let steps = answer.course.as_deref().map(|course| &course.steps);
    let method = steps.and_then(|steps| steps.last()?.method);
    match method {
        Some(method) => {
            let way = method_in_words(method);
            format!("The world changed at time {at}; the plan went on by {way}: {costs}.")
        }
        None => format!("The world changed at time {at}; the plan went on: {costs}."),
    }
}
