//! The questions that can be asked here, one press each.

use giveway_model::tr;
use giveway_page::ask::{Group, Offer};
use giveway_page::{Action, AskAction};
use yew::prelude::*;

use crate::icon;
use crate::part::keyed_part;

/// So many questions of a group are shown at first: at a cell that many robots use there are more.
const SHOWN: usize = 6;

#[derive(Clone, PartialEq, Properties)]
struct GroupProps {
    group: Group,
    send: Callback<Action>,
}

pub(super) fn show(groups: &[Group], send: &Callback<Action>) -> Html {
    let group = |group: &Group| {
        let send = send.clone();
        keyed_part::<Offers>(
            group.title.clone(),
            GroupProps {
                group: group.clone(),
                send,
            },
        )
    };
    html! { <>{ for groups.iter().map(group) }</> }
}

/// The questions of one group.
#[component]
fn Offers(props: &GroupProps) -> Html {
    let GroupProps { group, send } = props;
    let all = use_state_eq(|| false);
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
    let count = group.offers.len();
    // One question more needs no button.
    let is_cut = !*all && count > SHOWN + 1;
    let shown = if is_cut { SHOWN } else { count };
    let more = {
        let all = all.clone();
        move |_| all.set(true)
    };
    html! {
        <section>
            <h3>{ group.title.clone() }</h3>
            <ul class="asks">{ for group.offers.iter().take(shown).map(offer) }</ul>
            if is_cut {
                <button type="button" class="btn outline more" onclick={more}>{ tr!("All {count} questions", count) }</button>
            }
        </section>
    }
}
