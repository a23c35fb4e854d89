//! The earliest arrival of an agent alone, where conditions are about times.
//!
//! Tables know no times, so they only bound it from below. Up to the last time
//! that they are about, all states are followed step by step, each with
//! its fullest battery; from there on the tables are exact.

use std::collections::BTreeMap;

use super::{CostToGo, NoPlanAlone, Place, Required, State, Task, task::Mask};
use crate::{
    budget::{Budget, MOST_TIMES, Stop},
    terrain::Terrain,
};

/// The same by the tables alone, after what it has to wait for at first.
fn at_rest(task: &Task, terrain: &Terrain, cost_to_go: &CostToGo, first: State) -> Option<u32> {
    let (v, delay) = (task.start, task.delay());
    let steps = cost_to_go.from(v, first.mask, first.battery);
    let held = task.earliest_move.saturating_sub(delay);
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
/// For conditions about very late times it is a lower bound.
///
/// # Errors
/// When the budget is spent.
pub fn earliest(
    task: &Task,
    terrain: &Terrain,
    cost_to_go: &CostToGo,
    budget: &dyn Budget,
) -> Result<Result<u32, NoPlanAlone>, Stop> {
    let no_plan = NoPlanAlone::by_exact_tables();
    let Some(first) = task.first() else {
        return Ok(Err(no_plan));
    };
    let table = at_rest(task, terrain, cost_to_go, first);
    let Some(table) = table.map(|table| table.max(task.not_before)) else {
        return Ok(Err(no_plan));
    };
    let conditions = &task.conditions;
    // Alone it has no need to wait, but for a breakdown before its arrival.
    let arrives = task.delay() == 0 && task.is_end(task.start, first.mask);
    if !arrives {
        let delayed = (0..task.delay()).map(|_| task.first_place());
        let held = (task.delay()..=task.earliest_move).map(|_| Place::At(task.start));
        let walk: Vec<Place> = delayed.chain(held).collect();
        if !conditions.waits.iter().all(|wait| wait.is_kept(&walk)) {
            return Ok(Err(no_plan));
        }
    }
    let known = |arrival| {
        if arrival <= task.not_after() {
            Ok(arrival)
        } else {
            Err(no_plan)
        }
    };
    let Some(last) = conditions.last_time_of_ways().and(
        conditions
            .last_time_of_steps()
            .max(Some(task.earliest_move)),
    ) else {
        return Ok(known(table));
    };
    if last > MOST_TIMES {
        // The tables give a lower bound, which need not be an arrival.
        let done = conditions.required.iter().map(Required::times);
        let done = done.filter(|times| !times.are_all());
        let bound = done.fold(table, |bound, times| {
            bound.max(times.first().saturating_add(1))
        });
        return Ok(known(bound));
    }
    let runs = conditions.first_runs();
    let mut layer: BTreeMap<(Place, Mask, Vec<u32>), u32> = BTreeMap::new();
    layer.insert((first.place, first.mask, runs), first.battery);
    let mut best: Option<u32> = None;
    for now in 0..=last {
        let mut next = BTreeMap::new();
        for ((place, mask, runs), battery) in layer {
            budget.tick()?;
            let may_end = matches!(place, Place::At(v) if task.may_end(v, mask, now));
            if may_end {
                best = Some(best.map_or(now, |best| best.min(now)));
            }
            let state = State {
                place,
                mask,
                battery,
            };
            task.onward(terrain, state, now, true, |step| {
                let to = step.to;
                let Some(runs) = conditions.runs(&runs, place, to.place, now) else {
                    return;
                };
                let fullest = next.entry((to.place, to.mask, runs)).or_insert(to.battery);
                *fullest = to.battery.max(*fullest);
            });
        }
        layer = next;
    }
    for ((place, mask, _), battery) in layer {
        let (v, delay) = match place {
            Place::At(v) => (v, 0),
            Place::Along(arc) => (terrain.ends(arc).1, 1),
        };
        let rest = cost_to_go.from(v, mask | task.bit(v), battery);
        let arrival = rest.map(|rest| (last + 1 + delay + rest).max(task.not_before));
        best = best.into_iter().chain(arrival).min();
    }
    Ok(best.ok_or(no_plan).and_then(known))
}
