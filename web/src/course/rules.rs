//! The rules of a board, by the numbers that the judge calls them by.

use giveway_course::learner::Open;
use giveway_course::lesson::Task;
use giveway_course::lesson::quantity::ValueKind;
use giveway_model::constraint::InForce;
use giveway_model::tr;
use yew::prelude::*;

/// The rules in force of the board; nothing where they are the answers to pick from.
pub(super) fn show(open: &Open) -> Html {
    let picks = |task: &Task| match task {
        Task::Predict(task) => task.answers.is_empty() && task.what.kind() == ValueKind::Rule,
        _ => false,
    };
    let rules: Vec<InForce> = open.scene().constraints_in_force().collect();
    let is_asked = open
        .step()
        .and_then(|step| step.task.as_ref())
        .is_some_and(picks);
    if rules.is_empty() || is_asked {
        return Html::default();
    }
    let row = |rule: InForce| {
        let number = tr!("Rule {n}", n = rule.index + 1);
        html! { <li><b>{ number }</b><span>{ rule.constraint.sentence() }</span></li> }
    };
    html! {
        <ul class="rules-here" aria-label={tr!("Rules of this board")}>{ for rules.into_iter().map(row) }</ul>
    }
}
