//! What fills a slot of a rule that is being written: a number, names, times, a cell.

use giveway_model::condition::Times;
use giveway_model::constraint::MAX_NUMBER;
use giveway_model::tr;
use giveway_page::Action;
use giveway_page::rules::{Editor, RuleAction, Slot, Value};
use yew::prelude::*;

use super::rules::act;
use crate::field::number;
use crate::{glyph, icon};

pub(super) fn show(slot: Slot, editor: &Editor, send: &Callback<Action>) -> Html {
    let body = match (slot, editor) {
        (Slot::Number(index), Editor::Number { value, least }) => {
            stepper(index, *value, *least, send)
        }
        (_, Editor::Names { names, several }) => choices(slot, names, *several, send),
        (_, Editor::When(times)) => when(*times, send),
        (_, Editor::Cell(cell)) => html! {
            <p class="remark">{ tr!("Now {cell}. Press another cell on the board.", cell) }</p>
        },
        (_, Editor::Number { .. }) => Html::default(),
    };
    html! { <div class="slot-editor">{ body }</div> }
}

fn stepper(index: usize, value: u32, least: u32, send: &Callback<Action>) -> Html {
    let set = |to: u32| act(send, move || RuleAction::Fill(Value::Number(index, to)));
    let typed = send.reform(move |n: Option<u32>| {
        Action::Rules(RuleAction::Fill(Value::Number(index, n.unwrap_or(least))))
    });
    html! {
        <>
            <button type="button" class="btn outline round" aria-label={tr!("One less")} disabled={value <= least} onclick={set(value.saturating_sub(1))}>{ icon::show("minus") }</button>
            { number(tr!("Number"), Some(value), (least, MAX_NUMBER), None, &typed) }
            <button type="button" class="btn outline round" aria-label={tr!("One more")} onclick={set(value.saturating_add(1))}>{ icon::show("plus") }</button>
        </>
    }
}

/// Names to press; of robots that a rule binds, several.
fn choices(slot: Slot, names: &[(String, bool)], several: bool, send: &Callback<Action>) -> Html {
    let chosen: Vec<String> = names
        .iter()
        .filter(|(_, is_on)| *is_on)
        .map(|(name, _)| name.clone())
        .collect();
    let is_all = chosen.is_empty();
    let pick = |(agent, (name, is_on)): (usize, &(String, bool))| {
        let value = match slot {
            Slot::Who => {
                let mut chosen = chosen.clone();
                if *is_on {
                    chosen.retain(|other| other != name);
                } else {
                    chosen.push(name.clone());
                }
                Value::Who((!chosen.is_empty()).then_some(chosen))
            }
            Slot::Zone => Value::Zone(name.clone()),
            Slot::Agent(index) => Value::Agent(index, name.clone()),
            Slot::Number(_) | Slot::When | Slot::Cell(_) => return Html::default(),
        };
        html! {
            <button type="button" class="pick-one" aria-pressed={is_on.to_string()} onclick={act(send, move || RuleAction::Fill(value.clone()))}>
                if slot != Slot::Zone { { glyph::show(agent, "pick-glyph") } }{ name.clone() }
            </button>
        }
    };
    let others = names.iter().filter(|(_, is_on)| !*is_on);
    let others: Vec<String> = others.map(|(name, _)| name.clone()).collect();
    let can_turn = several && !is_all && !others.is_empty();
    html! {
        <>
            if several {
                <button type="button" class="pick-one" aria-pressed={is_all.to_string()} onclick={act(send, || RuleAction::Fill(Value::Who(None)))}>{ tr!("All robots") }</button>
            }
            if can_turn {
                <button type="button" class="pick-one" onclick={act(send, move || RuleAction::Fill(Value::Who(Some(others.clone()))))}>{ tr!("The others instead") }</button>
            }
            { for names.iter().enumerate().map(pick) }
        </>
    }
}

/// Always, or from one time to another.
fn when(times: Option<Times>, send: &Callback<Action>) -> Html {
    let known = times.unwrap_or_default();
    let set = |times: Times| act(send, move || RuleAction::Fill(Value::When(times)));
    let change = |make: fn(Times, Option<u32>) -> Times| {
        send.reform(move |n: Option<u32>| {
            Action::Rules(RuleAction::Fill(Value::When(make(known, n))))
        })
    };
    let some = Times {
        from: Some(known.first()),
        to: known.to.or(Some(known.first().saturating_add(5))),
    };
    html! {
        <>
            <div class="seg" role="group" aria-label={tr!("When")}>
                <button type="button" aria-pressed={times.is_none().to_string()} onclick={set(Times::default())}>{ tr!("a rule holds" => "Always") }</button>
                <button type="button" aria-pressed={times.is_some().to_string()} onclick={set(some)}>{ tr!("From, to") }</button>
            </div>
            if times.is_some() {
                { number(tr!("a time" => "From"), known.from, (0, MAX_NUMBER), Some(tr!("the start")), &change(|times, from| Times { from, ..times })) }
                { number(tr!("a time" => "To"), known.to, (0, MAX_NUMBER), Some(tr!("for ever")), &change(|times, to| Times { to, ..times })) }
            }
        </>
    }
}
