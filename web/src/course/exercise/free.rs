//! A value that is predicted without answers to pick from.

use giveway_course::judge::{Did, Verdict};
use giveway_course::learner::{Action, Open};
use giveway_course::lesson::Value;
use giveway_course::lesson::quantity::ValueKind;
use giveway_course::lesson::task::Predict;
use giveway_model::constraint::InForce;
use giveway_model::{Agent, Constraint, tr};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use super::super::prose::Reader;
use super::super::tutor::{Msg, Tutor};

/// A robot or a rule that can be said, as a button, with the key that presses it.
fn said(place: usize, value: Value, words: Html, reader: Reader<'_>) -> Html {
    let number = place + 1;
    let press = reader
        .send
        .reform(move |_: MouseEvent| Msg::Do(Action::Guess(value.clone())));
    html! {
        <li><button type="button" class="opt" title={tr!("Key {number}", number)} data-key={number.to_string()}
            onclick={press}>{ words }</button></li>
    }
}

/// The field of a number, with its button.
pub(in crate::course) fn number(tutor: &Tutor, reader: Reader<'_>) -> Html {
    let oninput = reader.send.reform(|event: InputEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        Msg::Type(input.value())
    });
    let number = tutor.typed.trim().parse::<u32>().ok();
    let send = reader.send.clone();
    let onsubmit = move |event: SubmitEvent| {
        event.prevent_default();
        if let Some(number) = number {
            send.emit(Msg::Do(Action::Guess(Value::Number(number))));
        }
    };
    html! {
        <form class="guess" {onsubmit}>
            <input class="field" type="text" inputmode="numeric" autocomplete="off" aria-labelledby="ex-h"
                value={tutor.typed.clone()} {oninput} />
            <button class="btn outline" disabled={number.is_none()}>{ tr!("Say it") }</button>
            if number.is_none() && !tutor.typed.trim().is_empty() {
                <p class="quiet" role="status">{ tr!("Type a whole number, such as 12.") }</p>
            }
        </form>
    }
}

/// A value that is typed, picked from the robots or the rules, or clicked on the board.
pub(super) fn show(tutor: &Tutor, open: &Open, task: &Predict, reader: Reader<'_>) -> Html {
    match task.what.kind() {
        ValueKind::Number => number(tutor, reader),
        ValueKind::Robot => {
            let one = |(place, agent): (usize, &Agent)| {
                let value = Value::Robot(agent.name.clone());
                let words = html! { <span>{ reader.robot(&agent.name) }</span> };
                said(place, value, words, reader)
            };
            html! { <ul class="opts few">{ for open.scene().agents.iter().enumerate().map(one) }</ul> }
        }
        ValueKind::Rule => {
            let scene = open.scene();
            let one = |rule: InForce| {
                let value = Value::Rule {
                    rule: rule.index as u32,
                };
                let sentence = rule.constraint.sentence();
                let words = html! { <><kbd aria-hidden="true">{ rule.index + 1 }</kbd><span>{ sentence }</span></> };
                said(rule.index, value, words, reader)
            };
            html! { <ol class="opts">{ for scene.constraints_in_force().map(one) }</ol> }
        }
        ValueKind::Cell => html! { <p class="quiet">{ tr!("Click the cell on the board.") }</p> },
    }
}

/// The guess and what is proved, one below the other; a right guess is the proved one.
pub(super) fn beside(open: &Open, reader: Reader<'_>) -> Html {
    let truth = open.judge().verdict().and_then(Verdict::truth);
    let guess = match open.did() {
        Did::Guessed(guess) if truth != Some(guess) => Some(guess),
        _ => None,
    };
    let line = |class: &'static str, value: &Value, note: &'static str| {
        html! {
            <li class={classes!("opt", class)}><span><b>{ words(open, value, reader) }</b></span><em>{ note }</em></li>
        }
    };
    html! {
        <ul class="opts done">
            if let Some(guess) = guess { { line("mine", guess, tr!("your guess")) } }
            if let Some(truth) = truth { { line("right", truth, tr!("an answer" => "proved")) } }
        </ul>
    }
}

/// A value in words: a robot with its form, a rule as its sentence.
fn words(open: &Open, value: &Value, reader: Reader<'_>) -> Html {
    match value {
        Value::Number(_) | Value::Cell(_) => html! { { value.to_string() } },
        Value::Robot(name) => reader.robot(name),
        Value::Rule { rule } => {
            let rule = open.scene().constraints.get(*rule as usize);
            let words = rule.map_or_else(|| value.to_string(), Constraint::sentence);
            html! { { words } }
        }
    }
}
