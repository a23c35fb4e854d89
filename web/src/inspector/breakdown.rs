//! A robot that breaks down, as a sentence whose slots are filled in place; and what that leads to.

use giveway_model::change::MAX_DELAY;
use giveway_model::tr;
use giveway_page::changing::{Blank, Breakdown, Filled, Piece};
use giveway_page::{Action, ChangeAction};
use yew::prelude::*;

use crate::field::number;
use crate::{glyph, icon};

/// The steps of a breakdown that was for good.
const STEPS: u32 = 10;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct BreakdownCardProps {
    pub(super) breakdown: Breakdown,
    pub(super) send: Callback<Action>,
}

/// The card of a listed breakdown.
#[component]
pub(super) fn BreakdownCard(props: &BreakdownCardProps) -> Html {
    let BreakdownCardProps { breakdown, send } = props;
    let open = use_state_eq(|| None::<Blank>);
    let index = breakdown.index;
    let take_back = send.reform(move |_: MouseEvent| Action::Change(ChangeAction::TakeBack(index)));
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) => html! { { words.clone() } },
        Piece::Slot(blank, text) => {
            let (blank, is_open) = (*blank, *open == Some(*blank));
            let name = match blank {
                Blank::Robot => tr!("Which robot: {text}", text),
                Blank::Time => tr!("At which time: {text}", text),
                Blank::Steps => tr!("How long: {text}", text),
            };
            let press = {
                let open = open.clone();
                move |_: MouseEvent| open.set((!is_open).then_some(blank))
            };
            html! {
                <button type="button" class={classes!("slot-of-rule", is_open.then_some("on"))} aria-expanded={is_open.to_string()} aria-label={name} onclick={press}>
                    { text.clone() }
                </button>
            }
        }
    };
    let (state, sign) =
        if breakdown.met.is_some() || breakdown.told.iter().any(|(is_bad, _)| *is_bad) {
            ("meets", "warning")
        } else {
            ("meets fine", "check")
        };
    let met = breakdown.met.clone();
    let met = met.unwrap_or_else(|| tr!("Nobody runs into it.").to_owned());
    html! {
        <div class="breaks" role="group" aria-label={tr!("Breaks down here")}>
            <p><b>{ icon::show("stop") }{ tr!("Breaks down here") }</b>
                <button type="button" class="btn ghost round" title={tr!("Take back")} aria-label={tr!("Take back the breakdown")} onclick={take_back}>{ icon::show("cancel") }</button></p>
            <div class="said">{ glyph::show(breakdown.agent, "choice-glyph") }{ for breakdown.pieces.iter().map(piece) }</div>
            if let Some(blank) = *open { <div class="slot-editor">{ editor(blank, breakdown, send) }</div> }
            <div role="status"><ul class={state}><li>{ icon::show(sign) }<span>
                <b>{ met }</b>
                { for breakdown.told.iter().map(|(_, text)| html! { <span>{ " " }{ text.clone() }</span> }) }
            </span></li></ul></div>
        </div>
    }
}

fn editor(blank: Blank, breakdown: &Breakdown, send: &Callback<Action>) -> Html {
    let index = breakdown.index;
    let fill = |filled: Filled| {
        send.reform(move |_: MouseEvent| Action::Change(ChangeAction::Fill(index, filled)))
    };
    match blank {
        Blank::Robot => {
            let pick = |(agent, name): &(usize, String)| {
                let is_on = *agent == breakdown.agent;
                html! {
                    <button type="button" class="pick-one" aria-pressed={is_on.to_string()} onclick={fill(Filled::Robot(*agent))}>
                        { glyph::show(*agent, "pick-glyph") }{ name.clone() }
                    </button>
                }
            };
            breakdown.robots.iter().map(pick).collect()
        }
        Blank::Time => {
            let (time, range) = breakdown.time;
            let typed = send.reform(move |n: Option<u32>| {
                Action::Change(ChangeAction::Fill(index, Filled::Time(n.unwrap_or(time))))
            });
            number(tr!("Time"), Some(time), range, None, &typed)
        }
        Blank::Steps => {
            let steps = breakdown.steps;
            let typed = send.reform(move |n: Option<u32>| {
                Action::Change(ChangeAction::Fill(index, Filled::Steps(n)))
            });
            html! {
                <>
                    <div class="seg">
                        <button type="button" aria-pressed={steps.is_some().to_string()} onclick={fill(Filled::Steps(Some(steps.unwrap_or(STEPS))))}>{ tr!("For some steps") }</button>
                        <button type="button" aria-pressed={steps.is_none().to_string()} onclick={fill(Filled::Steps(None))}>{ tr!("For good") }</button>
                    </div>
                    if steps.is_some() { { number(tr!("Delay, steps"), steps, (1, MAX_DELAY), None, &typed) } }
                </>
            }
        }
    }
}
