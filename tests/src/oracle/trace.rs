//! From the last label back to the first: the plan.

use std::collections::BTreeMap;

use giveway_model::{Path, Plan, Version};

use super::joint::Joint;
use super::law::Place;
use super::lone::Lone;
use super::search::Label;

/// The plan that leads to a label.
pub(crate) fn plan(joint: &Joint, labels: &[Label], end: usize) -> Plan {
    let mut moments = Vec::new();
    let mut at = Some(end);
    while let Some(number) = at {
        moments.push(joint.decode(labels[number].state));
        at = labels[number].parent;
    }
    moments.reverse();
    let mut paths = BTreeMap::new();
    let mut charges = BTreeMap::new();
    for (i, agent) in joint.agents.iter().enumerate() {
        let states: Vec<usize> = moments.iter().map(|moment| moment[i]).collect();
        let times = charge_times(agent, &states);
        if !times.is_empty() {
            charges.insert(agent.name.clone(), times);
        }
        paths.insert(agent.name.clone(), path(agent, &states));
    }
    Plan {
        giveway: Version,
        paths,
        charges,
        ..Plan::default()
    }
}

/// The cells up to the arrival.
fn path(agent: &Lone, states: &[usize]) -> Path {
    let mut path = Path::new();
    for &state in states {
        path.push(agent.occupies(state));
        if matches!(agent.states[state].place, Place::Arrived(_)) {
            break;
        }
    }
    path
}

/// The times at which the agent charges. Between two states there can be two
/// steps that differ in a charge only where the second is the arrival, after
/// which no level matters: the charge is needless there, if it can be left out.
fn charge_times(agent: &Lone, states: &[usize]) -> Vec<u32> {
    let mut times = Vec::new();
    for (time, (from, to)) in (0_u32..).zip(states.iter().zip(states.iter().skip(1))) {
        let between = agent.steps[*from].iter().filter(|step| step.to == *to);
        if between.map(|step| step.price.charges).min() == Some(1) {
            times.push(time);
        }
    }
    times
}
