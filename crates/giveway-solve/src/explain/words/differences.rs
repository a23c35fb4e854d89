//! The differences of the other plan in a few words.

use crate::explain::how::way;
use giveway_model::words::and;
use giveway_model::{Cost, Instance, Plan, Question, check::own_costs, tr};

/// So many charges of the other plan are told at most.
const MOST_CHARGES: usize = 2;

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
    if let (Question::Charge { .. }, Some(name)) = (question, asked)
        && let Some(charges) = other_charges(name, plan, other)
    {
        return Some(tr!("{name} could charge {charges} instead", name, charges));
    }
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

/// Where and when an agent charges in another plan and not in this one: `at (3, 2) at time 3`;
/// `None` where it charges nowhere else, or at too many places to be told.
pub fn other_charges(name: &str, plan: &Plan, other: &Plan) -> Option<String> {
    let path = other.path(name);
    let at = |plan: &Plan, time: u32| plan.path(name).get(time as usize).copied().flatten();
    let is_new =
        |&&time: &&u32| !plan.charges(name).contains(&time) || at(plan, time) != at(other, time);
    let times: Vec<u32> = other.charges(name).iter().filter(is_new).copied().collect();
    if times.is_empty() || times.len() > MOST_CHARGES {
        return None;
    }
    let told = times.into_iter().map(|time| {
        let cell = path.get(time as usize).copied().flatten()?;
        Some(tr!("a charge" => "at {cell} at time {time}", cell, time))
    });
    let told: Vec<String> = told.collect::<Option<_>>()?;
    let told: Vec<&str> = told.iter().map(String::as_str).collect();
    Some(and(&told))
}
