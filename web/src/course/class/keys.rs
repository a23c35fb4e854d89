//! Keys in the table of a class: arrows from cell to cell, J and K to the next to look at.

use giveway_course::grade::LookAction;
use web_sys::{HtmlElement, wasm_bindgen::JsCast as _};
use yew::prelude::*;

use super::ClassMsg;
use crate::course::tutor::Msg;

/// The attribute that tells a cell's row and column, `3.1`.
pub(super) const AT: &str = "data-at";

/// What a key does.
pub(super) fn pressed(event: &KeyboardEvent, send: &Callback<Msg>) {
    if event.ctrl_key() || event.meta_key() || event.alt_key() {
        return;
    }
    let (right, down) = match event.key().as_str() {
        "ArrowRight" => (1, 0),
        "ArrowLeft" => (-1, 0),
        "ArrowDown" => (0, 1),
        "ArrowUp" => (0, -1),
        "j" => return send.emit(Msg::Class(ClassMsg::Look(LookAction::LookAt(true)))),
        "k" => return send.emit(Msg::Class(ClassMsg::Look(LookAction::LookAt(false)))),
        _ => return,
    };
    let Some(from) = event.target_dyn_into::<HtmlElement>() else {
        return;
    };
    let Some((row, column)) = from.get_attribute(AT).as_deref().and_then(read) else {
        return;
    };
    let (row, column) = (row + down, column + right);
    let cell = gloo::utils::document().query_selector(&format!("[{AT}=\"{row}.{column}\"]"));
    if let Ok(Some(cell)) = cell
        && let Ok(cell) = cell.dyn_into::<HtmlElement>()
    {
        event.prevent_default();
        // It fails only where the browser lets nothing be focused.
        let _ = cell.focus();
    }
}

fn read(at: &str) -> Option<(i32, i32)> {
    let (row, column) = at.split_once('.')?;
    Some((row.parse().ok()?, column.parse().ok()?))
}
