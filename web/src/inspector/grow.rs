//! The size of the floor: rows and columns at its four sides, and what would be lost.

use giveway_model::tr;
use giveway_page::grow::{Card, GrowAction, LineOffer, Side, offers};
use giveway_page::{Action, Lost, MAX_SIDE, number};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use crate::{Shown, icon};

#[inline(never)]
pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    let side = |&side: &Side| {
        let sides = card.sides.as_ref();
        sides.map(|&sides| stepper(side, side.of(sides), send))
    };
    let way = |lost: Lost, name: &'static str| {
        let onchange = act(send, GrowAction::Lost(lost));
        let onchange = Callback::from(move |_: Event| onchange.emit(()));
        html! { <label class="choice"><input type="radio" name="lost" checked={card.lost == Some(lost)} {onchange} /><span>{ name }</span></label> }
    };
    html! {
        <>
            <header class="ih"><span class="cellsw">{ icon::show("grow") }</span><div><h2>{ tr!("Size of the floor") }</h2>if card.sides.is_some() { <p>{ tr!("Drag a side, or count rows and columns") }</p> }</div></header>
            <div class="growth" role="group" aria-label={tr!("Size of the floor")}>
                { for Side::ALL.iter().filter_map(side) }
                <output role="status"><s>{ card.before.clone() }</s><b>{ card.after.clone() }</b></output>
            </div>
            if card.losses.is_empty() {
                <p class="remark">{ tr!("Nothing is lost.") }</p>
            } else {
                <section>
                    <h3>{ tr!("What would be lost") }</h3>
                    <ul class="losses">{ for card.losses.iter().map(|loss| html! { <li>{ loss.clone() }</li> }) }</ul>
                </section>
            }
            if card.lost.is_some() {
                <fieldset class="lost-ways">
                    <legend>{ tr!("What robots have there") }</legend>
                    { way(Lost::Move, tr!("Move it to the nearest free cell")) }
                    { way(Lost::Remove, tr!("Remove these robots and waypoints")) }
                </fieldset>
            }
            if let Some(moved) = &card.moved { <p class="remark">{ moved.clone() }</p> }
        </>
    }
}

#[inline(never)]
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    let press = |action| {
        let act = act(send, action);
        Callback::from(move |_: MouseEvent| act.emit(()))
    };
    html! {
        <div class="foot making">
            if let Some(make) = &card.make {
                <button type="button" class="btn primary" onclick={press(GrowAction::Make)}>{ icon::show("check") }{ make.clone() }</button>
            }
            <button type="button" class="btn outline" onclick={press(GrowAction::Cancel)}>{ tr!("Cancel") }</button>
        </div>
    }
}

/// Columns and rows that come or go where something is selected.
pub(super) fn lines(state: &Shown, send: &Callback<Action>) -> Html {
    let offers = offers(state);
    if offers.is_empty() {
        return Html::default();
    }
    let button = |LineOffer { name, lines }: &LineOffer| {
        let sign = if lines.more > 0 { "plus" } else { "minus" };
        let act = act(send, GrowAction::Lines(*lines));
        html! {
            <button type="button" class="btn outline" onclick={move |_: MouseEvent| act.emit(())}>{ icon::show(sign) }{ name.clone() }</button>
        }
    };
    html! {
        <details class="edit">
            <summary>{ tr!("Rows and columns here") }</summary>
            <div class="edit-body">{ for offers.iter().map(button) }</div>
        </details>
    }
}

fn act(send: &Callback<Action>, action: GrowAction) -> Callback<()> {
    send.reform(move |()| Action::Grow(action))
}

/// A number of rows or columns between minus and plus.
fn stepper(side: Side, value: i32, send: &Callback<Action>) -> Html {
    let step = |by: i32, name: String, sign: &'static str| {
        let onclick = send.reform(move |_: MouseEvent| Action::Grow(GrowAction::Step(side, by)));
        html! { <button type="button" class="btn ghost round" aria-label={name} {onclick}>{ icon::show(sign) }</button> }
    };
    let typed = {
        let send = send.clone();
        Callback::from(move |event: Event| {
            let input: HtmlInputElement = event.target_unchecked_into();
            let text = input.value().replace(['\u{2212}', '\u{2013}'], "-");
            let (sign, digits) = match text.trim().strip_prefix('-') {
                Some(digits) => (-1, digits),
                None => (1, text.trim().trim_start_matches('+')),
            };
            match number::read(digits, (0, MAX_SIDE)).and_then(|n| i32::try_from(n).ok()) {
                Some(n) => send.emit(Action::Grow(GrowAction::Side(side, sign * n))),
                None => input.set_value(&shown(value)),
            }
        })
    };
    let class = format!("stepper {side:?}").to_lowercase();
    html! {
        <span class={classes!(class, (value != 0).then_some("on"))}>
            { step(-1, tr!("{side}: one less", side = side.name()), "minus") }
            <input class="num1" type="text" inputmode="numeric" autocomplete="off" aria-label={side.name()} value={shown(value)} onchange={typed} />
            { step(1, tr!("{side}: one more", side = side.name()), "plus") }
        </span>
    }
}

fn shown(value: i32) -> String {
    match value {
        ..0 => format!("\u{2212}{}", value.unsigned_abs()),
        0 => "0".to_owned(),
        1.. => format!("+{value}"),
    }
}
