//! A selected part of the floor: its size, what is on it, and what can be done with it.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::area::{AreaAction, Card};
use yew::prelude::*;

use crate::board::copy_area;
use crate::{Shown, icon};

#[inline(never)]
pub(super) fn show(card: &Card, state: &Shown, send: &Callback<Action>) -> Html {
    let fact = |(name, text): &(&'static str, String)| html! { <div><dt>{ *name }</dt><dd>{ text.clone() }</dd></div> };
    let row = |sign: &'static str, name: &'static str, keys: &'static str| html! { <>{ icon::show(sign) }<span>{ name }</span><kbd>{ keys }</kbd></> };
    let press =
        |(name, sign, keys, action): (&'static str, &'static str, &'static str, AreaAction)| {
            let onclick = send.reform(move |_: MouseEvent| Action::Area(action));
            html! { <li><button type="button" {onclick}>{ row(sign, name, keys) }</button></li> }
        };
    let copies = {
        let (state, send) = (state.clone(), send.clone());
        Callback::from(move |_: MouseEvent| copy_area(&state, &send))
    };
    let ways = [
        (tr!("Mirror"), "mirror-x", "h", AreaAction::Mirror(true)),
        (tr!("Turn"), "turn90", "t", AreaAction::Turn),
        (tr!("Repeat"), "repeat", "Ctrl D", AreaAction::Repeat(true)),
        (tr!("Erase"), "erase", "Delete", AreaAction::Erase),
        (
            tr!("All of the floor"),
            "marquee",
            "Ctrl A",
            AreaAction::All,
        ),
    ];
    html! {
        <>
            <header class="ih"><span class="cellsw">{ icon::show("marquee") }</span><div><h2>{ card.size.clone() }</h2><p>{ card.place.clone() }</p></div></header>
            <dl class="facts">{ for card.facts.iter().map(fact) }</dl>
            if let Some(told) = &card.told {
                <p class={classes!("area-told", card.is_refused.then_some("refused"))}>{ told.clone() }</p>
            }
            <h3>{ tr!("With this area") }</h3>
            <ul class="area-ways">
                <li>{ row("select", tr!("Move"), tr!("drag, arrows")) }</li>
                <li><button type="button" onclick={copies}>{ row("copy", tr!("Copy, paste"), "Ctrl C, V") }</button></li>
                { for ways.into_iter().map(press) }
            </ul>
        </>
    }
}
