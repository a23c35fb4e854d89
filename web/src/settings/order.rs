//! The costs of the objective, in their order.

use giveway_model::{Cost, Objective, tr};
use giveway_page::{Action, Edit, objective, words};
use yew::prelude::*;

use crate::icon;

#[derive(Clone, Copy)]
struct Given<'a> {
    objective: &'a Objective,
    send: &'a Callback<Action>,
}

/// A list to be ordered with buttons, and the costs that can be added.
pub(super) fn show(objective: &Objective, send: &Callback<Action>) -> Html {
    let given = Given { objective, send };
    let costs = objective.costs();
    let others = objective::others(objective);
    html! {
        <>
            <ol class="order">
                { for costs.iter().enumerate().map(|(at, &cost)| row(given, at, cost)) }
            </ol>
            if let Some(caution) = objective::caution(objective) { <p class="remark">{ caution }</p> }
            if !others.is_empty() {
                <div class="adds">{ for others.iter().map(|&cost| addition(given, cost)) }</div>
            }
        </>
    }
}

type Step = fn(&Objective, Cost) -> Objective;

fn press(given: Given<'_>, cost: Cost, step: Step) -> Callback<MouseEvent> {
    let objective = given.objective.clone();
    given
        .send
        .reform(move |_| Action::Edit(Edit::Objective(step(&objective, cost))))
}

fn row(given: Given<'_>, at: usize, cost: Cost) -> Html {
    let last = given.objective.costs().len() - 1;
    let title = words::title(cost);
    let button = |class: &'static str, icon: &'static str, name: String, step: Step, off: bool| {
        let class = classes!("btn", "ghost", class);
        html! {
            <button {class} title={name.clone()} disabled={off} onclick={press(given, cost, step)}>
                { icon::show(icon) }<span class="vh">{ name }</span>
            </button>
        }
    };
    html! {
        <li key={cost.name()}>
            <span class="rank">{ at + 1 }</span>
            <span class="what">{ title }</span>
            { button("up", "down", tr!("Raise {cost}", cost = title), objective::raised, at == 0) }
            { button("", "down", tr!("Lower {cost}", cost = title), objective::lowered, at == last) }
            { button("", "cancel", tr!("Remove {cost}", cost = title), objective::without, last == 0) }
        </li>
    }
}

fn addition(given: Given<'_>, cost: Cost) -> Html {
    let name = words::title(cost);
    html! {
        <button key={cost.name()} class="btn chip" title={tr!("Add {cost}", cost = name)}
            onclick={press(given, cost, objective::with)}>
            { icon::show("plus") }<span class="vh">{ tr!("before a cost" => "Add") }{ " " }</span>{ name }
        </button>
    }
}
