//! A button that changes its meaning: for a moment after that it takes no press, so that a
//! press that was meant for what stood there before never does the opposite.

use gloo::timers::callback::Timeout;
use yew::prelude::*;

use crate::held::use_held;
use crate::part::part;

/// For so long it takes no press, in milliseconds: a double click is over by then.
const REST_MS: u32 = 500;

/// What such a button does and looks like.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct TurningProps {
    /// What it does: it rests when this changes.
    pub(crate) meaning: AttrValue,
    /// Its classes in the style sheets.
    pub(crate) class: Classes,
    /// Its tip.
    pub(crate) title: Option<AttrValue>,
    /// Its name, where that is more than what stands in it.
    pub(crate) label: Option<AttrValue>,
    /// Whether it takes no press for another reason.
    pub(crate) is_off: bool,
    /// Whether its own press may be taken back at once: only a change from elsewhere lets it rest.
    pub(crate) is_toggle: bool,
    /// What stands in it.
    pub(crate) content: Html,
    /// Takes presses.
    pub(crate) onclick: Callback<MouseEvent>,
}

/// A button of this class with a word; the word is its meaning.
pub(crate) fn turning(
    class: &'static str,
    word: impl Into<AttrValue>,
    content: Html,
    onclick: Callback<MouseEvent>,
) -> Html {
    part::<Turning>(TurningProps {
        meaning: word.into(),
        class: classes!("btn", class),
        title: None,
        label: None,
        is_off: false,
        is_toggle: false,
        content,
        onclick,
    })
}

/// The button.
#[component]
pub(crate) fn Turning(props: &TurningProps) -> Html {
    let TurningProps {
        meaning,
        class,
        title,
        label,
        is_off,
        is_toggle,
        content,
        onclick,
    } = props;
    // What it meant before it rests, then what it means.
    let settled = use_state_eq(|| meaning.clone());
    let was_pressed = use_held(|| false);
    let rests = *settled != *meaning && !(*is_toggle && was_pressed.get());
    {
        let (settled, was_pressed) = (settled.clone(), was_pressed.clone());
        use_effect_with(meaning.clone(), move |meaning| {
            let meaning = meaning.clone();
            let later = (*settled != meaning).then(|| {
                Timeout::new(REST_MS, move || {
                    was_pressed.set(false);
                    settled.set(meaning);
                })
            });
            move || drop(later)
        });
    }
    let press = {
        let onclick = onclick.clone();
        Callback::from(move |event: MouseEvent| {
            if !rests {
                was_pressed.set(true);
                onclick.emit(event);
            }
        })
    };
    html! {
        <button type="button" class={class.clone()} title={title.clone()} aria-label={label.clone()} disabled={*is_off}
            aria-disabled={rests.then_some("true")} onclick={press}>{ content.clone() }</button>
    }
}
