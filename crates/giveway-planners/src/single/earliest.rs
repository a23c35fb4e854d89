//! The earliest arrival of an agent alone, where tables do not tell it: conditions are about
//! times, or something is counted on the way.
//!
//! Tables take the best case, so they only bound it from below. A* over the agent's
//! own states follows times and counts; beyond the last time that anything is
//! about all times are alike, so that there are finitely many states.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

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
    let conditions = &task.conditions;
    let in_tables = conditions.is_in_tables();
    let table = if in_tables {
        at_rest(task, terrain, cost_to_go, first)
    } else {
        cost_to_go.from(task.start, first.mask, first.battery)
    };
    let Some(bound) = table.map(|table| table.max(task.not_before)) else {
        return Ok(Err(no_plan));
    };
    let known = |arrival| {
        if arrival <= task.not_after() {
            Ok(arrival)
        } else {
            Err(no_plan)
        }
    };
    if in_tables {
        return Ok(known(bound));
    }
    let last = task.last_time().unwrap_or(0);
    if last > MOST_TIMES {
        // The tables give a lower bound, which need not be an arrival.
        let done = conditions.required.iter().map(Required::times);
        let done = done.filter(|times| !times.are_all());
        let bound = done.fold(bound, |bound, times| {
            bound.max(times.first().saturating_add(1))
        });
        return Ok(known(bound));
    }
    let mut search = Search::new(task, terrain, cost_to_go, last);
    let arrival = search.run(first, 0, budget)?;
    Ok(arrival.ok_or(no_plan).and_then(known))
}

/// The earliest arrival of an agent that is in a state at a time, whatever its conditions
/// are about; `None` where it cannot arrive from there.
///
/// It must be known that it can: the search has no other end.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn earliest_from(
    task: &Task,
    terrain: &Terrain,
    cost_to_go: &CostToGo,
    (state, now): (State, u32),
    budget: &dyn Budget,
) -> Result<Option<u32>, Stop> {
    if !task.conditions.is_in_tables() || now < task.earliest_move {
        let last = task.last_time().unwrap_or(0);
        return Search::new(task, terrain, cost_to_go, last).run(state, now, budget);
    }
    let (v, delay) = state.next_vertex(terrain);
    let rest = cost_to_go.from(v, state.mask | task.bit(v), state.battery);
    Ok(rest.map(|rest| (now + delay + rest).max(task.not_before)))
}

/// A state, and the time as far as it matters.
type Key = (Place, Mask, u32);

struct Search<'a> {
    task: &'a Task,
    terrain: &'a Terrain,
    cost_to_go: &'a CostToGo,
    /// Later times are alike.
    last: u32,
    /// When and with which level of the battery states were reached.
    reached: BTreeMap<Key, Vec<(u32, u32)>>,
    /// States by the least arrival that they allow, late ones first.
    open: BinaryHeap<Reverse<(u32, Reverse<u32>, State)>>,
}

impl<'a> Search<'a> {
    const fn new(
        task: &'a Task,
        terrain: &'a Terrain,
        cost_to_go: &'a CostToGo,
        last: u32,
    ) -> Self {
        Self {
            task,
            terrain,
            cost_to_go,
            last,
            reached: BTreeMap::new(),
            open: BinaryHeap::new(),
        }
    }

    /// The earliest arrival from a state at a time.
    fn run(&mut self, first: State, now: u32, budget: &dyn Budget) -> Result<Option<u32>, Stop> {
        self.reach(first, now);
        while let Some(Reverse((_, Reverse(now), state))) = self.open.pop() {
            budget.tick()?;
            if let Place::At(v) = state.place
                && self.task.may_end(v, state.mask, now)
            {
                return Ok(Some(now));
            }
            let mut next = Vec::new();
            let (task, terrain) = (self.task, self.terrain);
            task.onward(terrain, state, now, true, |step| next.push(step.to));
            for to in next {
                self.reach(to, now + 1);
            }
        }
        Ok(None)
    }

    fn reach(&mut self, state: State, now: u32) {
        let State {
            place,
            mask,
            battery,
        } = state;
        let (v, delay) = state.next_vertex(self.terrain);
        let mask_there = mask | self.task.bit(v);
        let Some(rest) = self.cost_to_go.from(v, mask_there, battery) else {
            return;
        };
        let arrival = (now + delay + rest).max(self.task.not_before);
        let key = (place, mask, now.min(self.last + 1));
        let known = self.reached.entry(key).or_default();
        let is_known = known
            .iter()
            .any(|&(time, fuller)| time <= now && fuller >= battery);
        if !is_known {
            known.push((now, battery));
            self.open.push(Reverse((arrival, Reverse(now), state)));
        }
    }
}
