//! The tab of a zone: its signs, its times, and where it stands.

use std::collections::BTreeSet;

use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::{Cell, Constraint, Ground};

use super::SignKind;
use crate::Draft;

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
    let mut kind = rule.kind.clone();
    let times = *crate::rules::parts(&mut kind).times?;
    match (times.first(), meant(times).to) {
        _ if rule.off => None,
        (0, None) => None,
        (from, None) => Some(format!("{from}\u{2013}")),
        (from, Some(to)) => Some(format!("{from}\u{2013}{to}")),
    }
}

/// Where the tab of a zone begins: on an obstacle that touches it or is part of it, where no
/// robot covers it; else on its upper edge, or on its lower one.
pub(super) fn tab(draft: &Draft, cells: &BTreeSet<Cell>, taken: &[(f64, f64)]) -> (f64, f64) {
    let grid = draft.grid();
    let is_obstacle = |cell: Cell| grid.ground(cell) == Some(Ground::Obstacle);
    let at =
        |x: u32, y: u32, by: (f64, f64)| (f64::from(x) * 100.0 + by.0, f64::from(y) * 100.0 + by.1);
    let mut by_row: Vec<Cell> = cells.iter().copied().collect();
    by_row.sort_by_key(|cell| (cell.y, cell.x));
    let inside = by_row.iter().filter(|&&cell| is_obstacle(cell));
    let beside = by_row.iter().filter(|cell| {
        let right = Cell::new(cell.x + 1, cell.y);
        !cells.contains(&right) && is_obstacle(right)
    });
    let upper = by_row.first().filter(|cell| cell.y > 0);
    let places = inside
        .map(|cell| at(cell.x, cell.y, (22.0, 32.0)))
        .chain(beside.map(|cell| at(cell.x + 1, cell.y, (3.0, 28.0))))
        .chain(upper.map(|cell| at(cell.x, cell.y, (22.0, -20.0))))
        .chain(
            by_row
                .last()
                .map(|cell| at(cell.x, cell.y + 1, (22.0, -5.0))),
        );
    let is_free = |place: &(f64, f64)| {
        taken
            .iter()
            .all(|other| (other.0 - place.0).abs() > 180.0 || (other.1 - place.1).abs() > 40.0)
    };
    let places: Vec<(f64, f64)> = places.collect();
    let free = places.iter().copied().find(is_free);
    free.or(places.first().copied()).unwrap_or((0.0, 0.0))
}
