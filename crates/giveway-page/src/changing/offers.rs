//! What can be changed of an agent beside the board: its battery, a breakdown, waypoints.

use giveway_model::change::What;
use giveway_model::{Battery, Cell};

use super::listed::whose;
use super::stopped::place;
use crate::State;
use crate::timeline::Lane;

/// What can be changed of an agent beside the board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offers {
    /// The time, in steps.
    pub at: u32,
    /// Its name.
    pub name: String,
    /// Its battery's level then, and the capacity; `None` without a battery.
    pub level: Option<(u32, u32)>,
    /// The battery of one that joins; `None` for any other one.
    pub battery: Option<Option<Battery>>,
    /// Where it stands; `None` in transit.
    pub place: Option<Cell>,
    /// The breakdown that is listed, in steps.
    pub delay: Option<u32>,
    /// The waypoints that it has still to visit.
    pub waypoints: Vec<Cell>,
}

/// What can be changed of an agent; `None` while the world does not change, and
/// for one that is not there.
pub fn offers(state: &State, agent: usize) -> Option<Offers> {
    let changing = state.document.mode.changing()?;
    let who = changing.draft().agents().get(agent)?;
    if !*changing.world.is_there.get(agent)? {
        return None;
    }
    let lane = Lane::of(&changing.about, agent);
    let listed = |find: fn(&What) -> Option<u32>| {
        let own = changing.list.iter().rev();
        let mut own = own.filter(|what| whose(what) == Some(&who.name));
        own.find_map(find)
    };
    let level = listed(|what| match what {
        What::SetBattery { level, .. } => Some(*level),
        _ => None,
    });
    let now = lane.as_ref().and_then(|lane| lane.level_at(changing.at));
    let is_visited = |cell: &Cell| {
        let steps = lane.iter().flat_map(|lane| &lane.steps);
        let entry = lane.iter().filter(|lane| lane.begins <= changing.at);
        let mut cells = entry.map(|lane| lane.entry).chain(
            steps
                .filter(|step| step.ends <= changing.at)
                .map(|step| step.to),
        );
        cells.any(|at| at == *cell)
    };
    let is_new = |cell: &Cell| {
        let what = What::AddWaypoint {
            agent: who.name.clone(),
            cell: *cell,
        };
        changing.list.contains(&what)
    };
    let joins = changing
        .list
        .iter()
        .any(|what| matches!(what, What::AddAgent { agent } if agent.name == who.name));
    let waypoints = who.waypoints.iter().copied();
    Some(Offers {
        at: changing.at,
        name: who.name.clone(),
        battery: joins.then_some(who.battery),
        place: changing
            .about
            .plan()
            .filter(|_| !joins)
            .and_then(|plan| place(plan, &who.name, changing.at)),
        level: who.battery.filter(|_| !joins).map(|battery| {
            let now = level.or(now).unwrap_or(battery.initial);
            (now, battery.capacity)
        }),
        delay: listed(|what| match what {
            What::DelayAgent { steps, .. } => Some(*steps),
            _ => None,
        }),
        waypoints: waypoints
            .filter(|cell| !is_visited(cell) || is_new(cell))
            .collect(),
    })
}
