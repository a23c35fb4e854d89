//! The earliest arrival of an agent alone, where a demand is about times.
//!
//! Tables know no times, so they only bound it from below. Up to the last time
//! that the demand is about, all states are followed step by step, each with
//! its fullest battery; from there on the tables are exact.

use std::collections::BTreeMap;

use super::{CostToGo, Hopeless, Place, State, Task, task::Mask};
use crate::{
    budget::{Budget, Stop},
    terrain::Terrain,
};

/// Times that are followed step by step; later ones are beyond every horizon.
const MOST_TIMES: u32 = 20_000;

/// The same by the tables alone, after what it has to wait for at first.
fn at_rest(task: &Task, terrain: &Terrain, cost_to_go: &CostToGo, first: State) -> Option<u32> {
    let (v, delay) = (task.start, task.delay());
    let steps = cost_to_go.from(v, first.mask, first.battery);
    let held = task.held.saturating_sub(delay);
    if held == 0 || steps == Some(0) {
        return Some(delay + steps?);
    }
    let level = match task.reserve {
        None => 0,
        // A charge in the last of these steps.
        Some(reserve) if task.may_charge(terrain, v, None) => reserve.full,
        Some(_) => first.battery.checked_sub(held)?,
    };
    Some(delay + held + cost_to_go.from(v, first.mask, level)?)
}

/// The earliest arrival, or the proof that there is no plan whatever the horizon.
/// For a demand about very late times it is a lower bound.
///
/// # Errors
/// When the budget is spent.
pub fn earliest(
    task: &Task,
    terrain: &Terrain,
    cost_to_go: &CostToGo,
    budget: &dyn Budget,
) -> Result<Result<u32, Hopeless>, Stop> {
    let hopeless = Hopeless::by_exact_tables();
    let Some(first) = task.first() else {
        return Ok(Err(hopeless));
    };
    let table = at_rest(task, terrain, cost_to_go, first);
    let Some(table) = table.map(|table| table.max(task.not_before)) else {
        return Ok(Err(hopeless));
    };
    let demand = task.demand.as_ref();
    if let Some(demand @ &super::TaskConstraint::Wait { steps, .. }) = demand {
        // Alone it has no need to wait, but for a breakdown before its arrival.
        let arrives = task.delay() == 0 && task.is_end(task.start, first.mask);
        let held = (task.delay()..task.held).filter(|_| !arrives);
        let waits = held
            .filter(|&now| demand.counts_wait(task.start, now))
            .count();
        let hopeless = (waits > 0 && waits >= steps as usize).then_some(hopeless);
        return Ok(hopeless.map_or(Ok(table), Err));
    }
    let Some(last) = demand
        .and_then(super::TaskConstraint::last_time)
        .and(task.last_time())
    else {
        return Ok(Ok(table));
    };
    let bound = table.max(
        demand
            .and_then(super::TaskConstraint::set_from)
            .unwrap_or(0),
    );
    if task.not_after() < bound {
        return Ok(Err(hopeless));
    }
    if last > MOST_TIMES || task.not_after() < u32::MAX {
        return Ok(Ok(bound));
    }
    let mut layer: BTreeMap<(Place, Mask), u32> = BTreeMap::new();
    layer.insert((first.place, first.mask), first.battery);
    let mut best: Option<u32> = None;
    for now in 0..=last {
        let mut next = BTreeMap::new();
        for ((place, mask), battery) in layer {
            budget.tick()?;
            let is_end = matches!(place, Place::At(v) if task.is_end(v, mask));
            if is_end && now >= task.not_before {
                best = Some(best.map_or(now, |best| best.min(now)));
            }
            let state = State {
                place,
                mask,
                battery,
            };
            task.onward(terrain, state, now, true, |step| {
                let key = (step.to.place, step.to.mask);
                let fullest = next.entry(key).or_insert(step.to.battery);
                *fullest = step.to.battery.max(*fullest);
            });
        }
        layer = next;
    }
    for ((place, mask), battery) in layer {
        let (v, delay) = match place {
            Place::At(v) => (v, 0),
            Place::Along(arc) => (terrain.ends(arc).1, 1),
        };
        let rest = cost_to_go.from(v, mask | task.bit(v), battery);
        let arrival = rest.map(|rest| (last + 1 + delay + rest).max(task.not_before));
        best = best.into_iter().chain(arrival).min();
    }
    Ok(best.ok_or(hopeless))
}
