//! Where steps are lost, found by trying all ways to go on.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::check::{arrivals, check};
use giveway_model::{Cell, Instance, Plan};
use giveway_solve::delays::{CellLoss, DelaysAnswer};
use giveway_tests::alone::paths;

use crate::MOST_STEPS;

pub(crate) fn by_cell(lost: &[CellLoss]) -> BTreeMap<(u32, u32), u32> {
    lost.iter()
        .map(|it| ((it.cell.x, it.cell.y), it.steps))
        .collect()
}

/// Where an agent loses steps: after each step all ways to go on are tried, the shortest first.
pub(crate) fn lost_slowly(
    lone: &Instance,
    name: &str,
    plan: &Plan,
) -> Option<BTreeMap<(u32, u32), u32>> {
    let path = plan.path(name);
    let arrival = path.len() as u32 - 1;
    if arrival > MOST_STEPS + 3 {
        return None;
    }
    let earliest = |time: usize| {
        let charges = plan.charges(name).iter().copied();
        let charges: Vec<u32> = charges.filter(|&it| (it as usize) < time).collect();
        (time as u32..=arrival).find_map(|steps| {
            let Some(walks) = paths(lone, name, (&path[..=time], &charges), steps) else {
                return Some(None);
            };
            let passes =
                |walk: &Plan| check(lone, walk).is_valid() && arrivals(lone, walk) == [Some(steps)];
            walks.iter().any(passes).then_some(Some(steps))
        })
    };
    let mut lost = BTreeMap::new();
    let mut before: Option<(Cell, u32)> = None;
    for (time, entry) in path.iter().enumerate() {
        let Some(cell) = *entry else { continue };
        let now = earliest(time)??;
        if let Some((left, f_value)) = before
            && now > f_value
        {
            *lost.entry((left.x, left.y)).or_default() += now - f_value;
        }
        before = Some((cell, now));
    }
    Some(lost)
}

/// The heat and the places, from the rows alone.
pub(crate) fn places_are_right(answer: &DelaysAnswer, what: &str) {
    let mut heat: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for loss in answer.agents.iter().flat_map(|row| &row.lost) {
        *heat.entry((loss.cell.x, loss.cell.y)).or_default() += loss.steps;
    }
    assert_eq!(by_cell(&answer.lost), heat, "{what}");
    let mut told = BTreeSet::new();
    let mut last = u32::MAX;
    for place in &answer.places {
        let cells: Vec<(u32, u32)> = place.cells.iter().map(|it| (it.x, it.y)).collect();
        assert!(cells.iter().all(|&cell| told.insert(cell)), "{what}");
        let steps: u32 = cells.iter().map(|cell| heat[cell]).sum();
        assert_eq!(place.steps, steps, "{what}");
        assert!(steps <= last, "{what}");
        last = steps;
        let agents: u32 = place.agents.iter().map(|loss| loss.steps).sum();
        assert_eq!(agents, steps, "{what}");
        let (first, end) = (cells[0], cells[cells.len() - 1]);
        let in_row = first.1 == end.1;
        let in_column = first.0 == end.0;
        assert!(in_row || in_column, "{what}");
        assert_eq!(
            (end.0 - first.0 + end.1 - first.1) as usize + 1,
            cells.len(),
            "{what}"
        );
        // It is a longest one: what lies before and behind it is not lost.
        let across = (first.0.wrapping_sub(1), first.1);
        let behind = (end.0 + 1, end.1);
        let is_row = in_row && !heat.contains_key(&across) && !heat.contains_key(&behind);
        let above = (first.0, first.1.wrapping_sub(1));
        let below = (end.0, end.1 + 1);
        let is_column = in_column && !heat.contains_key(&above) && !heat.contains_key(&below);
        assert!(is_row || is_column, "{what}");
    }
    assert_eq!(answer.places.is_empty(), answer.delay == 0, "{what}");
}
