//! Questions why something is not less where it is 0 already.

use super::{Question, so};
use crate::check::{self, Walk};
use crate::condition::moves;
use crate::{Cost, Instance, Plan, tr};

/// The sentence that nothing could be less than the count that is asked about, where that is so.
pub(super) fn already_least(
    question: &Question,
    instance: &Instance,
    plan: &Plan,
) -> Option<String> {
    let total = |cost| check::costs(instance, plan).is_some_and(|costs| costs.get(cost) == 0);
    let of = |name: &str| Walk::named(instance, name, plan);
    let still = |name: &str| Some(moves(instance, &of(name)?) == 0);
    let (is_least, what) = match question {
        Question::Waits { agent: Some(name) } => (
            so::waits(instance, &of(name)?).is_empty(),
            tr!("{name} never waits in this plan.", name),
        ),
        Question::Charges { agent: Some(name) } => (
            of(name)?.charges.is_empty(),
            tr!("{name} never charges in this plan.", name),
        ),
        Question::Moves { agent: Some(name) } | Question::Length { agent: name, .. } => (
            still(name)?,
            tr!("{name} does not move in this plan.", name),
        ),
        Question::Arrival { agent } => (
            of(agent)?.arrival() == 0,
            tr!("{agent} arrives at time 0.", agent),
        ),
        Question::Waits { agent: None } => (
            total(Cost::Waits),
            tr!("No robot waits in this plan.").to_owned(),
        ),
        Question::Charges { agent: None } => (
            total(Cost::Charges),
            tr!("No robot charges in this plan.").to_owned(),
        ),
        Question::Moves { agent: None } => (
            total(Cost::Moves),
            tr!("No robot moves in this plan.").to_owned(),
        ),
        Question::Makespan => (
            total(Cost::Makespan),
            tr!("All robots arrive at time 0.").to_owned(),
        ),
        Question::SumOfCosts => (
            total(Cost::SumOfCosts),
            tr!("All robots arrive at time 0.").to_owned(),
        ),
        Question::Penalty => (
            total(Cost::Penalty),
            tr!("This plan pays no penalty.").to_owned(),
        ),
        Question::Wait { .. }
        | Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Slow { .. }
        | Question::Order { .. }
        | Question::Yield { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => return None,
    };
    is_least.then_some(what)
}
