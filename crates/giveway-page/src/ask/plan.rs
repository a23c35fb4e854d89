//! Questions about the plan as a whole, or about there being none.

use giveway_model::{Cost, Question, tr};
use giveway_solve::Status;

use super::{About, Group, Offer};
use crate::{Answer, words};

pub(super) fn groups(answer: &Answer) -> Vec<Group> {
    let Some(costs) = answer.solved.costs else {
        return Vec::new();
    };
    let scene = answer.draft.scene();
    let asked = answer.request.objective.as_ref();
    let objective = asked.unwrap_or(&scene.objective);
    let proved = |cost: Cost| answer.solved.bounds.get(&cost) == Some(&costs.get(cost));
    let mut offers = Vec::new();
    for &cost in objective.costs() {
        let (icon, question) = of_cost(cost);
        let value = costs.get(cost);
        if value == 0 {
            continue;
        }
        let detail = if proved(cost) {
            tr!("{cost} {value}, proved", cost = words::name(cost), value)
        } else {
            format!("{} {value}", words::name(cost))
        };
        offers.push(Offer::new(icon, question).with(detail));
    }
    if answer.solved.status != Status::Optimal {
        offers.push(Offer::new("question", Question::Plan));
    }
    vec![Group {
        title: tr!("Ask about the plan").to_owned(),
        offers,
        about: About::Plan,
    }]
}

/// The question why a cost is not less, with its icon.
pub(super) const fn of_cost(cost: Cost) -> (&'static str, Question) {
    match cost {
        Cost::Makespan => ("clock", Question::Makespan),
        Cost::SumOfCosts => ("clock", Question::SumOfCosts),
        Cost::Charges => ("charger", Question::Charges { agent: None }),
        Cost::Moves => ("trail", Question::Moves { agent: None }),
        Cost::Waits => ("pause", Question::Waits { agent: None }),
        Cost::Penalty => ("warning", Question::Penalty),
    }
}

/// Where there is no plan, that is the question.
pub(super) fn without(answer: &Answer) -> Vec<Group> {
    if answer.solved.status != Status::Impossible {
        return Vec::new();
    }
    vec![Group {
        title: tr!("Ask").to_owned(),
        offers: vec![Offer::new("question", Question::Unsolvable)],
        about: About::Plan,
    }]
}
