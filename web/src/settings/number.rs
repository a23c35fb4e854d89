//! A field for a whole number.

use web_sys::HtmlInputElement;
use yew::prelude::*;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct NumberProps {
    /// What it is, with its unit.
    pub(super) label: AttrValue,
    /// The number.
    pub(super) value: Option<u32>,
    /// What an empty field means; without it a field cannot be empty.
    #[prop_or_default]
    pub(super) empty: Option<AttrValue>,
    /// The least number.
    #[prop_or_default]
    pub(super) least: u32,
    /// The largest number.
    pub(super) most: u32,
    /// Takes a number within both, or none from an empty field.
    pub(super) on_change: Callback<Option<u32>>,
}

/// A field for a whole number. What is none is taken back.
#[component]
pub(super) fn Number(props: &NumberProps) -> Html {
    let text = |value: Option<u32>| value.map(|n| n.to_string()).unwrap_or_default();
    // The page may be rendered anew while somebody types: that must not take it back.
    let typing = use_state_eq(|| None::<String>);
    let input = {
        let typing = typing.clone();
        Callback::from(move |event: InputEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            typing.set(Some(input.value()));
        })
    };
    let shown = (*typing).clone().unwrap_or_else(|| text(props.value));
    let change = {
        let props = props.clone();
        Callback::from(move |event: Event| {
            let input: HtmlInputElement = event.target_unchecked_into();
            let typed = input.value();
            let value = match typed.trim() {
                "" if props.empty.is_some() => None,
                typed => match typed.parse::<u32>() {
                    Ok(n) => Some(n.clamp(props.least, props.most)),
                    Err(_) => props.value,
                },
            };
            // What is shown differs from what was typed where that was no number.
            input.set_value(&text(value));
            typing.set(None);
            if value != props.value {
                props.on_change.emit(value);
            }
        })
    };
    html! {
        <label>
            { &props.label }
            <input class="field" type="text" inputmode="numeric" autocomplete="off"
                value={shown} placeholder={props.empty.clone()} oninput={input}
                onchange={change} />
        </label>
    }
}
