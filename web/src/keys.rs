//! The keys that work wherever the focus is, unless something there has a use
//! for them.

use giveway_page::{
    Action, BoardAction,
    area::AreaAction,
    keys::{Command, Key, command},
};
use gloo::events::{EventListener, EventListenerOptions};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, Event, KeyboardEvent, SvgElement};
use yew::prelude::*;

use crate::Shown;
use crate::board::copy_area;
use crate::dialog::Panel;
use crate::newest::Newest;

/// Where a person types.
pub(crate) const FIELDS: &str = "input, textarea, select, [contenteditable]";
/// Fields that are not typed into: they leave keys with Ctrl to the page.
const SWITCHES: &str = "input:is([type=checkbox], [type=radio], [type=range])";
/// What Space presses.
const PRESSED: &str = "button, a, summary, label";

/// Listens for keys that no place of the page took for itself.
#[hook]
pub(crate) fn use_keys(newest: &Newest, send: &Callback<Action>, show: &Callback<Panel>) {
    let (newest, send, show) = (newest.clone(), send.clone(), show.clone());
    use_effect_with((), move |()| {
        let window = gloo::utils::window();
        let options = EventListenerOptions::enable_prevent_default();
        let listening =
            EventListener::new_with_options(&window, "keydown", options, move |event| {
                let Some(event) = event.dyn_ref::<KeyboardEvent>() else {
                    return;
                };
                let state = newest.get();
                let command = wanted(event, &state);
                let Some(command) = command else { return };
                event.prevent_default();
                match command {
                    Command::Act(Action::Area(AreaAction::Copy)) => copy_area(&state, &send),
                    Command::Act(action) => {
                        let picks = matches!(
                            action,
                            Action::Board(BoardAction::PickTool(_) | BoardAction::PickShape(_))
                        );
                        send.emit(action);
                        if picks {
                            focus_board();
                        }
                    }
                    // The key that opens the list of keys closes it, too.
                    Command::Help if help_is_open() => show.emit(Panel::Nothing),
                    Command::Help => show.emit(Panel::Help),
                }
            });
        move || drop(listening)
    });
}

/// The arrows are for the tool that was picked by its key.
fn focus_board() {
    let board = gloo::utils::document().query_selector("svg[data-board=main]");
    if let Ok(Some(board)) = board {
        // What cannot take it leaves it where it is.
        let _ = board.unchecked_into::<SvgElement>().focus();
    }
}

fn wanted(event: &KeyboardEvent, state: &Shown) -> Option<Command> {
    let name = event.key();
    let is_for_dialog = dialog_is_open() && !(name == "?" && help_is_open());
    if event.default_prevented() || event.is_composing() || is_for_dialog {
        return None;
    }
    let key = Key {
        name: &name,
        ctrl: event.ctrl_key() || event.meta_key(),
        shift: event.shift_key(),
        alt: event.alt_key(),
    };
    let everywhere = name == "Escape" || (key.ctrl && name == "Enter");
    let is_for_field = is_in(event, FIELDS) && !(key.ctrl && is_in(event, SWITCHES));
    // Ctrl and Enter solves, wherever it is pressed.
    let presses = name == " " || (name == "Enter" && !key.ctrl);
    if (is_for_field && !everywhere) || (presses && is_in(event, PRESSED)) {
        return None;
    }
    command(key, state)
}

/// Whether an event came from such a place.
pub(crate) fn is_in(event: &Event, places: &str) -> bool {
    let target = event.target().and_then(|t| t.dyn_into::<Element>().ok());
    let place = target.map(|element| element.closest(places));
    place.is_some_and(|place| place.is_ok_and(|place| place.is_some()))
}

pub(crate) fn dialog_is_open() -> bool {
    is_on_page("dialog[open]")
}

/// Whether the list of keys is open.
fn help_is_open() -> bool {
    is_on_page("dialog[open] .keylist")
}

fn is_on_page(place: &str) -> bool {
    let found = gloo::utils::document().query_selector(place);
    found.is_ok_and(|found| found.is_some())
}
