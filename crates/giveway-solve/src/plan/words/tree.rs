//! What stands in a constraint tree, in words: conflicts, and what a node asks.

use crate::plan::{ToldConflict, ToldConstraint};

/// A conflict, to stand in a sentence: `A2 and A3 meet at (3, 1) at time 2`.
pub fn conflict(conflict: &ToldConflict) -> String {
    match conflict {
        ToldConflict::Vertex {
            agents: [a, b],
            cell,
            time,
            ..
        } => format!("{a} and {b} meet at {cell} at time {time}"),
        ToldConflict::Swap {
            agents: [a, b],
            edge: [from, to],
            time,
            ..
        } => format!("{a} and {b} swap between {from} and {to} in the step from time {time}"),
        ToldConflict::Target {
            agents: [a, b],
            cell,
            time,
            ..
        } => format!("{b} comes to {cell} at time {time}, where {a} rests"),
    }
}

/// The same in two short lines: who, and where and when.
pub fn conflict_lines(conflict: &ToldConflict) -> [String; 2] {
    match conflict {
        ToldConflict::Vertex {
            agents: [a, b],
            cell,
            time,
            ..
        } => [
            format!("{a} and {b} meet"),
            format!("{cell} at time {time}"),
        ],
        ToldConflict::Swap {
            agents: [a, b],
            edge: [from, to],
            time,
            ..
        } => [
            format!("{a} and {b} swap"),
            format!("{from}, {to} at {time}"),
        ],
        ToldConflict::Target {
            agents: [a, b],
            cell,
            time,
            ..
        } => [
            format!("{b} runs into {a}"),
            format!("{cell} at time {time}"),
        ],
    }
}

/// What a node asks, as a sentence without a full stop.
pub fn constraint(constraint: &ToldConstraint) -> String {
    match constraint {
        ToldConstraint::NotAt { agent, cell, time } => {
            format!("{agent} is not at {cell} at time {time}")
        }
        ToldConstraint::At { agent, cell, time } => {
            format!("{agent} is at {cell} at time {time}, and nobody else")
        }
        ToldConstraint::NotAlong {
            agent,
            edge: [from, to],
            time,
        } => format!("{agent} does not go from {from} to {to} at time {time}"),
        ToldConstraint::Along {
            agent,
            edge: [from, to],
            time,
        } => {
            format!("{agent} goes from {from} to {to} at time {time}, and nobody comes against it")
        }
        ToldConstraint::ArriveAfter { agent, time } => format!("{agent} arrives after time {time}"),
        ToldConstraint::ArriveBy { agent, time } => {
            format!("{agent} arrives by time {time}, and nobody passes its goal from then on")
        }
    }
}

/// The same beside the conflict that it avoids: `A2 keeps away`.
pub fn branch(constraint: &ToldConstraint) -> String {
    match constraint {
        ToldConstraint::NotAt { agent, .. } => format!("{agent} keeps away"),
        ToldConstraint::At { agent, .. } => format!("{agent} is there, others keep away"),
        ToldConstraint::NotAlong { agent, .. } => format!("{agent} does not go"),
        ToldConstraint::Along { agent, .. } => format!("{agent} goes, others keep away"),
        ToldConstraint::ArriveAfter { agent, time } => format!("{agent} arrives after time {time}"),
        ToldConstraint::ArriveBy { agent, time } => {
            format!("{agent} arrives by time {time}, others keep away")
        }
    }
}

/// Whom a constraint is about.
pub fn subject(constraint: &ToldConstraint) -> &str {
    match constraint {
        ToldConstraint::NotAt { agent, .. }
        | ToldConstraint::At { agent, .. }
        | ToldConstraint::NotAlong { agent, .. }
        | ToldConstraint::Along { agent, .. }
        | ToldConstraint::ArriveAfter { agent, .. }
        | ToldConstraint::ArriveBy { agent, .. } => agent,
    }
}

/// Who has a conflict.
pub const fn parties(conflict: &ToldConflict) -> &[String; 2] {
    match conflict {
        ToldConflict::Vertex { agents, .. }
        | ToldConflict::Swap { agents, .. }
        | ToldConflict::Target { agents, .. } => agents,
    }
}

/// When a conflict is.
pub const fn moment(conflict: &ToldConflict) -> u32 {
    match conflict {
        ToldConflict::Vertex { time, .. }
        | ToldConflict::Swap { time, .. }
        | ToldConflict::Target { time, .. } => *time,
    }
}
