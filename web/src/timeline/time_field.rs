//! The number of the time shown: another one can be typed over it.

use giveway_model::tr;
use giveway_page::number::nearest;
use giveway_page::{Action, PlayAction};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use crate::part::part;

#[derive(Clone, PartialEq, Properties)]
struct TimeProps {
    time: u32,
    last: u32,
    is_playing: bool,
    send: Callback<Action>,
}

/// The field: Enter goes to the time that was typed, Escape leaves it.
pub(super) fn time_field(
    (time, last): (u32, u32),
    is_playing: bool,
    send: &Callback<Action>,
) -> Html {
    part::<TimeField>(TimeProps {
        time,
        last,
        is_playing,
        send: send.clone(),
    })
}

#[component]
fn TimeField(props: &TimeProps) -> Html {
    let TimeProps {
        time,
        last,
        is_playing,
        send,
    } = props.clone();
    // The time may go on while somebody types: that must not take it back.
    let typing = use_state_eq(|| None::<String>);
    let oninput = {
        let (typing, send) = (typing.clone(), send.clone());
        move |event: InputEvent| {
            if is_playing {
                send.emit(Action::Play(PlayAction::Pause));
            }
            let input: HtmlInputElement = event.target_unchecked_into();
            typing.set(Some(input.value()));
        }
    };
    let onkeydown = move |event: KeyboardEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        match event.key().as_str() {
            "Enter" => {}
            // What was typed is no time to go to.
            "Escape" => input.set_value(&time.to_string()),
            _ => return,
        }
        event.prevent_default();
        event.stop_propagation();
        // It is left, and read then.
        let _ = input.blur();
    };
    let onblur = {
        let typing = typing.clone();
        move |event: FocusEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            let to = nearest(&input.value(), (0, last)).filter(|&to| to != time);
            if let Some(to) = to.filter(|_| typing.is_some()) {
                send.emit(Action::Play(PlayAction::Seek(to)));
            }
            typing.set(None);
        }
    };
    let onfocus = |event: FocusEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        input.select();
    };
    let value = (*typing).clone().unwrap_or_else(|| time.to_string());
    let size = last.to_string().len().to_string();
    html! {
        <input type="text" inputmode="numeric" autocomplete="off" {size} {value} aria-label={tr!("Time, 0 to {last}", last)}
            {oninput} {onkeydown} {onblur} {onfocus} />
    }
}
