//! The differences of the other plan in a few words.

use crate::explain::how::way;
use giveway_model::words::and;
use giveway_model::{Cost, Instance, Plan, Question, check::own_costs, tr};

/// The alternative as a clause: `A1 could wait instead`; `None` where there is nothing short to say.
pub(crate) fn instead(
    question: &Question,
    instance: &Instance,
    plan: &Plan,
    other: &Plan,
) -> Option<String> {
    let asked = question.agent();
    let changed = |name: &str| {
        plan.path(name) != other.path(name) || plan.charges(name) != other.charges(name)
    };
    let names: Vec<&str> = instance
        .agents()
        .iter()
        .map(|agent| agent.name.as_str())
        .filter(|name| changed(name))
        .collect();
    let waits = |name: &str, plan: &Plan| {
        own_costs(instance, name, plan).map_or(0, |costs| costs.get(Cost::Waits))
    };
    let waits_more = |name: &&&str| waits(name, other) > waits(name, plan);
    let others: Vec<&&str> = names.iter().filter(|name| Some(**name) != asked).collect();
    let waiting: Vec<&str> = others.iter().copied().filter(waits_more).copied().collect();
    let subject = |names: &[&str]| and(names);
    let about_waiting = matches!(
        question,
        Question::Wait { .. } | Question::Waits { .. } | Question::Yield { .. }
    );
    if about_waiting && !waiting.is_empty() && waiting.len() <= 3 {
        return Some(tr!(
            "{robots} could wait instead",
            robots = subject(&waiting)
        ));
    }
    let asked = asked.filter(|name| names.contains(name));
    match (asked, others.len()) {
        (Some(name), _) if way(plan, name) != way(other, name) => {
            Some(tr!("{name} could go another way", name))
        }
        (Some(name), 0) if plan.path(name) == other.path(name) => {
            Some(tr!("{name} could charge at another time", name))
        }
        (Some(name), 0) if waits(name, other) > 0 => Some(tr!("{name} could wait elsewhere", name)),
        (_, 1..=3) => {
            let others: Vec<&str> = others.iter().map(|name| **name).collect();
            Some(tr!(
                "{robots} could move differently",
                robots = subject(&others)
            ))
        }
        _ => None,
    }
}
