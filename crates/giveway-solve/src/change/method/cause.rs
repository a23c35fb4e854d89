//! Why a method leaves no plan, or why agents had to be freed.

use std::collections::BTreeSet;

use giveway_model::Cell;

use crate::change::{Cause, CauseKind, keep::MethodRefusal, method_case::MethodCase};

pub(super) fn cause_of(case: &MethodCase<'_, '_>, agent: usize, fault: MethodRefusal) -> Cause {
    let name = case.name(agent);
    Cause {
        agent: name.to_owned(),
        kind: fault.kind,
        cell: fault.cell,
        agents: Vec::new(),
        within: None,
        method: case.method,
        held: Vec::new(),
        has_batteries: false,
        rule: fault.rule.and_then(|rule| case.told_rule(rule)),
    }
}

/// Agents that block each other, and where the first of them first meets
/// another of them if nobody waits.
pub(super) fn blocked(
    case: &MethodCase<'_, '_>,
    agents: &[usize],
    freed: &BTreeSet<usize>,
    within: Option<u32>,
) -> Cause {
    let names: Vec<String> = agents.iter().map(|&it| case.name(it).to_owned()).collect();
    let paths = agents
        .iter()
        .filter_map(|&it| Some(case.agent(it)?.1.cells()));
    let paths: Vec<Vec<Cell>> = paths.collect();
    let cell = paths.split_first().and_then(|(first, others)| {
        let met = |cell: &&Cell| others.iter().any(|path| path.contains(cell));
        first.iter().find(met).copied()
    });
    let agent = names.first().cloned().unwrap_or_default();
    let held = case.held(freed).into_iter();
    let held = held.filter(|it| agents.contains(it));
    let held = held.map(|it| case.name(it).to_owned()).collect();
    let has_batteries = agents
        .iter()
        .filter_map(|&agent| case.agent(agent))
        .any(|(agent, _)| agent.battery.is_some());
    let rule = case.blocking_rule(freed);
    Cause {
        agent,
        kind: CauseKind::Blocked,
        cell,
        agents: names,
        within,
        method: case.method,
        held,
        has_batteries,
        rule: rule.and_then(|rule| case.told_rule(rule)),
    }
}
