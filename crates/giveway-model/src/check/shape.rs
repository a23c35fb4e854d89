//! Plans that are none: agents missing or unknown, paths and lists of times
//! that cannot be read as such.

use super::findings::{Findings, Place};
use super::{Rule, sentence};
use crate::sorting::sort;
use crate::{Cell, Instance, Plan, tr};

/// Finds what is wrong with the plan as a whole.
pub(super) fn find(instance: &Instance, plan: &Plan, findings: &mut Findings<'_>) {
    for (index, agent) in instance.agents().iter().enumerate() {
        match plan.paths.get(&agent.name) {
            None => push(findings, index, 0, sentence::no_path(&agent.name)),
            Some(path) => {
                let in_transit = instance.start_state(&agent.name).transit_from.is_some();
                // (Where it is at first is looked at with its ends.)
                let (path, from) = match path.split_first() {
                    Some((None, rest)) if in_transit => (rest, 1),
                    _ => (path.as_slice(), 0),
                };
                find_in_path(path, index, &agent.name, (from, End::Arrives), findings);
            }
        }
        find_in_charges(plan.charges(&agent.name), index, &agent.name, findings);
        // A first entry at time 0 is the default, written out.
        if plan.from.get(&agent.name).is_some_and(|&from| from > 0) {
            let message =
                sentence::needs_changes(&agent.name, tr!("in this plan a robot" => "joins later"));
            push(findings, index, 0, message);
        }
        if plan.until.contains_key(&agent.name) {
            let message =
                sentence::needs_changes(&agent.name, tr!("in this plan a robot" => "is removed"));
            push(findings, index, 0, message);
        }
        if plan.slept.contains_key(&agent.name) {
            let message = sentence::needs_changes(
                &agent.name,
                tr!("in this plan a robot" => "is woken by a change"),
            );
            push(findings, index, 0, message);
        }
    }
    let names = instance.agents().iter().map(|a| a.name.as_str()).collect();
    find_strangers(names, plan, findings);
}

/// How a path ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// At the arrival.
    Arrives,
    /// Wherever the agent was when it was removed.
    Gone,
}

/// Finds what is wrong with a list of cells that begins at a time.
pub(super) fn find_in_path(
    path: &[Option<Cell>],
    index: usize,
    name: &str,
    (from, end): (u32, End),
    findings: &mut Findings<'_>,
) {
    if path.is_empty() && end == End::Gone {
        // It was removed at the very time at which it would have begun.
    } else if path.is_empty() {
        push(findings, index, from, sentence::empty_path(name));
    } else if path.iter().all(Option::is_none) {
        push(findings, index, from, sentence::only_transit(name));
    } else {
        if let Some(None) = path.first() {
            push(
                findings,
                index,
                from,
                sentence::begins_in_transit(name, from),
            );
        }
        if let Some(None) = path.last()
            && end == End::Arrives
        {
            let time = from + path.len() as u32 - 1;
            push(
                findings,
                index,
                time,
                sentence::ends_in_transit(name, time as usize),
            );
        }
    }
}

/// Finds what is wrong with a list of charges.
pub(super) fn find_in_charges(
    times: &[u32],
    index: usize,
    name: &str,
    findings: &mut Findings<'_>,
) {
    for pair in times.windows(2) {
        if let &[before, time] = pair
            && time <= before
        {
            let message = if time == before {
                sentence::charge_repeated(name, time)
            } else {
                sentence::charges_unsorted(name, before, time)
            };
            push(findings, index, time, message);
        }
    }
}

/// Finds the names in a plan that no agent has.
pub(super) fn find_strangers(mut known: Vec<&str>, plan: &Plan, findings: &mut Findings<'_>) {
    sort(&mut known);
    let parts = [
        (
            tr!("the plan has" => "a path"),
            plan.paths.keys().collect::<Vec<_>>(),
        ),
        (
            tr!("the plan has" => "charges"),
            plan.charges.keys().collect(),
        ),
        (
            tr!("the plan has" => "a time in \"from\""),
            plan.from.keys().collect(),
        ),
        (
            tr!("the plan has" => "a time in \"until\""),
            plan.until.keys().collect(),
        ),
        (
            tr!("the plan has" => "a time in \"slept\""),
            plan.slept.keys().collect(),
        ),
    ];
    for (what, names) in parts {
        for name in names {
            if known.binary_search(&name.as_str()).is_err() {
                findings.push_stranger(name, sentence::stranger(name, what));
            }
        }
    }
}

/// Notes a fault of an agent's path or times.
pub(super) fn push(findings: &mut Findings<'_>, agent: usize, time: u32, message: String) {
    let time = time as usize;
    findings.push(Rule::Shape, time, &[agent], Place::Nowhere, message);
}
