//! Robots that are to come onto the board at once: a sentence with numbers in it.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::fleet::{Card, FleetAction, MOST, MOST_WAYPOINTS};
use yew::prelude::*;

use crate::field::slot;
use crate::icon;

/// The largest battery that is typed.
const LARGEST: u32 = 9_999;

#[inline(never)]
pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    let level = card.battery.map(|battery| battery.initial);
    let capacity = card.battery.map(|battery| battery.capacity);
    let say = |action: FleetAction| act(send, action);
    html! {
        <>
            <header class="ih"><span class="cellsw">{ icon::show("many") }</span><div><h2>{ tr!("Several robots") }</h2></div></header>
            <section class="fleet" role="group" aria-label={tr!("Several robots")}>
                <p>
                    { slot(tr!("How many"), Some(card.count), (1, MOST), say_number(send, FleetAction::Count)) }
                    { tr!("several robots" => "robots along") }{ " " }<b>{ card.starts.clone() }</b>
                </p>
                <p>{ tr!("several robots" => "goals along") }{ " " }<b>{ card.goals.clone().unwrap_or_else(|| "\u{2026}".to_owned()) }</b></p>
                <p>
                    <button type="button" class="btn outline" aria-pressed={card.back.to_string()} onclick={say(FleetAction::Back(!card.back))}>
                        { icon::show(if card.back { "check" } else { "plus" }) }{ tr!("as many back") }
                    </button>
                </p>
                <p>
                    { slot(tr!("Waypoints of each"), Some(card.waypoints), (0, MOST_WAYPOINTS), say_number(send, |each| FleetAction::Waypoints(each.unwrap_or(0)))) }
                    { tr!("several robots" => "waypoints each, at random beside obstacles") }
                    if card.waypoints > 0 {
                        <button type="button" class="btn outline" onclick={say(FleetAction::DrawAgain)}>{ tr!("Draw again") }</button>
                    }
                </p>
                <p>
                    { tr!("several robots" => "battery") }{ " " }
                    { slot(tr!("Battery, steps"), capacity, (1, LARGEST), say_number(send, FleetAction::Battery)) }
                    // It is there before there is a battery, so that Tab goes from one to the other.
                    { tr!("several robots" => "starting at") }{ " " }
                    { slot(tr!("Level at the start"), level, (0, capacity.unwrap_or(LARGEST)), say_number(send, move |level| FleetAction::Level(level.or(capacity).unwrap_or(LARGEST)))) }
                </p>
                <p class="remark" role="status">{ card.told.clone() }</p>
            </section>
        </>
    }
}

#[inline(never)]
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    html! {
        <div class="foot making">
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

/// What is done with a number that was typed.
fn say_number(
    send: &Callback<Action>,
    action: impl Fn(Option<u32>) -> FleetAction + 'static,
) -> Callback<Option<u32>> {
    send.reform(move |number| Action::Fleet(action(number)))
}
