//! Plans that are worse than they need be: agents wait, go aside and come back,
//! at their goals too.

use giveway_model::check::check;
use giveway_model::{Instance, Plan};
use rand::RngExt;
use rand::seq::IndexedRandom;

use crate::random::numbers;

/// The plan with up to six detours and waits put in, as many as it stays valid
/// with.
pub fn loiter(instance: &Instance, plan: &Plan, seed: u64, number: u64) -> Plan {
    let random = &mut numbers(seed ^ 0x1017, number);
    let mut plan = plan.clone();
    for _ in 0..random.random_range(1..=6) {
        let mut longer = plan.clone();
        let names: Vec<String> = longer.paths.keys().cloned().collect();
        let Some(name) = names.choose(random) else {
            continue;
        };
        let Some(path) = longer.paths.get_mut(name) else {
            continue;
        };
        let index = random.random_range(0..path.len());
        let Some(here) = path[index] else { continue };
        let sides: Vec<_> = instance.grid().neighbours(here).collect();
        let more = match sides.choose(random) {
            Some(&side) if random.random_bool(0.6) => vec![Some(side), Some(here)],
            _ => vec![Some(here); random.random_range(1..=3)],
        };
        let by = more.len() as u32;
        path.splice(index + 1..=index, more);
        if let Some(charges) = longer.charges.get_mut(name) {
            for time in charges.iter_mut().filter(|time| **time > index as u32) {
                *time += by;
            }
        }
        longer.cut_trailing_goals(instance);
        if check(instance, &longer).is_valid() {
            plan = longer;
        }
    }
    plan
}
