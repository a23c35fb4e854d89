//! A button that changes its meaning: for a moment after that it takes no press, so that a
//! press that was meant for what stood there before never does the opposite. Where a press
//! of another button changed it, the next one is meant for what stands there now.

use std::cell::RefCell;

use gloo::events::{EventListener, EventListenerOptions};
use gloo::timers::callback::Timeout;
use js_sys::Date;
use wasm_bindgen::JsCast;
use yew::prelude::*;

use crate::held::use_held;
use crate::part::part;

/// For so long it takes no press, in milliseconds: a double click is over by then.
const REST_MS: u32 = 500;

/// So much later than a press, in milliseconds, a change does not come from it any more.
const PRESS_MS: f64 = 100.0;

/// The last press of a pointer or a key.
#[derive(Default)]
struct LastPress {
    at: f64,
    on: Option<web_sys::Node>,
    listening: Option<[EventListener; 2]>,
}

thread_local! {
    static LAST_PRESS: RefCell<LastPress> = RefCell::default();
}

/// Notes every press from now on.
fn note_presses() {
    LAST_PRESS.with_borrow_mut(|last| {
        last.listening.get_or_insert_with(|| {
            ["pointerup", "keydown"].map(|kind| {
                let (document, options) = (
                    gloo::utils::document(),
                    EventListenerOptions::run_in_capture_phase(),
                );
                EventListener::new_with_options(&document, kind, options, |event| {
                    let on = event.target().and_then(|it| it.dyn_into().ok());
                    LAST_PRESS.with_borrow_mut(|last| {
                        (last.at, last.on) = (Date::now(), on);
                    });
                })
            })
        });
    });
}

/// Whether a press of anything but this button has just been made.
fn is_pressed_elsewhere(button: &NodeRef) -> bool {
    LAST_PRESS.with_borrow(|last| {
        let is_here = button.get().is_some_and(|it| it.contains(last.on.as_ref()));
        last.on.is_some() && !is_here && Date::now() - last.at < PRESS_MS
    })
}

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
    let button = use_node_ref();
    let rests = *settled != *meaning && !(*is_toggle && was_pressed.get());
    {
        let (settled, was_pressed) = (settled.clone(), was_pressed.clone());
        let button = button.clone();
        use_effect_with(meaning.clone(), move |meaning| {
            note_presses();
            let meaning = meaning.clone();
            if is_pressed_elsewhere(&button) {
                settled.set(meaning.clone());
            }
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
        <button ref={button} type="button" class={class.clone()} title={title.clone()} aria-label={label.clone()} disabled={*is_off}
            aria-disabled={rests.then_some("true")} onclick={press}>{ content.clone() }</button>
    }
}
