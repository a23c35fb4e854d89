//! Causes, and what else there is to say of a method, as sentences.

use giveway_model::{tr, words::and};

use super::{Cause, CauseKind, Method, MethodAnswer};
use crate::words::{clash, reason};

/// A cause as a sentence.
pub(crate) fn cause(cause: &Cause) -> String {
    let Cause {
        agent,
        kind,
        cell,
        agents,
        within: _,
        method,
        held,
        has_batteries,
        rule,
    } = cause;
    let rule = rule.as_ref().map(|rule| rule.constraint.called());
    let they = if held.len() == agents.len() {
        tr!("robots just named" => "they").to_owned()
    } else {
        and(held)
    };
    let place = cell.map_or_else(
        || tr!("a place" => "there").to_owned(),
        |cell| cell.to_string(),
    );
    let bounds = match method {
        Method::Revise => tr!("on its old path"),
        Method::Tunnel(_) => tr!("near its old path"),
        Method::Replan => tr!("on any path"),
    };
    if let (CauseKind::Blocked, Some(rule)) = (kind, &rule) {
        return blocked_by_rule(cause, rule);
    }
    match (kind, method) {
        (CauseKind::Rule, _) => {
            let rule = rule.unwrap_or_else(|| tr!("a rule").to_owned());
            tr!("{agent} cannot keep {rule} {bounds}.", agent, rule, bounds)
        }
        (CauseKind::Obstacle, Method::Replan) => {
            tr!(
                "{agent} has to go to {place}, where there is an obstacle now.",
                agent,
                place
            )
        }
        (CauseKind::Obstacle, _) => {
            tr!(
                "An obstacle at {place} blocks the rest of the path of {agent}.",
                place,
                agent
            )
        }
        (CauseKind::Goal, _) => {
            tr!(
                "The goal of {agent} is now {place}, which is not {bounds}.",
                agent,
                place,
                bounds
            )
        }
        (CauseKind::Waypoint, _) => {
            tr!(
                "{agent} has to visit {place}, which is not {bounds}.",
                agent,
                place,
                bounds
            )
        }
        (CauseKind::Battery, _) => tr!(
            "The battery of {agent} does not last {bounds}.",
            agent,
            bounds
        ),
        (CauseKind::NoWay, _) => tr!(
            "{agent} cannot do its task {bounds}, even alone.",
            agent,
            bounds
        ),
        (CauseKind::Blocked, Method::Replan) => clash(agents),
        (CauseKind::Blocked, _) if agents.len() < 2 => {
            tr!(
                "{agent} cannot arrive {bounds}, no matter when it waits.",
                agent,
                bounds
            )
        }
        (CauseKind::Blocked, Method::Revise) if *has_batteries => tr!(
            "{robots} block each other: as long as {they} keep to their old paths, no choice of waits lets them all arrive with what their batteries hold.",
            robots = list(agents),
            they
        ),
        (CauseKind::Blocked, Method::Revise) => tr!(
            "{robots} block each other: as long as {they} keep to their old paths, no choice of waits lets them all arrive.",
            robots = list(agents),
            they
        ),
        (CauseKind::Blocked, Method::Tunnel(_)) => tr!(
            "{robots} block each other: {they} cannot all stay near their old paths.",
            robots = list(agents),
            they
        ),
    }
}

/// A rule between agents that leaves no plan.
fn blocked_by_rule(cause: &Cause, rule: &str) -> String {
    let Cause { agent, agents, .. } = cause;
    if agents.len() < 2 {
        return tr!("{agent} cannot arrive and keep {rule}.", agent, rule);
    }
    let robots = list(agents);
    match cause.method {
        Method::Revise => tr!(
            "{robots} cannot all arrive on their old paths and keep {rule}.",
            robots,
            rule
        ),
        Method::Tunnel(_) => tr!(
            "{robots} cannot all arrive near their old paths and keep {rule}.",
            robots,
            rule
        ),
        Method::Replan => tr!("{robots} cannot all arrive and keep {rule}.", robots, rule),
    }
}

/// So many names are told one by one; the rest is counted.
const TOLD: usize = 12;

/// Names in a row, not more than a sentence can bear.
///
/// ```
/// let names: Vec<String> = (1..=14).map(|i| format!("A{i}")).collect();
/// let told = giveway_solve::change::names(&names);
/// assert!(told.ends_with("A12 and 2 more"));
/// ```
pub fn names(names: &[String]) -> String {
    match names.get(..TOLD) {
        Some(told) if names.len() > TOLD => {
            tr!(
                "{names} and {more} more",
                names = told.join(", "),
                more = names.len() - TOLD
            )
        }
        _ => and(names),
    }
}

/// Why a method has no plan or freed robots, and which ones, a sentence each.
pub fn notes(answer: &MethodAnswer) -> Vec<String> {
    let mut notes = Vec::new();
    match (&answer.cause, &answer.result.reason) {
        (Some(cause), _) => {
            notes.push(self::cause(cause));
            if let Some(within) = cause.within {
                notes.push(tr!("That is shown up to makespan {within}.", within));
            }
        }
        (None, Some(given)) if answer.result.plan.is_none() => {
            notes.push(reason(given));
        }
        _ => {}
    }
    if !answer.freed.is_empty() && answer.result.plan.is_some() {
        let names = names(&answer.freed);
        let fewest = match (answer.fewest, answer.fewest_within) {
            (true, None) => tr!("freeing fewer robots is not enough").to_owned(),
            (true, Some(n)) => tr!("freeing fewer robots is not enough up to makespan {n}", n),
            (false, _) => tr!("freeing fewer robots might be enough").to_owned(),
        };
        notes.push(tr!(
            "Free to take any path: {names}; {fewest}.",
            names,
            fewest
        ));
    }
    notes
}

/// Agents that block each other, as part of a sentence.
fn list(names: &[String]) -> String {
    match names {
        [] => tr!("The robots").to_owned(),
        names => and(names),
    }
}
