//! The keys of the board.

use giveway_model::Cell;
use giveway_page::board::Frame;
use giveway_page::{Action, Tool};
use gloo::events::EventListener;
use wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent};
use yew::prelude::*;

use super::legend::ZOOM;
use super::viewport::{Look, Viewport};
use crate::Shown;

/// How many rows a page key goes at least.
const PAGE: u32 = 5;

/// On the board: arrows, Home, End and pages move the cell cursor, Enter and
/// Space apply the tool there; with Shift, arrows move what is there.
pub(super) fn on_key(
    state: &Shown,
    send: &Callback<Action>,
    viewport: &Viewport,
    frame: &Frame,
) -> Callback<KeyboardEvent> {
    let (state, send, look) = (state.clone(), send.clone(), viewport.look.clone());
    let frame = *frame;
    Callback::from(move |event: KeyboardEvent| {
        if event.alt_key() || event.meta_key() {
            return;
        }
        let key = event.key();
        let ctrl = event.ctrl_key();
        let cell = state.cursor;
        if !ctrl && matches!(key.as_str(), "Enter" | " ") {
            event.prevent_default();
            event.stop_propagation();
            if !event.repeat() {
                send.emit(Action::Press(cell));
                send.emit(Action::Release);
            }
            return;
        }
        let Some(to) = goes_to(&key, ctrl, cell, &state, &frame) else {
            return;
        };
        event.prevent_default();
        event.stop_propagation();
        if event.shift_key() && state.tool == Tool::Select {
            send.emit(Action::Press(cell));
            send.emit(Action::Drag(to));
            send.emit(Action::Release);
        }
        send.emit(Action::MoveCursor(to));
        look.emit(Look::Show(state.draft.clamp(to)));
    })
}

/// The cell that a key goes to; it may be beyond the last.
fn goes_to(key: &str, ctrl: bool, from: Cell, state: &Shown, frame: &Frame) -> Option<Cell> {
    let grid = state.draft.grid();
    let (_, rows) = frame.cells((grid.width(), grid.height()));
    let page = (rows.1 - rows.0).max(PAGE);
    let Cell { x, y } = from;
    let to = match (key, ctrl) {
        ("ArrowLeft", false) => Cell::new(x.saturating_sub(1), y),
        ("ArrowRight", false) => Cell::new(x + 1, y),
        ("ArrowUp", false) => Cell::new(x, y.saturating_sub(1)),
        ("ArrowDown", false) => Cell::new(x, y + 1),
        ("PageUp", false) => Cell::new(x, y.saturating_sub(page)),
        ("PageDown", false) => Cell::new(x, y + page),
        ("Home", false) | ("ArrowLeft", true) => Cell::new(0, y),
        ("End", false) | ("ArrowRight", true) => Cell::new(grid.width(), y),
        ("ArrowUp", true) => Cell::new(x, 0),
        ("ArrowDown", true) => Cell::new(x, grid.height()),
        ("Home", true) => Cell::new(0, 0),
        ("End", true) => Cell::new(grid.width(), grid.height()),
        _ => return None,
    };
    Some(to)
}

/// Wherever the focus is, but not in a field: `+`, `-` and `0` change the view.
#[hook]
pub(super) fn use_view_keys(look: &Callback<Look>) {
    let look = look.clone();
    use_effect_with((), move |()| {
        let listener = EventListener::new(&gloo::utils::window(), "keydown", move |event| {
            let Some(event) = event.dyn_ref::<KeyboardEvent>() else {
                return;
            };
            let has_modifier = event.ctrl_key() || event.alt_key() || event.meta_key();
            if has_modifier || event.default_prevented() || is_in_field(event) {
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

fn is_in_field(event: &KeyboardEvent) -> bool {
    let target = event.target().and_then(|target| target.dyn_into().ok());
    target.is_some_and(|target: Element| {
        let fields = "input, select, textarea, dialog, [contenteditable]";
        target.closest(fields).is_ok_and(|field| field.is_some())
    })
}
