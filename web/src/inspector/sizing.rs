//! How many robots the floor bears: the sentence, how far it has come, and what follows.

use giveway_model::tr;
use giveway_page::fleet::MOST_WAYPOINTS;
use giveway_page::sizing::{
    Beside, Card, FindingRow, MOST_ROBOTS, MOST_SECONDS, Progress, SizingAction,
};
use giveway_page::{Action, State};
use yew::prelude::*;

use crate::field::slot;
use crate::icon;

/// The largest battery that is typed.
const LARGEST: u32 = 9_999;

/// The question among those about the scene: a phone has no tabs below the board.
#[inline(never)]
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    if !state.can_size() || state.document.draft.agents().is_empty() {
        return Html::default();
    }
    html! {
        <ul class="asks">
            <li><button type="button" class="ask" onclick={act(send, SizingAction::Show(true))}>
                { icon::show("many") }
                <span>{ tr!("How many robots does this floor bear?") }<small>{ tr!("more and more of them, each number solved") }</small></span>
                { icon::at_end("chevron") }
            </button></li>
        </ul>
    }
}

#[inline(never)]
pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    let capacity = card.battery.map(|battery| battery.capacity);
    let level = card.battery.map(|battery| battery.initial);
    let robots = |name, n, action: fn(u32) -> SizingAction| {
        let say = say_number(send, move |typed: Option<u32>| action(typed.unwrap_or(n)));
        slot(name, Some(n), (1, MOST_ROBOTS), say)
    };
    let seconds = card.seconds;
    html! {
        <>
            <header class="qh">
                <button type="button" class="crumb" onclick={act(send, SizingAction::Show(false))}>{ icon::show("back") }{ tr!("Whole plan") }</button>
                <h2>{ tr!("How many?") }</h2>
                <p class="lead">{ tr!("The same floor with more and more robots") }</p>
            </header>
            <section class="fleet" role="group" aria-label={tr!("Robots on this floor")}>
                <p>
                    { tr!("how many robots" => "From") }{ " " }{ robots(tr!("First number of robots"), card.from, SizingAction::From) }
                    { tr!("how many robots" => "to") }{ " " }{ robots(tr!("Last number of robots"), card.to, SizingAction::To) }
                    { robots(tr!("More each time"), card.by, SizingAction::By) }{ tr!("how many robots" => "more each time") }
                </p>
                <p><button type="button" class="btn outline" aria-pressed={card.back.to_string()} onclick={act(send, SizingAction::Back(!card.back))}>
                    { icon::show(if card.back { "check" } else { "plus" }) }{ tr!("half there, half back") }
                </button></p>
                <p>
                    { slot(tr!("Waypoints of each"), Some(card.waypoints), (0, MOST_WAYPOINTS), say_number(send, |each| SizingAction::Waypoints(each.unwrap_or(0)))) }
                    { tr!("several robots" => "waypoints each, at random beside obstacles") }
                </p>
                <p>
                    { tr!("several robots" => "battery") }{ " " }
                    { slot(tr!("Battery, steps"), capacity, (1, LARGEST), say_number(send, SizingAction::Battery)) }
                    { tr!("several robots" => "starting at") }{ " " }
                    { slot(tr!("Level at the start"), level, (0, capacity.unwrap_or(LARGEST)), say_number(send, move |level| SizingAction::Level(level.or(capacity).unwrap_or(LARGEST)))) }
                </p>
                { beside(card, send) }
                <p>
                    { tr!("how many robots" => "at most") }{ " " }
                    { slot(tr!("Seconds each"), Some(seconds), (1, MOST_SECONDS), say_number(send, move |typed| SizingAction::Seconds(typed.unwrap_or(seconds)))) }
                    { tr!("how many robots" => "s each, draw {n}", n = card.draw) }
                    <button type="button" class="btn outline" onclick={act(send, SizingAction::DrawAgain)}>{ tr!("Draw again") }</button>
                </p>
                <p class="remark">{ card.rows.clone() }</p>
                <p class="remark" role="status">{ card.told.clone() }</p>
            </section>
            if let Some(progress) = &card.progress { { coming(progress, send) } }
            if !card.says.is_empty() {
                <section>
                    <h3>{ tr!("What it says") }</h3>
                    <ul class="asks">{ for card.says.iter().map(|row| finding(row, send)) }</ul>
                </section>
            }
        </>
    }
}

/// What the floor is compared with: a list, and a charger that is pressed on the board.
fn beside(card: &Card, send: &Callback<Action>) -> Html {
    let choices: Vec<Option<Beside>> = card.choices.iter().map(|choice| choice.0).collect();
    let onchange = send.reform(move |event: Event| {
        let list: web_sys::HtmlSelectElement = event.target_unchecked_into();
        let chosen = usize::try_from(list.selected_index()).unwrap_or(0);
        Action::Sizing(SizingAction::Beside(choices.get(chosen).copied().flatten()))
    });
    html! {
        <p>
            { tr!("how many robots" => "beside it") }{ " " }
            <select class="field floors" aria-label={tr!("The floor beside it")} {onchange}>
                { for card.choices.iter().map(|(_, words, is_chosen)| html! { <option selected={*is_chosen}>{ words.clone() }</option> }) }
            </select>
            <button type="button" class="btn outline" aria-pressed={card.is_picking.to_string()} onclick={act(send, SizingAction::Pick(!card.is_picking))}>
                { icon::show("charger") }{ tr!("A charger at \u{2026}") }
            </button>
        </p>
    }
}

fn coming(progress: &Progress, send: &Callback<Action>) -> Html {
    html! {
        <div class="sized" role="status">
            <span>{ progress.text.clone() }</span>
            <button type="button" class="btn outline" onclick={act(send, SizingAction::Cancel)}>{ icon::show("stop") }{ tr!("Cancel") }</button>
            <progress value={format!("{:.3}", progress.share)} max="1"></progress>
        </div>
    }
}

fn finding(row: &FindingRow, send: &Callback<Action>) -> Html {
    let text = html! { <span>{ row.text.clone() }<small>{ row.small.clone() }</small></span> };
    html! {
        <li>
            if let Some(place) = row.place {
                <button type="button" class="ask" onclick={act(send, SizingAction::Look(Some(place)))}>{ icon::show(row.icon) }{ text }{ icon::at_end("chevron") }</button>
            } else {
                <p class="ask">{ icon::show(row.icon) }{ text }</p>
            }
        </li>
    }
}

#[inline(never)]
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    html! {
        <div class="foot making">
            if let Some(take) = &card.take {
                <button type="button" class="btn primary" onclick={act(send, SizingAction::Take)}>{ take.clone() }</button>
                <button type="button" class="btn outline" onclick={act(send, SizingAction::Look(None))}>{ tr!("Back to my robots") }</button>
            } else if let Some(solve) = &card.solve {
                <button type="button" class="btn primary" onclick={act(send, SizingAction::Solve)}>{ solve.clone() }</button>
            }
        </div>
    }
}

fn act(send: &Callback<Action>, action: SizingAction) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Sizing(action))
}

/// What is done with a number that was typed.
fn say_number(
    send: &Callback<Action>,
    action: impl Fn(Option<u32>) -> SizingAction + 'static,
) -> Callback<Option<u32>> {
    send.reform(move |number| Action::Sizing(action(number)))
}
