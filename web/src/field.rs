//! Fields for names and whole numbers.

use web_sys::HtmlInputElement;
use yew::prelude::*;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct FieldProps {
    /// What it is, with its unit.
    pub(crate) label: AttrValue,
    /// What stands in it.
    pub(crate) value: AttrValue,
    /// What an empty field means.
    #[prop_or_default]
    pub(crate) empty: Option<AttrValue>,
    /// Whether a phone shows figures only.
    #[prop_or_default]
    pub(crate) is_number: bool,
    /// Takes what was typed.
    pub(crate) on_change: Callback<String>,
}

/// A field with its label. What the state does not take is taken back.
#[component]
pub(crate) fn Field(props: &FieldProps) -> Html {
    // The page may be rendered anew while somebody types: that must not take it back.
    let typing = use_state_eq(|| None::<String>);
    let input = {
        let typing = typing.clone();
        Callback::from(move |event: InputEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            typing.set(Some(input.value()));
        })
    };
    let shown = match &*typing {
        Some(typed) => typed.clone().into(),
        None => props.value.clone(),
    };
    let change = {
        let on_change = props.on_change.clone();
        Callback::from(move |event: Event| {
            let input: HtmlInputElement = event.target_unchecked_into();
            on_change.emit(input.value());
            typing.set(None);
        })
    };
    html! {
        <label>
            { &props.label }
            <input class="field" type="text" inputmode={props.is_number.then_some("numeric")}
                autocomplete="off" value={shown} placeholder={props.empty.clone()}
                oninput={input} onchange={change} />
        </label>
    }
}

/// A field for a whole number between two, both included; what is none is taken
/// back. `empty` is what an empty field means: without it a field cannot be empty.
pub(crate) fn number(
    label: &'static str,
    value: Option<u32>,
    (least, most): (u32, u32),
    empty: Option<&'static str>,
    on_change: &Callback<Option<u32>>,
) -> Html {
    let on_change = on_change.clone();
    let change = Callback::from(move |typed: String| {
        let new = match typed.trim() {
            "" if empty.is_some() => None,
            typed => match typed.parse::<u32>() {
                Ok(n) => Some(n.clamp(least, most)),
                Err(_) => value,
            },
        };
        if new != value {
            on_change.emit(new);
        }
    });
    let text = value.map(|n| n.to_string()).unwrap_or_default();
    html! {
        <Field {label} value={text} empty={empty.map(AttrValue::from)} is_number=true on_change={change} />
    }
}
