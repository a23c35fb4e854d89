//! What is marked on a cell of the drawn map: starts, goals and waypoints.

use std::collections::BTreeMap;

use giveway_model::{Cell, Instance};

/// Whose cell it is, in one of two ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Style {
    /// Agent 0 is A: `A` its start, `a` its goal, `a'` a waypoint.
    Letters,
    /// Whose it is is not told: `S` a start, `G` a goal, `X` both, `w` a
    /// waypoint and nothing else.
    Kinds,
}

/// So many agents have letters.
pub(crate) const LETTERS: usize = 26;

/// The marks of every cell that has one.
pub(crate) fn marks(instance: &Instance, style: Style) -> BTreeMap<Cell, String> {
    match style {
        Style::Letters => letters(instance),
        Style::Kinds => kinds(instance),
    }
}

/// The letter of an agent's start; none beyond the alphabet.
pub(crate) fn letter(agent: usize) -> Option<char> {
    ('A'..='Z').nth(agent)
}

fn letters(instance: &Instance) -> BTreeMap<Cell, String> {
    let mut marks: BTreeMap<Cell, String> = BTreeMap::new();
    let lettered = || instance.agents().iter().zip('A'..='Z');
    for (agent, letter) in lettered() {
        marks.entry(agent.start).or_default().push(letter);
    }
    for (agent, letter) in lettered() {
        let small = letter.to_ascii_lowercase();
        if let Some(goal) = agent.goal {
            marks.entry(goal).or_default().push(small);
        }
        for &waypoint in &agent.waypoints {
            let mark = marks.entry(waypoint).or_default();
            mark.push(small);
            mark.push('\'');
        }
    }
    marks
}

fn kinds(instance: &Instance) -> BTreeMap<Cell, String> {
    let mut kinds: BTreeMap<Cell, char> = BTreeMap::new();
    for agent in instance.agents() {
        for &waypoint in &agent.waypoints {
            kinds.insert(waypoint, 'w');
        }
    }
    for goal in instance.agents().iter().filter_map(|agent| agent.goal) {
        kinds.insert(goal, 'G');
    }
    for agent in instance.agents() {
        let kind = kinds.entry(agent.start).or_default();
        *kind = if matches!(kind, 'G' | 'X') { 'X' } else { 'S' };
    }
    kinds
        .into_iter()
        .map(|(cell, kind)| (cell, kind.to_string()))
        .collect()
}
