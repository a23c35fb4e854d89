//! What the inspector says of robots that are to come onto the board.

use giveway_model::{Battery, Cell, tr};

use super::Fleet;
use crate::State;
use crate::words::at;

/// The robots in a sentence whose numbers can be changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Card {
    /// How many start along the row.
    pub count: u32,
    /// Where they start.
    pub starts: String,
    /// Where they go; `None` until that is drawn.
    pub goals: Option<String>,
    /// Whether as many go the other way.
    pub back: bool,
    /// How many waypoints each has.
    pub waypoints: u32,
    /// Their battery.
    pub battery: Option<Battery>,
    /// What can be done, or why it is less than what was asked for.
    pub told: String,
    /// The button that adds them; `None` where nothing can be added.
    pub add: Option<String>,
}

/// The robots that are to come onto the board; `None` where there are none.
pub fn card(state: &State) -> Option<Card> {
    let fleet = state
        .view
        .fleet
        .as_ref()
        .filter(|_| state.can_place_fleet())?;
    let said = &fleet.0;
    let agents = state.fleet_agents();
    let ways = if said.back { 2 } else { 1 };
    let count = u32::try_from(agents.len() / ways).unwrap_or(u32::MAX);
    let add = tr!("Add {n} robot" | "Add {n} robots" % agents.len());
    Some(Card {
        count,
        starts: row(said.starts),
        goals: said.goals.map(row),
        back: said.back,
        waypoints: said.waypoints,
        battery: said.battery,
        told: told(fleet, count),
        add: (fleet.has_goals() && count > 0).then_some(add),
    })
}

fn row((from, to): (Cell, Cell)) -> String {
    if from == to {
        return at(from);
    }
    tr!("{from} to {to}", from = at(from), to = at(to))
}

fn told(fleet: &Fleet, count: u32) -> String {
    match fleet.0.count {
        _ if !fleet.has_goals() => tr!("Now drag over the cells where they go.").to_owned(),
        _ if count == 0 => tr!("No start there has a free goal.").to_owned(),
        Some(asked) if asked > count => {
            tr!(
                "Only {count} of {asked} have a free start and goal there.",
                count,
                asked
            )
        }
        Some(_) | None => tr!("They come onto the board when you add them, or solve.").to_owned(),
    }
}
