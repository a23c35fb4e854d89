//! A floor plan that is turned into cells, in three steps that are all open; and what stands
//! beside the scene of one that lies under the grid.

use giveway_model::tr;
use giveway_page::floor_plan::{Card, FloorPlanAction, Row, row};
use giveway_page::number::{decimal, decimal_text};
use giveway_page::{Action, Paint, State};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use crate::field::{Slot, SlotProps};
use crate::icon;
use crate::part::part;

#[inline(never)]
pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    let say = |action: FloorPlanAction| act(send, action);
    let (left, top, wide) = card.place;
    let becomes = |paint: Paint, name: &'static str| {
        let pressed = (card.becomes == paint).to_string();
        html! { <button type="button" aria-pressed={pressed} onclick={say(FloorPlanAction::Becomes(paint))}>{ name }</button> }
    };
    html! {
        <>
            <header class="ih"><span class="cellsw">{ icon::show("picture") }</span><div><h2>{ tr!("Floor plan") }</h2><p>{ card.about.clone() }</p></div></header>
            <section class="fleet plan-steps" role="group" aria-label={tr!("Floor plan")}>
                <h3>{ tr!("Place it") }</h3>
                <p>
                    { tr!("floor plan" => "left at") }{ " " }{ field(tr!("Left edge, cells"), Some(left), (-2000.0, 2000.0), send, |n| FloorPlanAction::Left(n.unwrap_or(0.0))) }
                    { tr!("floor plan" => "top at") }{ " " }{ field(tr!("Upper edge, cells"), Some(top), (-2000.0, 2000.0), send, |n| FloorPlanAction::Top(n.unwrap_or(0.0))) }
                </p>
                <p>
                    { field(tr!("Width of the picture, cells"), Some(wide), (1.0, 2000.0), send, move |n| FloorPlanAction::Wide(n.unwrap_or(wide))) }
                    { tr!("floor plan" => "cells wide") }
                    <button type="button" class="btn outline" onclick={say(FloorPlanAction::Turn)}>{ tr!("Turn") }</button>
                </p>
                if let Some(grow) = &card.grow {
                    <p><button type="button" class="btn outline" onclick={say(FloorPlanAction::Grow)}>{ grow.clone() }</button></p>
                }
                <h3>{ tr!("Give it a scale") }</h3>
                <p>
                    { tr!("floor plan" => "the two points are") }{ " " }{ field(tr!("Metres between the two points"), card.apart, (0.01, 10_000.0), send, FloorPlanAction::Apart) }
                    { tr!("floor plan" => "m apart,") }{ " " }
                    { tr!("floor plan" => "a cell is") }{ " " }{ field(tr!("Metres a cell"), Some(card.cell), (0.01, 10_000.0), send, |n| FloorPlanAction::CellSize(n.unwrap_or(1.0))) }
                    { tr!("floor plan" => "m") }
                </p>
                if let Some(size) = &card.size { <p class="remark">{ size.clone() }</p> }
                if let Some(units) = &card.units { <p class="remark">{ units.clone() }</p> }
                <h3>{ tr!("Turn it into cells") }</h3>
                <p class="remark">{ tr!("A cell is taken where at least this much of it is dark:") }</p>
                { threshold(card, send) }
                <div class="seg full" role="group" aria-label={tr!("What dark cells become")}>
                    { becomes(Paint::Obstacle, tr!("Obstacles")) }
                    { becomes(Paint::Slow, tr!("Slow zone")) }
                </div>
                <div role="status">
                    <p class="told"><b>{ card.told.clone() }</b></p>
                    { for card.close.iter().map(|line| html! { <p class="remark">{ line.clone() }</p> }) }
                </div>
                <p class="remark">{ card.stays }</p>
            </section>
        </>
    }
}

/// How dark the cells are, and from where on one is taken.
fn threshold(card: &Card, send: &Callback<Action>) -> Html {
    let bar = |(index, part): (usize, &f64)| {
        let is_taken = 5 * index as u32 + 5 > card.threshold;
        let height = 40.0 * part;
        html! {
            <rect class={classes!(is_taken.then_some("on"))} x={(5 * index).to_string()} width="4.4"
                y={format!("{:.1}", 40.0 - height)} height={format!("{height:.1}")} />
        }
    };
    let send = send.clone();
    let oninput = Callback::from(move |event: InputEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        if let Ok(least) = input.value().parse() {
            send.emit(Action::FloorPlan(FloorPlanAction::Threshold(least)));
        }
    });
    let value = card.threshold.to_string();
    html! {
        <div class="dark">
            <svg viewBox="0 0 100 40" preserveAspectRatio="none" aria-hidden="true">{ for card.bars.iter().enumerate().map(bar) }</svg>
            <input type="range" min="1" max="100" value={value.clone()} {oninput} aria-label={tr!("Dark at least, per cent")} />
            <p><small>{ tr!("floor plan" => "light") }</small><b>{ format!("{value} %") }</b><small>{ tr!("floor plan" => "dark") }</small></p>
        </div>
    }
}

#[inline(never)]
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    html! {
        <div class="foot making">
            if let Some(draw) = &card.draw {
                <button type="button" class="btn primary" onclick={act(send, FloorPlanAction::Draw)}>{ draw.clone() }</button>
            }
            <button type="button" class="btn outline" onclick={act(send, FloorPlanAction::Cancel)}>{ tr!("Cancel") }</button>
        </div>
    }
}

/// What can be done with the picture that lies under the grid.
pub(super) fn beside(state: &State, send: &Callback<Action>) -> Html {
    let Some(Row {
        about,
        is_shown,
        stays,
    }) = row(state)
    else {
        return Html::default();
    };
    let seen = if is_shown {
        tr!("floor plan" => "Hide")
    } else {
        tr!("floor plan" => "Show")
    };
    html! {
        <>
            <h3>{ tr!("Floor plan") }</h3>
            <p class="remark">{ about }{ ". " }{ stays }</p>
            <div class="pair">
                <button type="button" class="btn outline" onclick={act(send, FloorPlanAction::Open)}>{ tr!("Turn it into cells") }</button>
                <button type="button" class="btn outline" onclick={act(send, FloorPlanAction::Show(!is_shown))}>{ seen }</button>
                <button type="button" class="btn outline" onclick={act(send, FloorPlanAction::Remove)}>{ tr!("Remove") }</button>
            </div>
        </>
    }
}

fn act(send: &Callback<Action>, action: FloorPlanAction) -> Callback<MouseEvent> {
    send.reform(move |_| Action::FloorPlan(action.clone()))
}

/// A number in the sentence, which may have decimals; an empty field is none.
fn field(
    name: &'static str,
    value: Option<f64>,
    range: (f64, f64),
    send: &Callback<Action>,
    action: impl Fn(Option<f64>) -> FloorPlanAction + 'static,
) -> Html {
    let shown = value.map(decimal_text).unwrap_or_default();
    let send = send.clone();
    let on_change = Callback::from(move |typed: String| {
        let number = decimal(&typed, range);
        if number.is_some() || typed.trim().is_empty() {
            send.emit(Action::FloorPlan(action(number)));
        }
    });
    html! { { part::<Slot>(SlotProps { name, value: shown.into(), empty: None, range: None, on_change }) } }
}
