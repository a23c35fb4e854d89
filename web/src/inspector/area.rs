//! A selected part of the floor: its size, what is on it, and what can be done with it.

use giveway_model::tr;
use giveway_page::area::Card;
use yew::prelude::*;

use crate::icon;

#[inline(never)]
pub(super) fn show(card: &Card) -> Html {
    let fact = |(name, text): &(&'static str, String)| html! { <div><dt>{ *name }</dt><dd>{ text.clone() }</dd></div> };
    let way = |&(name, sign, keys): &(&'static str, &'static str, &'static str)| {
        html! { <li>{ icon::show(sign) }<span>{ name }</span><kbd>{ keys }</kbd></li> }
    };
    let ways = [
        (tr!("Move"), "select", tr!("drag, arrows")),
        (tr!("Copy, paste"), "copy", "Ctrl C, V"),
        (tr!("Mirror"), "mirror-x", "h"),
        (tr!("Turn"), "turn90", "t"),
        (tr!("Repeat"), "repeat", "Ctrl D"),
        (tr!("Erase"), "erase", "Delete"),
        (tr!("All of the floor"), "marquee", "Ctrl A"),
    ];
    html! {
        <>
            <header class="ih"><span class="cellsw">{ icon::show("marquee") }</span><div><h2>{ card.size.clone() }</h2><p>{ card.place.clone() }</p></div></header>
            <dl class="facts">{ for card.facts.iter().map(fact) }</dl>
            if let Some(told) = &card.told {
                <p class={classes!("area-told", card.is_refused.then_some("refused"))}>{ told.clone() }</p>
            }
            <h3>{ tr!("With this area") }</h3>
            <ul class="area-ways">{ for ways.iter().map(way) }</ul>
        </>
    }
}
