//! Fields for names and whole numbers.

use std::rc::Rc;

use crate::part::part;
use giveway_model::tr;
use giveway_page::number;
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
    /// Which whole numbers are possible, where it holds one.
    #[prop_or_default]
    pub(crate) range: Option<(u32, u32)>,
    /// Whether it holds a measure, which may have decimals.
    #[prop_or_default]
    pub(crate) is_measure: bool,
    /// Takes what was typed.
    pub(crate) on_change: Callback<String>,
}

/// A field with its label. What the state does not take is taken back; then it says which
/// numbers are possible, until something else is typed.
#[component]
pub(crate) fn Field(props: &FieldProps) -> Html {
    // The page may be rendered anew while somebody types: that must not take it back.
    let typing = use_state_eq(|| None::<String>);
    let refused = use_state_eq(|| false);
    let input = {
        let (typing, refused) = (typing.clone(), refused.clone());
        Callback::from(move |event: InputEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            typing.set(Some(input.value()));
            refused.set(false);
        })
    };
    let shown = match &*typing {
        Some(typed) => typed.clone().into(),
        None => props.value.clone(),
    };
    let change = {
        let on_change = props.on_change.clone();
        let (range, can_be_empty) = (props.range, props.empty.is_some());
        let is_measure = props.is_measure;
        let refused = refused.clone();
        Callback::from(move |event: Event| {
            let input: HtmlInputElement = event.target_unchecked_into();
            let typed = input.value();
            let is_empty = can_be_empty && typed.trim().is_empty();
            let is_possible = |range| is_empty || number::read(&typed, range).is_some();
            let is_fault = is_measure && number::measure(&typed).is_none();
            refused.set(is_fault || !range.is_none_or(is_possible));
            on_change.emit(typed);
            typing.set(None);
        })
    };
    let [pressed, released] = use_selected_by_press();
    let is_number = props.is_measure || props.range.is_some();
    html! {
        <label>
            { &props.label }
            <input class="field" type="text" inputmode={if props.is_measure { Some("decimal") } else { props.range.and(Some("numeric")) }}
                autocomplete="off" value={shown} placeholder={props.empty.clone()} aria-label={props.label.clone()}
                onmousedown={is_number.then_some(pressed)} onmouseup={is_number.then_some(released)} oninput={input} onchange={change} />
            if let Some(range) = props.range.filter(|_| *refused) { { possible(range) } }
            if props.is_measure && *refused { <small class="possible" role="status">{ number::possible_measure() }</small> }
        </label>
    }
}

/// Which numbers are possible, below a field that does not take another one.
pub(crate) fn possible(range: (u32, u32)) -> Html {
    html! { <small class="possible" role="status">{ number::possible(range) }</small> }
}

/// A field for a whole number between two, both included; what is none is taken
/// back. `empty` is what an empty field means: without it a field cannot be empty.
pub(crate) fn number(
    label: &'static str,
    value: Option<u32>,
    range: (u32, u32),
    empty: Option<&'static str>,
    on_change: &Callback<Option<u32>>,
) -> Html {
    let on_change = on_change.clone();
    let change = Callback::from(move |typed: String| {
        let new = match typed.trim() {
            "" if empty.is_some() => None,
            typed => number::taken(typed, value, range),
        };
        if new != value {
            on_change.emit(new);
        }
    });
    let text = value.map(|n| n.to_string()).unwrap_or_default();
    html! {
        { part::<Field>(FieldProps { label: label.into(), value: text.into(), empty: empty.map(AttrValue::from), range: Some(range), is_measure: false, on_change: change }) }
    }
}

/// A number in a sentence, between two, both included; an empty field is none. What is not
/// possible is taken back.
pub(crate) fn slot(
    name: &'static str,
    value: Option<u32>,
    range: (u32, u32),
    on_change: Callback<Option<u32>>,
) -> Html {
    let shown = value.map(|n| n.to_string()).unwrap_or_default();
    let on_change = Callback::from(move |typed: String| {
        let number = number::read(&typed, range);
        if number.is_some() || typed.trim().is_empty() {
            on_change.emit(number);
        }
    });
    let empty = Some(tr!("several robots" => "none"));
    html! { { part::<Slot>(SlotProps { name, value: shown.into(), empty, range: Some(range), on_change }) } }
}

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct SlotProps {
    /// What the number is, with its unit.
    pub(crate) name: &'static str,
    /// What stands in it.
    pub(crate) value: AttrValue,
    /// What an empty field means.
    #[prop_or_default]
    pub(crate) empty: Option<&'static str>,
    /// Which whole numbers are possible, where it holds one.
    #[prop_or_default]
    pub(crate) range: Option<(u32, u32)>,
    /// Takes what was typed.
    pub(crate) on_change: Callback<String>,
}

/// A field for a number in a sentence. What the state does not take is taken back; then it says
/// which numbers are possible, until something else is typed.
#[component]
pub(crate) fn Slot(props: &SlotProps) -> Html {
    // The page may be rendered anew while somebody types: that must not take it back.
    let typing = use_state_eq(|| None::<String>);
    let refused = use_state_eq(|| false);
    let oninput = {
        let (typing, refused) = (typing.clone(), refused.clone());
        Callback::from(move |event: InputEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            typing.set(Some(input.value()));
            refused.set(false);
        })
    };
    let onchange = {
        let (typing, refused, on_change) =
            (typing.clone(), refused.clone(), props.on_change.clone());
        let range = props.range;
        Callback::from(move |event: Event| {
            let input: HtmlInputElement = event.target_unchecked_into();
            let typed = input.value();
            let is_empty = typed.trim().is_empty();
            let is_possible = |range| is_empty || number::read(&typed, range).is_some();
            refused.set(!range.is_none_or(is_possible));
            on_change.emit(typed);
            typing.set(None);
        })
    };
    let [pressed, released] = use_selected_by_press();
    let value = (*typing)
        .clone()
        .map_or_else(|| props.value.clone(), AttrValue::from);
    let title = props.range.map(number::possible);
    html! {
        <>
            <input class="num1" type="text" inputmode="decimal" autocomplete="off" aria-label={props.name}
                {title} placeholder={props.empty} {value} onmousedown={pressed} onmouseup={released} {oninput} {onchange} />
            if let Some(range) = props.range.filter(|_| *refused) { { possible(range) } }
        </>
    }
}

/// The press that brings the focus to a number selects it: it is typed anew more often than it is
/// changed. What listens to the press and to its end.
#[hook]
fn use_selected_by_press() -> [Callback<MouseEvent>; 2] {
    let comes = use_mut_ref(|| false);
    let pressed = {
        let comes = Rc::clone(&comes);
        Callback::from(move |event: MouseEvent| {
            let input: HtmlInputElement = event.target_unchecked_into();
            comes.replace(!input.matches(":focus").unwrap_or_default());
        })
    };
    let released = Callback::from(move |event: MouseEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        let is_caret = input.selection_start().ok() == input.selection_end().ok();
        if comes.replace(false) && is_caret {
            input.select();
        }
    });
    [pressed, released]
}
