//! Robots that are to come onto the board at once: a sentence with numbers in it.

use giveway_model::tr;
use giveway_page::fleet::{Card, FleetAction, MOST, MOST_WAYPOINTS};
use giveway_page::{Action, number};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use crate::icon;

/// The largest battery that is typed.
const LARGEST: u32 = 9_999;

pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    let level = card.battery.map(|battery| battery.initial);
    let capacity = card.battery.map(|battery| battery.capacity);
    let say = |action: FleetAction| act(send, action);
    html! {
        <>
            <header class="ih"><span class="cellsw">{ icon::show("many") }</span><div><h2>{ tr!("Several robots") }</h2></div></header>
            <section class="fleet" role="group" aria-label={tr!("Several robots")}>
                <p>
                    { field(tr!("How many"), Some(card.count), (1, MOST), send, FleetAction::Count) }
                    { tr!("several robots" => "robots along") }{ " " }<b>{ card.starts.clone() }</b>
                </p>
                <p>{ tr!("several robots" => "goals along") }{ " " }<b>{ card.goals.clone().unwrap_or_else(|| "\u{2026}".to_owned()) }</b></p>
                <p>
                    <button type="button" class="btn outline" aria-pressed={card.back.to_string()} onclick={say(FleetAction::Back(!card.back))}>
                        { icon::show(if card.back { "check" } else { "plus" }) }{ tr!("as many back") }
                    </button>
                </p>
                <p>
                    { field(tr!("Waypoints of each"), Some(card.waypoints), (0, MOST_WAYPOINTS), send, |each| FleetAction::Waypoints(each.unwrap_or(0))) }
                    { tr!("several robots" => "waypoints each, at random beside obstacles") }
                    if card.waypoints > 0 {
                        <button type="button" class="btn outline" onclick={say(FleetAction::DrawAgain)}>{ tr!("Draw again") }</button>
                    }
                </p>
                <p>
                    { tr!("several robots" => "battery") }{ " " }
                    { field(tr!("Battery, steps"), capacity, (1, LARGEST), send, FleetAction::Battery) }
                    if let Some(capacity) = capacity {
                        { tr!("several robots" => "starting at") }{ " " }
                        { field(tr!("Level at the start"), level, (0, capacity), send, move |level| FleetAction::Level(level.unwrap_or(capacity))) }
                    }
                </p>
                <p class="remark" role="status">{ card.told.clone() }</p>
            </section>
        </>
    }
}

pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    html! {
        <div class="foot">
            if let Some(add) = &card.add {
                <button type="button" class="btn primary" onclick={act(send, FleetAction::Add)}>{ add.clone() }</button>
            }
            <button type="button" class="btn outline" onclick={act(send, FleetAction::Cancel)}>{ tr!("Cancel") }</button>
        </div>
    }
}

fn act(send: &Callback<Action>, action: FleetAction) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Fleet(action))
}

/// A number in the sentence; an empty field is none.
fn field(
    name: &'static str,
    value: Option<u32>,
    range: (u32, u32),
    send: &Callback<Action>,
    action: impl Fn(Option<u32>) -> FleetAction + 'static,
) -> Html {
    let shown = value.map(|n| n.to_string()).unwrap_or_default();
    let (send, before) = (send.clone(), shown.clone());
    let onchange = Callback::from(move |event: Event| {
        let input: HtmlInputElement = event.target_unchecked_into();
        let typed = input.value();
        let number = number::read(&typed, range);
        if number.is_some() || typed.trim().is_empty() {
            send.emit(Action::Fleet(action(number)));
        } else {
            input.set_value(&before);
        }
    });
    html! {
        <input class="num1" type="text" inputmode="numeric" autocomplete="off" aria-label={name}
            title={number::possible(range)} placeholder={tr!("several robots" => "none")} value={shown} {onchange} />
    }
}
