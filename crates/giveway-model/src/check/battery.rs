//! Batteries, simulated step by step.

use super::charges::may_charge;
use super::findings::{Findings, Place};
use super::walk::Walk;
use super::{Rule, sentence};
use crate::sorting::sort;
use crate::{Battery, Instance, Plan};

/// The battery level of an agent at each time from 0 to its arrival.
///
/// Levels may be negative: the plan then is none. Charges that are not allowed
/// count for nothing. The list is empty for an agent without a battery or
/// without a path.
///
/// ```
/// use giveway_model::{check::levels, format::native};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": ["+.."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0],
///                  "battery": { "capacity": 5, "initial": 1 } }]
/// }"#).unwrap();
/// let plan = native::read_plan(r#"{
///     "giveway": 1,
///     "paths": { "A1": [[0, 0], [1, 0], [2, 0]] },
///     "charges": { "A1": [0] }
/// }"#).unwrap();
/// assert_eq!(levels(&instance, 0, &plan), [1, 5, 4]);
/// ```
pub fn levels(instance: &Instance, agent: usize, plan: &Plan) -> Vec<i64> {
    let Some(walk) = Walk::of(instance, agent, plan) else {
        return Vec::new();
    };
    let Some(battery) = walk.agent.battery else {
        return Vec::new();
    };
    simulate(instance, &walk, battery)
}

fn simulate(instance: &Instance, walk: &Walk<'_>, battery: Battery) -> Vec<i64> {
    let mut charges: Vec<usize> = walk.charges.iter().map(|&t| t as usize).collect();
    sort(&mut charges);
    charges.dedup();
    let mut charges = charges.into_iter().peekable();
    let mut level = i64::from(battery.initial);
    let mut levels = Vec::with_capacity(walk.path.len());
    levels.push(level);
    for time in 0..walk.arrival() {
        let chosen = charges.next_if_eq(&time).is_some();
        if chosen && may_charge(instance.grid(), walk, time).is_ok() {
            level = i64::from(battery.capacity);
        } else {
            level -= 1;
        }
        levels.push(level);
    }
    levels
}

/// Finds the first time of each stretch below the floor.
pub(super) fn find(instance: &Instance, walk: &Walk<'_>, findings: &mut Findings<'_>) {
    let Some(battery) = walk.agent.battery else {
        return;
    };
    // An agent that arrived before time 0 and stays uses no battery.
    if walk.arrival() == 0 && instance.start_state(&walk.agent.name).rested > 0 {
        return;
    }
    let floor = i64::from(instance.rules().battery_floor);
    let mut was_below = false;
    for (time, level) in simulate(instance, walk, battery).into_iter().enumerate() {
        let below = level < floor;
        if below && !was_below {
            let message = sentence::battery(&walk.agent.name, level, floor, time);
            let place = walk.at(time).map_or(Place::Nowhere, Place::Cell);
            findings.push(Rule::Battery, time, &[walk.index], place, message);
        }
        was_below = below;
    }
}
