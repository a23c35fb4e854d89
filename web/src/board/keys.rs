//! The keys of the board.

use giveway_model::Cell;
use giveway_page::{Action, BoardAction};
use gloo::events::EventListener;
use wasm_bindgen::JsCast;
use web_sys::KeyboardEvent;
use yew::prelude::*;

use super::legend::ZOOM;
use super::viewport::Look;
use crate::held::use_held;
use crate::keys::{FIELDS, dialog_is_open, is_in};

/// How many rows a page key goes at least.
const PAGE: u32 = 5;

/// On the board: arrows, Home, End and pages move the cell cursor, Enter and
/// Space apply the tool there; with Shift, arrows move what is there.
#[hook]
pub(super) fn use_cursor_keys(
    cursor: Cell,
    send: &Callback<Action>,
    look: &Callback<Look>,
    rows: u32,
) -> Callback<KeyboardEvent> {
    // The camera follows the keyboard, and leaves the pointer where it is.
    let follows = use_held(|| false);
    {
        let (follows, look) = (follows.clone(), look.clone());
        use_effect_with(cursor, move |&cursor| {
            if follows.take() {
                look.emit(Look::Show(cursor));
            }
        });
    }
    let send = send.clone();
    Callback::from(move |event: KeyboardEvent| {
        let (key, ctrl) = (event.key(), event.ctrl_key());
        let takes = event.alt_key() && key == " ";
        if (event.alt_key() && !takes) || event.meta_key() {
            return;
        }
        let action = if takes {
            send.emit(Action::Board(BoardAction::Mark {
                cell: cursor,
                takes,
                is_rect: false,
            }));
            Some(Action::Board(BoardAction::Release))
        } else if !ctrl && matches!(key.as_str(), "Enter" | " ") {
            (!event.repeat()).then_some(Action::Board(BoardAction::UseTool))
        } else if let Some(by) = goes_by(&key, ctrl, rows.max(PAGE)) {
            follows.set(true);
            let carries = event.shift_key();
            Some(Action::Board(BoardAction::StepCursor { by, carries }))
        } else {
            return;
        };
        event.prevent_default();
        event.stop_propagation();
        if let Some(action) = action {
            send.emit(action);
        }
    })
}

/// How far a key goes, in cells right and down; `page` is a page's rows.
fn goes_by(key: &str, ctrl: bool, page: u32) -> Option<(i32, i32)> {
    let page = i32::try_from(page).unwrap_or(i32::MAX);
    let by = match (key, ctrl) {
        ("ArrowLeft", false) => (-1, 0),
        ("ArrowRight", false) => (1, 0),
        ("ArrowUp", false) => (0, -1),
        ("ArrowDown", false) => (0, 1),
        ("PageUp", false) => (0, -page),
        ("PageDown", false) => (0, page),
        ("Home", false) | ("ArrowLeft", true) => (i32::MIN, 0),
        ("End", false) | ("ArrowRight", true) => (i32::MAX, 0),
        ("ArrowUp", true) => (0, i32::MIN),
        ("ArrowDown", true) => (0, i32::MAX),
        ("Home", true) => (i32::MIN, i32::MIN),
        ("End", true) => (i32::MAX, i32::MAX),
        _ => return None,
    };
    Some(by)
}

/// Wherever the focus is, but not in a field: `+`, `-` and `0` change the view.
#[hook]
pub(super) fn use_view_keys(look: &Callback<Look>) {
    use_effect_with(look.clone(), move |look| {
        let look = look.clone();
        let listener = EventListener::new(&gloo::utils::window(), "keydown", move |event| {
            let Some(event) = event.dyn_ref::<KeyboardEvent>() else {
                return;
            };
            let has_modifier = event.ctrl_key() || event.alt_key() || event.meta_key();
            let is_taken = event.default_prevented() || dialog_is_open();
            if has_modifier || is_taken || is_in(event, FIELDS) {
                return;
            }
            match event.key().as_str() {
                "+" | "=" => look.emit(Look::Zoom(ZOOM, None)),
                "-" => look.emit(Look::Zoom(1.0 / ZOOM, None)),
                "0" => look.emit(Look::Fit),
                _ => {}
            }
        });
        move || drop(listener)
    });
}
