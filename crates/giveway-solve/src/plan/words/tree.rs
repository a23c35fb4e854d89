//! A constraint tree in words: conflicts, and the constraint of each node.

use giveway_model::tr;

use crate::plan::{ToldConflict, ToldConstraint};

/// A conflict, to stand in a sentence: `A2 and A3 meet at (3, 1) at time 2`.
pub fn conflict(conflict: &ToldConflict) -> String {
    match conflict {
        ToldConflict::Vertex {
            agents: [a, b],
            cell,
            time,
            ..
        } => tr!(
            "{a} and {b} meet at {cell} at time {time}",
            a,
            b,
            cell,
            time
        ),
        ToldConflict::Swap {
            agents: [a, b],
            edge: [from, to],
            time,
            ..
        } => tr!(
            "{a} and {b} swap between {from} and {to} in the step from time {time}",
            a,
            b,
            from,
            to,
            time
        ),
        ToldConflict::Target {
            agents: [a, b],
            cell,
            time,
            ..
        } => tr!(
            "{b} comes to {cell} at time {time}, where {a} rests",
            b,
            cell,
            time,
            a
        ),
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
            tr!("{a} and {b} meet", a, b),
            tr!("{cell} at time {time}", cell, time),
        ],
        ToldConflict::Swap {
            agents: [a, b],
            edge: [from, to],
            time,
            ..
        } => [
            tr!("{a} and {b} swap", a, b),
            tr!("{from}, {to} at {time}", from, to, time),
        ],
        ToldConflict::Target {
            agents: [a, b],
            cell,
            time,
            ..
        } => [
            tr!("{b} runs into {a}", b, a),
            tr!("{cell} at time {time}", cell, time),
        ],
    }
}

/// The constraint of a node, as a sentence without a full stop.
pub fn constraint(constraint: &ToldConstraint) -> String {
    match constraint {
        ToldConstraint::NotAt { agent, cell, time } => {
            tr!("{agent} is not at {cell} at time {time}", agent, cell, time)
        }
        ToldConstraint::At { agent, cell, time } => {
            tr!(
                "{agent} is at {cell} at time {time}, and nobody else",
                agent,
                cell,
                time
            )
        }
        ToldConstraint::NotAlong {
            agent,
            edge: [from, to],
            time,
        } => tr!(
            "{agent} does not go from {from} to {to} at time {time}",
            agent,
            from,
            to,
            time
        ),
        ToldConstraint::Along {
            agent,
            edge: [from, to],
            time,
        } => {
            tr!(
                "{agent} goes from {from} to {to} at time {time}, and nobody comes against it",
                agent,
                from,
                to,
                time
            )
        }
        ToldConstraint::ArriveAfter { agent, time } => {
            tr!("{agent} arrives after time {time}", agent, time)
        }
        ToldConstraint::ArriveBy { agent, time } => {
            tr!(
                "{agent} arrives by time {time}, and nobody passes its goal from then on",
                agent,
                time
            )
        }
    }
}

/// The same beside the conflict that it avoids: `A2 keeps away`.
pub fn branch(constraint: &ToldConstraint) -> String {
    match constraint {
        ToldConstraint::NotAt { agent, .. } => tr!("{agent} keeps away", agent),
        ToldConstraint::At { agent, .. } => tr!("{agent} is there, others keep away", agent),
        ToldConstraint::NotAlong { agent, .. } => tr!("{agent} does not go", agent),
        ToldConstraint::Along { agent, .. } => tr!("{agent} goes, others keep away", agent),
        ToldConstraint::ArriveAfter { agent, time } => {
            tr!("{agent} arrives after time {time}", agent, time)
        }
        ToldConstraint::ArriveBy { agent, time } => {
            tr!(
                "{agent} arrives by time {time}, others keep away",
                agent,
                time
            )
        }
    }
}

/// The agent of a constraint.
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

/// The agents of a conflict.
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
