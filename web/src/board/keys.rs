//! The keys of the board.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::board::{Cast, tip};
use giveway_page::{Action, BoardAction, Point};
use gloo::events::EventListener;
use gloo::timers::callback::Timeout;
use wasm_bindgen::JsCast;
use web_sys::KeyboardEvent;
use yew::prelude::*;

use super::legend::ZOOM;
use super::pointer::{At, Pointer};
use super::viewport::Look;
use super::{BOARD, cells};
use crate::Shown;
use crate::held::use_held;
use crate::keys::{FIELDS, dialog_is_open, is_in};

/// How long the cell of the keyboard rests before it is told of, in milliseconds.
const REST_MS: u32 = 600;
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

/// After a while the cell that the keyboard moved to is told of, and described to those who do
/// not see the board.
#[hook]
pub(super) fn use_tip_keys(
    onkeydown: &Callback<KeyboardEvent>,
    pointer: &Rc<Pointer>,
    state: &Shown,
    cast: &Rc<Cast>,
) -> Callback<KeyboardEvent> {
    let by_key = use_held(|| false);
    let (cursor, time) = (state.view.cursor, state.view.playback.time);
    {
        let (by_key, pointer, cast) = (by_key.clone(), Rc::clone(pointer), Rc::clone(cast));
        use_effect_with(cursor, move |&cell| {
            let resting = by_key.take().then(|| {
                pointer.set(None);
                Timeout::new(REST_MS, move || {
                    let point = Point {
                        x: f64::from(cell.x),
                        y: f64::from(cell.y),
                    };
                    let agent = cast.agent_at(point, f64::from(time));
                    pointer.set(Some(At { cell, agent }));
                })
            });
            move || drop(resting)
        });
    }
    {
        let (state, deps) = (state.clone(), (cursor, time, Rc::clone(cast)));
        use_effect_with(deps, move |(cursor, _, cast)| {
            let id = cells::id(BOARD.english(), *cursor);
            let cell = gloo::utils::document().get_element_by_id(&id);
            if let (Some(cell), Some(tip)) = (&cell, tip(&state, cast, *cursor)) {
                // The name is valid, so that it cannot fail.
                let _ = cell.set_attribute("aria-description", &tip.sentence());
            }
            move || {
                if let Some(cell) = cell {
                    let _ = cell.remove_attribute("aria-description");
                }
            }
        });
    }
    let onkeydown = onkeydown.clone();
    Callback::from(move |event: KeyboardEvent| {
        let key = event.key();
        let goes = goes_by(&key, event.ctrl_key(), PAGE).is_some();
        by_key.set(goes);
        onkeydown.emit(event);
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
