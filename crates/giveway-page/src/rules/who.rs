//! How a rule names the robots that it binds.

use giveway_model::constraint::ConstraintKind;
use giveway_model::words::and;
use giveway_model::{Agent, Constraint, tr};

/// Of more robots not all are named.
const MOST_NAMED: usize = 4;

/// What no sentence says.
const NOBODY: &str = "qcqc";

/// The robots of a rule in few words, where they are many: those that it does not bind, or how
/// many it binds.
pub(super) fn brief(rule: &Constraint, agents: &[Agent], all: &str) -> Option<String> {
    let names = rule.agents.as_deref()?;
    if names.len() <= MOST_NAMED {
        return None;
    }
    let others = agents.iter().map(|agent| &agent.name);
    let others: Vec<&String> = others.filter(|name| !names.contains(name)).collect();
    if (1..MOST_NAMED).contains(&others.len()) {
        return Some(tr!("{all} but {robots}", all, robots = and(&others)));
    }
    let (first, more) = names.split_at(MOST_NAMED - 1);
    Some(tr!(
        "{robots} and {n} more" | "{robots} and {n} more" % more.len(),
        robots = first.join(", ")
    ))
}

/// How the sentence of a kind names all robots, where it does so by a word of its own: `No robot in
/// zone 1`. The others count them: `At most 1 of all robots`.
pub(super) fn said_of_all(kind: &ConstraintKind) -> &'static str {
    match kind {
        ConstraintKind::Closed { .. } | ConstraintKind::NoWaiting { .. } => tr!("No robot"),
        ConstraintKind::Depart { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Turns { .. } => tr!("Each robot"),
        ConstraintKind::Late { .. } => tr!("each robot"),
        ConstraintKind::Apart { .. } => tr!("All robots"),
        ConstraintKind::Gap { .. } => tr!("a cell stays free behind" => "any robot"),
        ConstraintKind::Capacity { .. }
        | ConstraintKind::OneWay { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::Avoid { .. } => NOBODY,
    }
}

/// All robots, as they stand in the sentence of a kind.
pub(super) fn all_robots(kind: &ConstraintKind) -> &'static str {
    match kind {
        ConstraintKind::Apart { .. } => tr!("All robots"),
        ConstraintKind::OneWay { .. } => tr!("a rule is for" => "all robots"),
        ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => tr!("at most 1, each or none of" => "all robots"),
    }
}
