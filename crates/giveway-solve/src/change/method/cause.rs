//! Why a method leaves no plan, or why agents had to be freed.

use crate::change::{Cause, CauseKind, freed::Case, keep::Fault, words, world::Member};

pub(super) fn cause_of(case: &Case<'_, '_>, agent: usize, fault: Fault) -> Cause {
    let name = case.member(agent).map_or("", |member| member.name.as_str());
    Cause {
        agent: name.to_owned(),
        kind: fault.kind,
        cell: fault.cell,
        agents: Vec::new(),
        within: None,
        text: words::cause(case.method, name, fault.kind, fault.cell, &[], false),
    }
}

/// Agents that block each other, and where the first of them first meets
/// another of them if nobody waits.
pub(super) fn blocked(case: &Case<'_, '_>, agents: &[usize], within: Option<u32>) -> Cause {
    let members = agents.iter().filter_map(|&agent| case.member(agent));
    let names: Vec<String> = members.clone().map(|member| member.name.clone()).collect();
    let first = members.clone().next();
    let others: Vec<_> = members.skip(1).collect();
    let cell = first.and_then(|first| {
        let mut cells = first.rest.iter();
        let met = |cell: &&giveway_model::Cell| others.iter().any(|it| it.rest.contains(cell));
        cells.find(met).copied()
    });
    let agent = names.first().cloned().unwrap_or_default();
    let has_batteries = agents
        .iter()
        .filter_map(|&agent| case.member(agent))
        .any(Member::has_battery);
    let text = words::cause(
        case.method,
        &agent,
        CauseKind::Blocked,
        cell,
        &names,
        has_batteries,
    );
    Cause {
        agent,
        kind: CauseKind::Blocked,
        cell,
        agents: names,
        within,
        text,
    }
}
