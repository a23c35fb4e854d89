//! The rules of a board, by the numbers that the judge calls them by.

use giveway_course::learner::Open;
use giveway_course::lesson::Task;
use giveway_course::lesson::quantity::ValueKind;
use giveway_model::{Constraint, tr};
use yew::prelude::*;

/// The rules in force of the board; nothing where they are the answers to pick from.
pub(super) fn show(open: &Open) -> Html {
    let picks = |task: &Task| match task {
        Task::Predict(task) => task.answers.is_empty() && task.what.kind() == ValueKind::Rule,
        _ => false,
    };
    let scene = open.scene();
    let rules = scene.constraints.iter().enumerate();
    let rules = rules.filter(|(place, rule)| rule.in_force(*place, &scene.agents).is_some());
    let rules: Vec<(usize, &Constraint)> = rules.collect();
    let is_asked = open
        .step()
        .and_then(|step| step.task.as_ref())
        .is_some_and(picks);
    if rules.is_empty() || is_asked {
        return Html::default();
    }
    let row = |(place, rule): (usize, &Constraint)| {
        let number = tr!("Rule {n}", n = place + 1);
        html! { <li><b>{ number }</b><span>{ rule.sentence() }</span></li> }
    };
    html! {
        <ul class="rules-here" aria-label={tr!("Rules of this board")}>{ for rules.into_iter().map(row) }</ul>
    }
}
