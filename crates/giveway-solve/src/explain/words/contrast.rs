//! The contrast of a question as a clause.

use giveway_model::{Cost, check::cost_of, condition::Clause};

use super::verdict::KnownSoFar;

/// The contrast of a question about a plan, in times and costs of the whole; `None`
/// where it has none.
pub(crate) fn contrast(telling: &KnownSoFar) -> Option<Clause> {
    let KnownSoFar {
        question,
        instance,
        plan,
        whole,
        ..
    } = *telling;
    let question = whole.question(question);
    let condition = question.condition(|agent, cost| match (agent, cost) {
        (None, cost) => Some(whole.costs_of(instance, plan)?.get(cost)),
        (Some(_), Cost::Makespan) => Some(whole.time(cost_of(instance, plan, agent, cost)?)),
        (Some(_), _) => cost_of(instance, plan, agent, cost),
    });
    Some(condition?.clause())
}
