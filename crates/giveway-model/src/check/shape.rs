//! Plans that are none: agents missing or unknown, paths and lists of times
//! that cannot be read as such.

use super::findings::{Findings, Place};
use super::{Rule, sentence};
use crate::{Cell, Instance, Plan};

/// Finds what is wrong with the plan as a whole.
pub(super) fn find(instance: &Instance, plan: &Plan, findings: &mut Findings<'_>) {
    for (index, agent) in instance.agents().iter().enumerate() {
        match plan.paths.get(&agent.name) {
            None => shape(findings, index, 0, sentence::no_path(&agent.name)),
            Some(path) => find_in_path(path, index, &agent.name, findings),
        }
        find_in_charges(plan.charges(&agent.name), index, &agent.name, findings);
        // A first entry at time 0 is the default, written out.
        if plan.from.get(&agent.name).is_some_and(|&from| from > 0) {
            let message = sentence::needs_changes(&agent.name, "joins later");
            shape(findings, index, 0, message);
        }
        if plan.until.contains_key(&agent.name) {
            let message = sentence::needs_changes(&agent.name, "is removed");
            shape(findings, index, 0, message);
        }
    }
    find_strangers(instance, plan, findings);
}

fn find_in_path(path: &[Option<Cell>], index: usize, name: &str, findings: &mut Findings<'_>) {
    if path.is_empty() {
        shape(findings, index, 0, sentence::empty_path(name));
    } else if path.iter().all(Option::is_none) {
        shape(findings, index, 0, sentence::only_transit(name));
    } else {
        if let Some(None) = path.first() {
            shape(findings, index, 0, sentence::begins_in_transit(name));
        }
        if let Some(None) = path.last() {
            let time = path.len() - 1;
            shape(findings, index, time, sentence::ends_in_transit(name, time));
        }
    }
}

fn find_in_charges(times: &[u32], index: usize, name: &str, findings: &mut Findings<'_>) {
    for pair in times.windows(2) {
        if let &[before, time] = pair
            && time <= before
        {
            let message = if time == before {
                sentence::charge_repeated(name, time)
            } else {
                sentence::charges_unsorted(name, before, time)
            };
            shape(findings, index, time as usize, message);
        }
    }
}

fn find_strangers(instance: &Instance, plan: &Plan, findings: &mut Findings<'_>) {
    let mut known: Vec<&str> = instance.agents().iter().map(|a| a.name.as_str()).collect();
    known.sort_unstable();
    let parts = [
        ("a path", plan.paths.keys().collect::<Vec<_>>()),
        ("charges", plan.charges.keys().collect()),
        ("a time in \"from\"", plan.from.keys().collect()),
        ("a time in \"until\"", plan.until.keys().collect()),
    ];
    for (what, names) in parts {
        for name in names {
            if known.binary_search(&name.as_str()).is_err() {
                findings.push_stranger(name, sentence::stranger(name, what));
            }
        }
    }
}

fn shape(findings: &mut Findings<'_>, agent: usize, time: usize, message: String) {
    findings.push(Rule::Shape, time, &[agent], Place::Nowhere, message);
}
