//! Visits that all best plans share, and for how long agents can stand still.

use std::collections::BTreeMap;

use giveway_model::{Cell, Instance, Plan};
use giveway_solve::freedom::{FreedomAnswer, Hold, Known, Later, Slack, Visit};

use super::at;
use crate::oracle::{Every, Where, is_legal};
use crate::recount;

fn known(said: Known, is_so: bool) -> bool {
    said == if is_so { Known::Yes } else { Known::No }
}

pub(super) fn backbone(
    instance: &Instance,
    plan: &Plan,
    every: &Every,
    answer: &FreedomAnswer,
) -> Vec<String> {
    let mut faults = Vec::new();
    let none = BTreeMap::new();
    let backbone = answer.backbone.as_ref().unwrap_or(&none);
    for (i, agent) in instance.agents().iter().enumerate() {
        let empty: Vec<Visit> = Vec::new();
        let visits = backbone.get(&agent.name).unwrap_or(&empty);
        let path = plan.path(&agent.name);
        let cells: Vec<Option<Cell>> = visits.iter().map(|visit| visit.cell).collect();
        if cells != path {
            faults.push(format!("{} is at {cells:?}, not {path:?}", agent.name));
        }
        for visit in visits {
            let time = visit.time as usize;
            let here = at(path, time).unwrap_or(Where::Gone);
            let number = every.visits(i, time).get(&here).copied().unwrap_or(0);
            let mut right = known(visit.always, number == every.count());
            right &= known(visit.only, number == 1);
            let charges = plan.charges(&agent.name).contains(&visit.time);
            right &= visit.charge.is_some() == charges;
            if let Some(charge) = visit.charge {
                let number = every.charges(i, time);
                right &= known(charge.always, number == every.count());
                right &= known(charge.only, number == 1);
            }
            if !right {
                let all = every.count();
                faults.push(format!("{}: {visit:?} in {number} of {all}", agent.name));
            }
        }
    }
    faults
}

pub(super) fn slack(
    instance: &Instance,
    plan: &Plan,
    every: &Every,
    answer: &FreedomAnswer,
) -> Vec<String> {
    let mut faults = Vec::new();
    let none = BTreeMap::new();
    let slacks = answer.slack.as_ref().unwrap_or(&none);
    for (i, agent) in instance.agents().iter().enumerate() {
        let now = plan.path(&agent.name).len() as u32 - 1;
        let later = every.latest_arrival(i) - now;
        let holds = holds(instance, plan, &agent.name);
        let expected = Slack {
            arrival: Later::Exactly(later),
            hold: holds,
        };
        let said = slacks.get(&agent.name);
        if said != Some(&expected) {
            faults.push(format!("{}: {said:?}, not {expected:?}", agent.name));
        }
    }
    faults
}

/// For how long an agent can stand still at each time, by trying.
fn holds(instance: &Instance, plan: &Plan, name: &str) -> Vec<Hold> {
    let first = instance.objective().costs()[0];
    let most = recount::costs(plan).get(first);
    let path = plan.path(name).to_vec();
    // By then everybody has arrived; and longer than any battery lasts.
    let long = plan.paths.values().map(Vec::len).max().unwrap_or(0) as u32 + 25;
    let mut holds = Vec::new();
    for time in 0..path.len() - 1 {
        let Some(here) = path[time] else {
            holds.push(Hold::InTransit);
            continue;
        };
        let passes = |steps: u32| {
            let mut later = plan.clone();
            let mut moved: Vec<Option<Cell>> = path[..time].to_vec();
            moved.extend((0..steps).map(|_| Some(here)));
            moved.extend(&path[time..]);
            later.paths.insert(name.to_owned(), moved);
            let charges = plan.charges(name);
            [0, steps].into_iter().any(|at_once| {
                let each = charges.iter().map(|&at| match at.cmp(&(time as u32)) {
                    std::cmp::Ordering::Less => at,
                    std::cmp::Ordering::Equal => at + at_once,
                    std::cmp::Ordering::Greater => at + steps,
                });
                let mut later = later.clone();
                later.charges.insert(name.to_owned(), each.collect());
                recount::costs(&later).get(first) <= most && is_legal(instance, &later)
            })
        };
        let steps = (1..=long).take_while(|&steps| passes(steps)).count() as u32;
        holds.push(if steps == long {
            Hold::Unlimited
        } else {
            Hold::Steps(steps)
        });
    }
    holds
}
