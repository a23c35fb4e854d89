//! The questions that can be asked here, one press each.

use giveway_page::ask::{Group, Offer};
use giveway_page::{Action, AskAction};
use yew::prelude::*;

use crate::icon;

pub(super) fn show(groups: &[Group], send: &Callback<Action>) -> Html {
    let offer = |offer: &Offer| {
        let question = offer.question.clone();
        let onclick = send.reform(move |_| Action::Ask(AskAction::Ask(question.clone())));
        html! {
            <li><button type="button" class="ask" {onclick}>
                { icon::show(offer.icon) }
                <span>
                    { offer.text.clone() }
                    if let Some(detail) = &offer.detail { <small>{ detail.clone() }</small> }
                </span>
                { icon::at_end("chevron") }
            </button></li>
        }
    };
    let group = |group: &Group| {
        html! {
            <section>
                <h3>{ group.title.clone() }</h3>
                <ul class="asks">{ for group.offers.iter().map(offer) }</ul>
            </section>
        }
    };
    html! { <>{ for groups.iter().map(group) }</> }
}
