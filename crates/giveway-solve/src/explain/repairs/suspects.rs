//! Facts of which edits are tried where no set is known that excludes a plan: those about the
//! agents that an answer names, and what holds for all.

use giveway_model::{Instance, sorting::sort_by_key};

use super::super::{
    ExplainAnswer,
    group::{Group, groups},
};

/// Agents whose facts are tried.
const MOST_AGENTS: usize = 6;

/// The facts, those first that a person would change first. Agents that are `asked` about come
/// before those that lose most with each other, those who cannot all arrive (`clash`), and those
/// that another way would meet.
pub(crate) fn suspects(
    instance: &Instance,
    asked: &[usize],
    has_deadline: bool,
    (answer, clash): (&ExplainAnswer, &[String]),
) -> Vec<Group> {
    let number = |name: &String| instance.agents().iter().position(|it| it.name == *name);
    let alone = answer.alone.iter().flat_map(|bound| &bound.agents);
    let met = answer.witness.iter().flat_map(|it| &it.violation.agents);
    let mut named: Vec<usize> = Vec::new();
    let others = alone.chain(clash).chain(met).filter_map(number);
    for agent in asked.iter().copied().chain(others) {
        if named.len() < MOST_AGENTS && !named.contains(&agent) {
            named.push(agent);
        }
    }
    let mut facts = groups(instance, asked, has_deadline);
    facts.retain(|fact| match fact {
        Group::Constraint(_) | Group::Deadline | Group::Floor => true,
        Group::Task(agent)
        | Group::Waypoint(agent, _)
        | Group::Battery(agent)
        | Group::Stay(agent) => named.contains(agent),
        Group::Obstacle(_) | Group::Collision(..) | Group::Slow | Group::Breakdown(..) => false,
    });
    let place = |agent: &usize| named.iter().position(|it| it == agent);
    sort_by_key(&mut facts, |fact| {
        let first = fact.agents().first().and_then(place);
        (matches!(fact, Group::Task(_)), first)
    });
    facts
}
