//! What an agent would run into, as clauses after "it would".

use std::collections::BTreeSet;

use giveway_model::check::{Rule, Violation};
use giveway_model::words::{and, count};

/// The most that a sentence tells one by one.
const MOST: usize = 3;

/// `meet A1 at (2, 1) at time 1 and run out of battery at time 9`.
pub(crate) fn would(agent: &str, violations: &[&Violation]) -> String {
    let mut phrases: Vec<String> = Vec::new();
    let mut seen = BTreeSet::new();
    for violation in violations {
        // Who has met somebody once need not be told of it again.
        let collides = violation.agents.len() > 1;
        if !collides || seen.insert(&violation.agents) {
            phrases.push(phrase(agent, violation));
        }
    }
    let more = phrases.len().saturating_sub(MOST);
    if more > 0 {
        phrases.truncate(MOST);
        phrases.push(format!("break {}", count(more, "more rule")));
    }
    and(&phrases)
}

fn phrase(agent: &str, violation: &Violation) -> String {
    let others = violation.agents.iter().filter(|name| *name != agent);
    let others: Vec<&String> = others.collect();
    let other = and(&others);
    let time = violation.time;
    let cell = violation
        .cell
        .map_or_else(String::new, |cell| format!(" at {cell}"));
    let edge = violation
        .edge
        .map_or_else(String::new, |[u, v]| format!(" between {u} and {v}"));
    match violation.rule {
        Rule::Vertex => format!("meet {other}{cell} at time {time}"),
        Rule::Swap => format!("run into {other}{edge} at time {time}"),
        Rule::SlowSwap => format!("meet {other} half way{edge} at time {time}"),
        Rule::Battery => format!("run out of battery at time {time}"),
        Rule::Waypoint => format!("miss its waypoint{cell}"),
        Rule::Obstacle => format!("pass through the obstacle{cell} at time {time}"),
        Rule::Goal => "not end at its goal".to_owned(),
        Rule::Charge => format!("charge at time {time}, where it cannot"),
        Rule::Shape | Rule::Start | Rule::Move => format!("break a rule at time {time}"),
    }
}
