//! Changes and methods in words.

use giveway_model::change::{ConstraintRef, What};
use giveway_model::words::and;
use giveway_model::{Cell, tr};
use giveway_solve::change::Method;

use super::costs::values;
use crate::changing::{Changing, Comparing, Tried, texts};
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
            let goal = agent.goal.map(at);
            let detail = match (goal, agent.waypoints.as_slice()) {
                (None, []) => tr!("rests anywhere").to_owned(),
                (None, waypoints) => tr!(
                    "rests anywhere, by way of {cells}",
                    cells = cells(waypoints)
                ),
                (Some(goal), []) => tr!("goal {goal}", goal),
                (Some(goal), waypoints) => tr!(
                    "goal {goal}, by way of {cells}",
                    goal,
                    cells = cells(waypoints)
                ),
            };
            let text = tr!(
                "{agent} joins at {cell}",
                agent = agent.name,
                cell = at(agent.start)
            );
            return (text, Some(detail));
        }
        What::SetSlow { cells } if cells.len() > 1 => {
            let text = tr!("{n} cell becomes slow" | "{n} cells become slow" % cells.len());
            return (text, Some(self::cells(cells)));
        }
        What::SetNormal { cells } if cells.len() > 1 => {
            let text =
                tr!("{n} cell is no longer slow" | "{n} cells are no longer slow" % cells.len());
            return (text, Some(self::cells(cells)));
        }
        What::SetSlow { cells } => tr!("{cell} becomes slow", cell = self::cells(cells)),
        What::SetNormal { cells } => tr!("{cell} is no longer slow", cell = self::cells(cells)),
        What::RemoveAgent { agent } => tr!("{agent} is removed", agent),
        What::AddObstacle { cell } => tr!("New obstacle at {cell}", cell = at(*cell)),
        What::RemoveObstacle { cell } => tr!("Obstacle at {cell} removed", cell = at(*cell)),
        What::MoveObstacle { from, to } => {
            tr!(
                "Obstacle at {from} moves to {to}",
                from = at(*from),
                to = at(*to)
            )
        }
        What::AddCharger { cell } => tr!("New charger at {cell}", cell = at(*cell)),
        What::RemoveCharger { cell } => tr!("Charger at {cell} removed", cell = at(*cell)),
        What::SetGoal { agent, cell } => {
            tr!("The goal of {agent} is now {cell}", agent, cell = at(*cell))
        }
        What::AddWaypoint { agent, cell } => {
            tr!("{agent} also has to visit {cell}", agent, cell = at(*cell))
        }
        What::DropWaypoint { agent, cell } => {
            tr!(
                "{agent} no longer has to visit {cell}",
                agent,
                cell = at(*cell)
            )
        }
        What::SetBattery { agent, level } => {
            tr!("The battery of {agent} is at {level}", agent, level)
        }
        What::DelayAgent { agent, steps } => {
            tr!(
                "{agent} breaks down for {n} step" | "{agent} breaks down for {n} steps" % *steps,
                agent
            )
        }
        What::AddConstraint { constraint } => {
            let sentence = constraint.sentence();
            return match &constraint.name {
                Some(name) => (tr!("New rule '{name}'", name), Some(sentence)),
                None => (tr!("New rule: {sentence}", sentence), None),
            };
        }
        What::RemoveConstraint { constraint } => match constraint {
            ConstraintRef::Name(name) => tr!("Rule '{name}' removed", name),
            ConstraintRef::Index(index) => tr!("Rule number {n} removed", n = index),
        },
    };
    (told, None)
}

/// The most cells that are named one by one.
const NAMED: usize = 6;

fn cells(cells: &[Cell]) -> String {
    let named: Vec<String> = cells.iter().take(NAMED).map(|&cell| at(cell)).collect();
    match cells.len().saturating_sub(NAMED) {
        0 => named.join(", "),
        more => tr!("{cells} and {more} more", cells = named.join(", "), more),
    }
}

/// A method by itself: `Tunnel 1`.
pub fn method(method: Method) -> String {
    match method {
        Method::Revise => tr!("Revise").to_owned(),
        Method::Tunnel(width) => tr!("Tunnel {width}", width),
        Method::Replan => tr!("Replan").to_owned(),
    }
}

/// A method within a sentence: `tunnel 1`.
pub fn method_in_words(method: Method) -> String {
    match method {
        Method::Revise => tr!("a method, in a sentence" => "revise").to_owned(),
        Method::Tunnel(width) => tr!("a method, in a sentence" => "tunnel {width}", width),
        Method::Replan => tr!("a method, in a sentence" => "replan").to_owned(),
    }
}

/// While changes are listed.
pub(super) fn changing(changing: &Changing) -> String {
    let at = changing.at;
    match changing.list.as_slice() {
        [] => tr!(
            "The world changes at time {at}: change it with the tools, then find new plans.",
            at
        ),
        list => {
            tr!(
                "The world changes at time {at}: {n} change listed."
                    | "The world changes at time {at}: {n} changes listed." % list.len(),
                at
            )
        }
    }
}

/// What happens at the time at which the world changes.
pub(super) fn happening(changing: &Changing) -> String {
    let at = changing.at;
    let what = texts(changing.list.iter());
    tr!("At time {at}: {what}.", at, what)
}

/// While ways to go on are looked for.
pub(super) fn adapting(run: &Adapting) -> String {
    let at = run.changing.at;
    match work_done(run.size).as_str() {
        "" => tr!("Looking for ways to go on from time {at}.", at),
        work => tr!(
            "Looking for ways to go on from time {at}; {work}.",
            at,
            work
        ),
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
        let (many, names) = (names.len(), and(names));
        match makespan {
            Some(makespan) => tr!(
                "{names} has makespan {makespan}" | "{names} have makespan {makespan}" % many,
                names,
                makespan
            ),
            None => tr!("{names} has no plan" | "{names} have no plan" % many, names),
        }
    });
    let parts: Vec<String> = parts.collect();
    tr!(
        "At time {time}: {parts}.",
        time = comparing.changing.at,
        parts = parts.join("; ")
    )
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
            tr!(
                "The world changed at time {at}; the plan went on by {way}: {costs}.",
                at,
                way,
                costs
            )
        }
        None => tr!(
            "The world changed at time {at}; the plan went on: {costs}.",
            at,
            costs
        ),
    }
}
