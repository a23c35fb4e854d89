//! The robots in an order, which is tried as a whole.

use giveway_course::learner::Action;
use giveway_model::tr;
use yew::prelude::*;

use super::super::prose::Reader;
use super::super::tutor::{Msg, Tutor};
use crate::icon;

impl Tutor {
    /// The robots in the order that is tried next: that of the scene at first.
    pub(in super::super) fn order(&self) -> Vec<String> {
        let Some(open) = &self.learner.open else {
            return Vec::new();
        };
        let agents = &open.scene().agents;
        let is_whole = agents.len() == self.order.len()
            && agents.iter().all(|agent| self.order.contains(&agent.name));
        if is_whole {
            return self.order.clone();
        }
        agents.iter().map(|agent| agent.name.clone()).collect()
    }
}

pub(super) fn show(order: &[String], reader: Reader<'_>) -> Html {
    let last = order.len().saturating_sub(1);
    let row = |(place, name): (usize, &String)| {
        let button = |to: Option<usize>, class: &'static str, word: String| {
            let onclick = reader
                .send
                .reform(move |_: MouseEvent| Msg::Move(place, to.unwrap_or(place)));
            html! {
                <button type="button" class={classes!("btn", "ghost", "round", class)} disabled={to.is_none()} {onclick}
                    title={word.clone()}>
                    { icon::show("down") }<span class="vh">{ word }</span>
                </button>
            }
        };
        html! {
            <li key={name.clone()}>
                <b class="no" aria-hidden="true">{ place + 1 }</b>
                { reader.robot(name) }
                <span class="grow"></span>
                { button(place.checked_sub(1), "up", tr!("{name} earlier", name)) }
                { button((place < last).then_some(place + 1), "later", tr!("{name} later", name)) }
            </li>
        }
    };
    let tried = order.to_vec();
    let go = reader
        .send
        .reform(move |_: MouseEvent| Msg::Do(Action::Order(tried.clone())));
    let none = reader.send.reform(|_: MouseEvent| Msg::Do(Action::NoOrder));
    html! {
        <>
            <ol class="queue" aria-label={tr!("Order of planning")}>{ for order.iter().enumerate().map(row) }</ol>
            <div class="exa">
                <button type="button" class="btn outline" onclick={go}>{ icon::show("order") }<span>{ tr!("Try this order") }</span></button>
                <button type="button" class="btn ghost" onclick={none}><span>{ tr!("No order works") }</span></button>
            </div>
        </>
    }
}
