//! A robot is found by a part of its name, and brought into view.

mod small;
#[cfg(test)]
mod tests;

use giveway_model::tr;
use giveway_model::words::grouped;

use crate::words::at;
use crate::{State, board};

/// The most robots that are listed at once.
const MOST: usize = 8;

/// What is typed to find a robot, and which of the robots listed is chosen.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Find {
    /// A part of the name.
    pub typed: String,
    /// The place in the list.
    pub(crate) chosen: usize,
}

/// What a person does to find a robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FindAction {
    /// Begins to look for one.
    Open,
    /// Typed a part of the name.
    Type(String),
    /// Chooses the one below in the list, or the one above.
    Step {
        /// Whether it is the one below.
        down: bool,
    },
    /// Selects the robot at a place in the list and brings it into view; without a
    /// place the one that is chosen.
    Take(Option<usize>),
    /// Looks for none any longer.
    Close,
}

/// A robot whose name fits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Match {
    /// Its index in the scene.
    pub agent: usize,
    /// Its name.
    pub name: String,
    /// Where it is at the time shown: `at (3, 4)`.
    pub place: String,
    /// Whether it is the one chosen.
    pub is_chosen: bool,
}

/// The robots whose names fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Found {
    /// What was typed.
    pub typed: String,
    /// The first of them, the best first.
    pub matches: Vec<Match>,
    /// How many there are, in a sentence.
    pub sentence: String,
}

/// The robots whose names fit; `None` where none is looked for.
pub fn found(state: &State) -> Option<Found> {
    let find = state.view.find.as_ref()?;
    let all = fitting(state, &find.typed);
    let agents = state.world().agents();
    let of = |(place, &agent): (usize, &usize)| Match {
        agent,
        name: agents
            .get(agent)
            .map_or_else(String::new, |agent| agent.name.clone()),
        place: board::place_of(state, agent)
            .map_or_else(String::new, |cell| tr!("at {cell}", cell = at(cell))),
        is_chosen: place == find.chosen,
    };
    Some(Found {
        matches: all.iter().take(MOST).enumerate().map(of).collect(),
        sentence: sentence(&find.typed, all.len()),
        typed: find.typed.clone(),
    })
}

fn sentence(typed: &str, count_of_all: usize) -> String {
    let _number = grouped(count_of_all as u64);
    let listed = if count_of_all > MOST {
        tr!(", the first {most} are listed", most = MOST)
    } else {
        String::new()
    };
    match (typed.trim(), count_of_all) {
        ("", _) => tr!("Type a part of a name.").to_owned(),
        (typed, 0) => tr!("No robot has “{typed}” in its name.", typed),
        (_, number) => {
            tr!(
                "{n} robot fits{listed}." | "{n} robots fit{listed}." % number,
                listed
            )
        }
    }
}

/// All robots that are there and whose names have a text: first the one of that
/// very name, then those that begin with it.
fn fitting(state: &State, typed: &str) -> Vec<usize> {
    let typed = small::letters(typed.trim());
    let mut ranks: [Vec<usize>; 3] = Default::default();
    for (index, agent) in state.world().agents().iter().enumerate() {
        let name = small::letters(&agent.name);
        let rank = match name.find(&typed) {
            Some(_) if name == typed => 0,
            Some(0) => 1,
            Some(_) => 2,
            None => continue,
        };
        if state.is_there(index) {
            ranks[rank].push(index);
        }
    }
    ranks.concat()
}

impl Find {
    /// Another one of the list is chosen; after the last comes the first.
    pub(crate) fn step(&mut self, count: usize, down: bool) {
        let count = count.clamp(1, MOST);
        let by = if down { 1 } else { count - 1 };
        self.chosen = (self.chosen.min(count - 1) + by) % count;
    }
}

/// The robot at a place in the list; without a place the one that is chosen.
pub(crate) fn at_place(state: &State, place: Option<usize>) -> Option<usize> {
    let find = state.view.find.as_ref()?;
    let place = place.unwrap_or(find.chosen);
    fitting(state, &find.typed)
        .into_iter()
        .take(MOST)
        .nth(place)
}

/// How many robots are listed.
pub(crate) fn listed(state: &State) -> usize {
    found(state).map_or(0, |found| found.matches.len())
}
