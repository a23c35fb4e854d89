//! A robot is found by a part of its name: the first that fits is selected and brought into view.

mod small;
#[cfg(test)]
mod tests;

use giveway_model::words::grouped;
use giveway_model::{Cell, tr};

use crate::State;
use crate::changing::broken_down_for_good;

/// What is typed to find a robot, and which of the robots that fit is selected.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Find {
    /// A part of the name.
    pub typed: String,
    /// The place among those that fit.
    pub(crate) chosen: usize,
}

/// What a person does to find a robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FindAction {
    /// Begins to look for one.
    Open,
    /// Typed a part of the name: the first robot that fits is selected.
    Type(String),
    /// Selects the next robot that fits, or the one before.
    Step {
        /// Whether it is the next.
        on: bool,
    },
    /// Looks for none any longer.
    Close,
}

/// The robots whose names fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Found {
    /// What was typed.
    pub typed: String,
    /// The robot that is selected of them, by its index in the scene.
    pub agent: Option<usize>,
    /// Which of how many it is: `1 of 4`; empty where nothing was typed.
    pub place: String,
}

/// The robots whose names fit; `None` where none is looked for.
pub fn found(state: &State) -> Option<Found> {
    let find = state.view.find.as_ref()?;
    let fitting = fitting(state, &find.typed);
    let place = match (find.typed.trim(), fitting.len()) {
        ("", _) => String::new(),
        (_, 0) => tr!("a robot by its name" => "none").to_owned(),
        (_, all) => {
            let place = grouped(find.chosen as u64 + 1);
            let all = grouped(all as u64);
            if broken_down(state, chosen(state)).is_some() {
                tr!("{place} of {all}, broken down for good", place, all)
            } else {
                tr!("{place} of {all}", place, all)
            }
        }
    };
    Some(Found {
        typed: find.typed.clone(),
        agent: chosen(state),
        place,
    })
}

/// All robots that are there, as an obstacle at least, and whose names have a text: first the one of that
/// very name, then those of that number, then those that begin with it.
fn fitting(state: &State, typed: &str) -> Vec<usize> {
    let typed = small::letters(typed.trim());
    let mut ranks: [Vec<usize>; 4] = Default::default();
    if typed.is_empty() {
        return Vec::new();
    }
    for (index, agent) in state.world().agents().iter().enumerate() {
        let name = small::letters(&agent.name);
        let number = name.trim_start_matches(|c: char| !c.is_ascii_digit());
        let rank = match name.find(&typed) {
            Some(_) if name == typed => 0,
            Some(_) if number == typed => 1,
            Some(0) => 2,
            Some(_) => 3,
            None => continue,
        };
        if state.is_there(index) || broken_down(state, Some(index)).is_some() {
            ranks[rank].push(index);
        }
    }
    ranks.concat()
}

/// Where a robot stays that has broken down for good.
pub(crate) fn broken_down(state: &State, agent: Option<usize>) -> Option<Cell> {
    let agent = agent.filter(|&agent| !state.is_there(agent))?;
    let mut all = broken_down_for_good(state).into_iter();
    let own = all.find(|stopped| stopped.agent == Some(agent))?;
    Some(own.cell)
}

impl Find {
    /// The next of those that fit, or the one before; after the last comes the first.
    pub(crate) fn step(&mut self, count: usize, on: bool) {
        let count = count.max(1);
        let by = if on { 1 } else { count - 1 };
        self.chosen = (self.chosen.min(count - 1) + by) % count;
    }
}

/// The robot that is selected of those that fit.
pub(crate) fn chosen(state: &State) -> Option<usize> {
    let find = state.view.find.as_ref()?;
    fitting(state, &find.typed).get(find.chosen).copied()
}

/// How many robots fit.
pub(crate) fn count(state: &State) -> usize {
    let find = state.view.find.as_ref();
    find.map_or(0, |find| fitting(state, &find.typed).len())
}
