//! The costs of the objective, in their order.

use giveway_model::{Cost, Objective};
use giveway_page::{Action, objective, words};
use yew::prelude::*;

use crate::Icon;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct OrderProps {
    /// The objective.
    pub(super) objective: Objective,
    /// Takes another one.
    pub(super) send: Callback<Action>,
}

/// A list to be ordered with buttons, and the costs that can be added.
#[component]
pub(super) fn Order(props: &OrderProps) -> Html {
    let costs = props.objective.costs();
    let others = objective::others(&props.objective);
    html! {
        <>
            <ol class="order">
                { for costs.iter().enumerate().map(|(at, &cost)| row(props, at, cost)) }
            </ol>
            if !others.is_empty() {
                <div class="adds">{ for others.iter().map(|&cost| addition(props, cost)) }</div>
            }
        </>
    }
}

type Step = fn(&Objective, Cost) -> Objective;

fn press(props: &OrderProps, cost: Cost, step: Step) -> Callback<MouseEvent> {
    let objective = props.objective.clone();
    props
        .send
        .reform(move |_| Action::SetObjective(step(&objective, cost)))
}

fn row(props: &OrderProps, at: usize, cost: Cost) -> Html {
    let last = props.objective.costs().len() - 1;
    let title = words::title(cost);
    let button = |class: &'static str, icon: &'static str, verb: &str, step: Step, off: bool| {
        let name = format!("{verb} {title}");
        let class = classes!("btn", "ghost", class);
        html! {
            <button {class} title={name.clone()} disabled={off} onclick={press(props, cost, step)}>
                <Icon name={icon} /><span class="vh">{ name }</span>
            </button>
        }
    };
    html! {
        <li key={cost.name()}>
            <span class="rank">{ at + 1 }</span>
            <span class="what">{ title }</span>
            { button("up", "down", "Raise", objective::raised, at == 0) }
            { button("", "down", "Lower", objective::lowered, at == last) }
            { button("", "cancel", "Remove", objective::without, last == 0) }
        </li>
    }
}

fn addition(props: &OrderProps, cost: Cost) -> Html {
    let name = words::title(cost);
    html! {
        <button key={cost.name()} class="btn chip" title={format!("Add {name}")}
            onclick={press(props, cost, objective::with)}>
            <Icon name="plus" /><span class="vh">{ "Add " }</span>{ name }
        </button>
    }
}
