//! The rules of a scene's own that keep an agent from its task, even alone.

use std::collections::BTreeSet;

use giveway_model::{Constraint, Instance, sorting::set};

use crate::{
    budget::Budget,
    problem::{Problem, ProblemError},
};

/// More rules of one agent than so many are not left out one by one.
const MOST_RULES: usize = 64;

/// The rules without which an agent could do its task alone, by its number: a minimal set, by
/// deletion. Empty where it could not without rules, either, or the budget is spent.
pub(crate) fn shut_in_by(instance: &Instance, agent: usize, budget: &Budget) -> Vec<Constraint> {
    let core = core_of(instance, agent, budget).unwrap_or_default();
    let rules = instance.constraints().iter().enumerate();
    let rules = rules.filter(|(index, _)| core.contains(index));
    rules.map(|(_, rule)| rule.clone()).collect()
}

fn core_of(instance: &Instance, agent: usize, budget: &Budget) -> Option<BTreeSet<usize>> {
    let name = &instance.agents().get(agent)?.name;
    let alone = instance.alone(name)?;
    let mut core: BTreeSet<usize> = set(alone.constraints_in_force().map(|rule| rule.index));
    if core.is_empty() || core.len() > MOST_RULES {
        return None;
    }
    let could_with = |rules: &BTreeSet<usize>| {
        let mut variant = alone.clone();
        variant.switch_off(|rule| !rules.contains(&rule));
        match Problem::new(&variant, budget) {
            Ok(_) => Some(true),
            Err(ProblemError::Alone(..)) => Some(false),
            Err(ProblemError::TooManyWaypoints(_) | ProblemError::Stopped(_)) => None,
        }
    };
    // A rule that names another agent, too, is not in force for one alone.
    if could_with(&core)? || !could_with(&BTreeSet::new())? {
        return None;
    }
    for rule in core.clone() {
        core.remove(&rule);
        if could_with(&core)? {
            core.insert(rule);
        }
    }
    Some(core)
}
