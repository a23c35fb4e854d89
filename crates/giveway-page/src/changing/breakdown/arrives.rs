//! Whether the battery of a robot that breaks down lasts, and who cannot arrive any more: what can
//! be said of each robot alone.

use std::collections::BTreeSet;

use giveway_model::change::What;
use giveway_model::words::and;
use giveway_model::{Agent, Battery, Cell, Grid, tr};

use super::super::Changing;
use super::super::meets::stands;
use super::lanes;
use crate::problems::{Reach, reach};
use crate::timeline::Lane;

/// The cells that are looked at for all robots together, with their batteries.
const LOOKS: usize = 400_000;

/// What is said of a breakdown on a cell from a time on; whether it is bad news.
pub(super) fn told(
    changing: &Changing,
    lane: &Lane,
    (cell, from): (Cell, u32),
    steps: Option<u32>,
) -> Vec<(bool, String)> {
    let mut told = Vec::new();
    let mut looks = LOOKS;
    let mut lost = Vec::new();
    match steps {
        // One that has arrived needs no battery any more.
        Some(_) if lane.arrives && lane.arrival <= changing.at => {}
        Some(steps) => {
            let left = Left::of(changing, lane, (cell, from), steps);
            let is_empty = left.is_some_and(|left| left.after.is_none());
            let level = left.and_then(|left| left.after);
            if is_empty || is_cut_off(changing, lane, cell, level, &mut looks) {
                lost.push(lane.name.clone());
            } else if let Some(left) = left {
                told.push(left.told(&lane.name));
            }
        }
        None => told.push((
            true,
            tr!(
                "{name} does not arrive: it stays there as an obstacle.",
                name = lane.name
            ),
        )),
    }
    for other in lanes(changing).filter(|other| other.name != lane.name) {
        if other.arrival <= changing.at || !changing.has(&other.name) {
            continue;
        }
        let (cell, from) = stands(&other, changing.at);
        let level = changing.level(&other, from);
        if is_cut_off(changing, &other, cell, level, &mut looks) {
            lost.push(other.name);
        }
    }
    if !lost.is_empty() {
        told.push((
            true,
            tr!(
                "{n} robot could not arrive any more: {names}."
                    | "{n} robots could not arrive any more: {names}." % lost.len(),
                names = and(&lost)
            ),
        ));
    }
    told
}

/// What a breakdown leaves in a battery.
#[derive(Clone, Copy)]
struct Left {
    /// The level when the robot goes on; `None` where the battery does not last until then.
    after: Option<u32>,
    /// The least level on its path until it charges or arrives.
    least: u32,
    /// When that is too low first.
    low: Option<u32>,
}

impl Left {
    /// `None` without a battery.
    fn of(changing: &Changing, lane: &Lane, (cell, from): (Cell, u32), steps: u32) -> Option<Self> {
        let (capacity, floor) = (lane.capacity?, changing.floor());
        let level = changing.level(lane, from)?;
        if changing.draft().grid().is_charger(cell) && capacity >= floor && level >= floor {
            // It charges while it stands there.
            return Some(Self {
                after: Some(capacity),
                least: level,
                low: None,
            });
        }
        // A level that was set is as much more or less on all of the path.
        let shift = i64::from(level) - i64::from(lane.level_at(from)?) - i64::from(steps);
        let charges = |time: &u32| *time >= from;
        let end = lane.charges.iter().copied().find(charges);
        let late = |time: u32| lane.level_at(time).map_or(0, i64::from) + shift;
        let times = from..=end.unwrap_or(lane.arrival).max(from);
        let low = times.clone().find(|&time| late(time) < floor.into());
        Some(Self {
            after: level.checked_sub(steps).filter(|&level| level >= floor),
            least: times.map(late).min()?.try_into().unwrap_or(0),
            low: low.map(|time| time.saturating_add(steps)),
        })
    }

    fn told(self, name: &str) -> (bool, String) {
        if let Some(time) = self.low {
            let bad = tr!(
                "The battery of {name} does not last on its path: it is too low at {time}. Another path has to charge it.",
                name,
                time
            );
            return (true, bad);
        }
        let n = self.least;
        let good = tr!(
            "The battery of {name} lasts: {n} step is left where it is lowest."
                | "The battery of {name} lasts: {n} steps are left where it is lowest." % n,
            name
        );
        (false, good)
    }
}

impl Changing {
    fn floor(&self) -> u32 {
        self.draft().scene().rules.battery_floor
    }

    /// The level of a robot's battery when the world changes, or right after the move under way.
    fn level(&self, lane: &Lane, from: u32) -> Option<u32> {
        let set = self.list.iter().rev().find_map(|what| match what {
            What::SetBattery { agent, level } if *agent == lane.name => Some(*level),
            _ => None,
        });
        let under_way = from.saturating_sub(self.at);
        let set = set.map(|level| level.saturating_sub(under_way));
        set.or_else(|| lane.level_at(from))
    }

    /// Whether a robot is there after all that is listed.
    fn has(&self, name: &str) -> bool {
        let mut agents = self.draft().agents().iter().zip(&self.world.is_there);
        agents.any(|(own, is_there)| own.name == name && *is_there)
    }
}

/// Whether a robot, alone in the world that changes, comes from a cell to its goal and to all
/// waypoints that it has not visited yet by no path at all.
fn is_cut_off(
    changing: &Changing,
    lane: &Lane,
    cell: Cell,
    level: Option<u32>,
    looks: &mut usize,
) -> bool {
    let draft = changing.draft();
    let (grid, floor) = (draft.grid(), changing.floor());
    let Some(own) = draft.agents().iter().find(|own| own.name == lane.name) else {
        return false;
    };
    let seen = lane.steps.iter().filter(|step| step.ends <= changing.at);
    let visited: BTreeSet<Cell> = seen.map(|step| step.to).chain([lane.entry, cell]).collect();
    let left = own.waypoints.iter().copied();
    let left = left.filter(|waypoint| !visited.contains(waypoint));
    let mut aims = left.chain(own.goal);
    let Some(battery) = own.battery.zip(level) else {
        let reached = reached(grid, cell);
        return aims.any(|aim| !reached.contains(&aim));
    };
    let (Battery { capacity, .. }, level) = battery;
    let initial = level.min(capacity);
    let begins = Agent {
        start: cell,
        battery: Some(Battery { capacity, initial }),
        ..own.clone()
    };
    let reach: Reach = reach(grid, &begins, floor, looks);
    aims.any(|aim| !reach.goes_on(aim))
}

/// The cells that can be reached from one.
fn reached(grid: &Grid, from: Cell) -> BTreeSet<Cell> {
    let mut reached = BTreeSet::from([from]);
    let mut open = vec![from];
    while let Some(cell) = open.pop() {
        for next in grid.neighbours(cell) {
            if reached.insert(next) {
                open.push(next);
            }
        }
    }
    reached
}
