//! The tab of a zone: its signs, its times, and where it stands.

use std::collections::BTreeSet;

use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::{Agent, Cell, Constraint, Ground, Zone};

use super::kind::times_of;
use super::{RuledMap, SignKind};

/// So many signs stand beside each other; more fold into one with their number.
const SIGNS: usize = 3;

/// The signs of the rules of a zone.
pub(super) fn folded<'a>(rules: impl Iterator<Item = &'a Constraint>) -> Vec<SignKind> {
    let signs: Vec<SignKind> = rules.filter(|rule| !rule.off).filter_map(sign).collect();
    if signs.is_empty() {
        return vec![SignKind::Dot];
    }
    if signs.len() > SIGNS {
        return vec![SignKind::Ring(format!("+{}", signs.len()))];
    }
    signs
}

fn sign(rule: &Constraint) -> Option<SignKind> {
    Some(match &rule.kind {
        ConstraintKind::Capacity { most, .. } => SignKind::Ring(most.to_string()),
        ConstraintKind::Closed { .. } => SignKind::Bar,
        ConstraintKind::NoWaiting { .. } => SignKind::Pause,
        ConstraintKind::Avoid { weight, .. } => SignKind::Triangle(weight.to_string()),
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::Turns { .. } => return None,
    })
}

/// The times of a rule of a zone, where it does not always hold.
pub(super) fn times(rule: &Constraint) -> Option<String> {
    let times = times_of(&rule.kind)?;
    match (times.first(), meant(times).to) {
        _ if rule.off => None,
        (0, None) => None,
        (from, None) => Some(format!("{from}\u{2013}")),
        (from, Some(to)) => Some(format!("{from}\u{2013}{to}")),
    }
}

/// Where the tab of a zone begins, and how wide it is, in units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) at: (f64, f64),
    wide: f64,
}

impl Spot {
    /// Whether two tabs would lie on each other.
    fn meets(&self, other: &Self) -> bool {
        let [(x, y), (a, b)] = [self.at, other.at];
        (y - b).abs() < TALL && x < a + other.wide && a < x + self.wide
    }

    /// Whether the tab would lie on what a cell says of a start, a goal or a waypoint.
    fn covers(&self, cell: Cell) -> bool {
        let (x, y) = (f64::from(cell.x) * 100.0, f64::from(cell.y) * 100.0);
        let (left, top) = (self.at.0 - SIGN, self.at.1 - TALL / 2.0);
        left < x + 100.0 && x < left + self.wide && top < y + 100.0 && y < top + TALL
    }
}

/// How tall a tab is, how far its first sign reaches to the left, and how wide a letter is.
const TALL: f64 = 40.0;
const SIGN: f64 = 20.0;
const LETTER: f64 = 12.5;
/// At most so many cells of a zone are looked at for a place.
const LOOKED_AT: usize = 400;

/// Where the tab of a zone begins: on an obstacle that touches it or is part of it, where no
/// robot covers it; else on its upper edge, or on its lower one. A place that is free of other
/// tabs and of names of starts and goals comes first.
pub(super) fn tab(map: RuledMap<'_>, zone: &Zone, cells: &BTreeSet<Cell>, taken: &[Spot]) -> Spot {
    let grid = map.grid;
    let is_obstacle = |cell: Cell| grid.ground(cell) == Some(Ground::Obstacle);
    let wide = zone.name.chars().count() as f64 * LETTER + 2.0 * TALL + SIGN;
    let at = |x: u32, y: u32, by: (f64, f64)| Spot {
        at: (f64::from(x) * 100.0 + by.0, f64::from(y) * 100.0 + by.1),
        wide,
    };
    let mut by_row: Vec<Cell> = cells.iter().copied().collect();
    by_row.sort_by_key(|cell| (cell.y, cell.x));
    by_row.truncate(LOOKED_AT);
    let inside = by_row.iter().filter(|&&cell| is_obstacle(cell));
    let beside = by_row.iter().filter(|cell| {
        let right = Cell::new(cell.x + 1, cell.y);
        !cells.contains(&right) && is_obstacle(right)
    });
    let upper = by_row
        .iter()
        .filter(|cell| cell.y > 0 && !cells.contains(&Cell::new(cell.x, cell.y.saturating_sub(1))));
    let lower = by_row
        .iter()
        .rev()
        .filter(|cell| !cells.contains(&Cell::new(cell.x, cell.y + 1)));
    let places = inside
        .map(|cell| at(cell.x, cell.y, (22.0, 32.0)))
        .chain(beside.map(|cell| at(cell.x + 1, cell.y, (3.0, 28.0))))
        .chain(upper.map(|cell| at(cell.x, cell.y, (22.0, -20.0))))
        .chain(lower.map(|cell| at(cell.x, cell.y + 1, (22.0, -5.0))));
    let places: Vec<Spot> = places.collect();
    let agents = map.agents;
    let named = |agent: &Agent| {
        let ends = [Some(agent.start), agent.goal];
        let ends = ends.into_iter().flatten();
        ends.chain(agent.waypoints.iter().copied()).collect()
    };
    let named: Vec<Cell> = agents
        .iter()
        .flat_map(|agent| -> Vec<Cell> { named(agent) })
        .collect();
    let is_free = |spot: &&Spot| !taken.iter().any(|other| spot.meets(other));
    let is_bare = |spot: &&Spot| !named.iter().any(|&cell| spot.covers(cell));
    let best = places.iter().find(|spot| is_free(spot) && is_bare(spot));
    let best = best
        .or_else(|| places.iter().find(is_free))
        .or(places.first());
    best.copied().unwrap_or_else(|| at(0, 0, (0.0, 0.0)))
}
