//! All links of a plan as a table: who is in which cell after whom, with how much slack.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::order::{LinkRow, Links, OrderAction};
use yew::prelude::*;

use super::{act, robot};
use crate::icon;

/// The table, below the way back.
#[inline(never)]
pub(super) fn table(back: &str, links: &Links, send: &Callback<Action>) -> Html {
    html! {
        <>
            <header class="qh">
                <button type="button" class="crumb" onclick={act(send, OrderAction::Links(false))}>{ icon::show("back") }{ back.to_owned() }</button>
                <h2>{ tr!("All links") }</h2>
                <p class="lead">{ links.lead.clone() }</p>
            </header>
            <table class="compare by-order all-links" aria-label={tr!("All links")}>
                <thead><tr>
                    <th scope="col">{ tr!("who leaves" => "First") }</th><th scope="col">{ tr!("who comes" => "Then") }</th>
                    <th scope="col">{ tr!("Cell") }</th><th scope="col">{ tr!("slack") }</th>
                </tr></thead>
                <tbody>{ for links.rows.iter().map(|link| row(link, send)) }</tbody>
            </table>
            if let Some(more) = &links.more { <p class="remark">{ more.clone() }</p> }
        </>
    }
}

fn row(link: &LinkRow, send: &Callback<Action>) -> Html {
    let end = |(agent, name): &(Option<usize>, String), time: u32| {
        html! { <>{ robot(*agent, name) }{ " " }<small>{ time }</small></> }
    };
    html! {
        <tr>
            <th scope="row">{ end(&link.first, link.leaves) }</th>
            <td>{ end(&link.second, link.comes) }</td>
            <td><button type="button" class="link" onclick={act(send, OrderAction::At(link.cell))}>{ link.at.clone() }</button></td>
            <td class={classes!(link.is_tight.then_some("tight"))}>{ link.slack }</td>
        </tr>
    }
}
