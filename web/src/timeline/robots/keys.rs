//! The keys of the robots' table.

use std::rc::Rc;

use giveway_page::robots::{Column, RobotsAction, Table, copied};
use giveway_page::{Action, State};
use yew::prelude::*;

use super::{Edited, Finish};
use crate::copy;
use crate::held::Held;

/// The cell that is edited, as it is drawn and as it is by now, and the cell that the keyboard is at
/// by now: keys come faster than the page is drawn.
#[derive(Clone)]
pub(super) struct Editing {
    pub(super) drawn: UseStateHandle<Edited>,
    pub(super) by_now: Rc<Held<Edited>>,
    pub(super) at: Rc<Held<(usize, Column)>>,
}

impl Editing {
    pub(super) fn set(&self, edited: Edited) {
        self.by_now.set(edited.clone());
        self.drawn.set(edited);
    }

    /// The keyboard goes so many columns right and rows down.
    pub(super) fn go(&self, by: (i32, i32), last: usize, send: &Callback<Action>) {
        let (row, column) = moved(self.at.get(), by, last);
        self.at.set((row, column));
        send.emit(Action::Robots(RobotsAction::Focus(row, column)));
    }
}

/// The keys of the table: arrows go, Enter edits, letters type over.
pub(super) fn keys(
    now: &Table,
    state: &State,
    send: &Callback<Action>,
    edited: &Editing,
    finish: &Finish,
) -> Callback<KeyboardEvent> {
    let rows = now.rows.clone();
    let here = move |at: (usize, Column)| {
        let place = Column::ALL.iter().position(|&column| column == at.1)?;
        let cell = rows.get(at.0)?.cells.get(place)?;
        Some(cell.text.clone())
    };
    let last = now.rows.len().saturating_sub(1);
    let text = copied(state);
    let (send, edited, finish) = (send.clone(), edited.clone(), finish.clone());
    Callback::from(move |event: KeyboardEvent| {
        // A field that has been left is there until the page is drawn.
        let others = if edited.drawn.is_some() {
            "[type=checkbox], button"
        } else {
            "input, button"
        };
        if crate::keys::is_in(&event, others) && event.key() != "Tab" {
            return;
        }
        let at = edited.at.get();
        let (key, ctrl) = (event.key(), event.ctrl_key() || event.meta_key());
        if let Some((row, column, text)) = edited.by_now.get() {
            // The field is on its way.
            match (key.as_str(), ctrl) {
                ("Enter", false) => finish.emit((Some(text), (0, 1))),
                ("Tab", false) => finish.emit((Some(text), (1, 0))),
                (letter, false) if letter.chars().count() == 1 => {
                    edited.set(Some((row, column, text + letter)));
                }
                _ => return,
            }
            event.prevent_default();
            return event.stop_propagation();
        }
        let begin = |text: String| {
            if !at.1.is_result() {
                edited.set(Some((at.0, at.1, text)));
            }
        };
        let by = match (key.as_str(), ctrl) {
            ("ArrowLeft", false) => (-1, 0),
            ("ArrowRight", false) => (1, 0),
            ("ArrowUp", false) => (0, -1),
            ("ArrowDown", false) => (0, 1),
            ("PageUp", false) => (0, -10),
            ("PageDown", false) => (0, 10),
            ("Home", false) => (-8, 0),
            ("End", false) => (8, 0),
            ("Home", true) => (-8, i32::MIN),
            ("End", true) => (8, i32::MAX),
            ("Enter" | "F2", false) => {
                begin(here(at).unwrap_or_default());
                (0, 0)
            }
            ("Delete" | "Backspace", false) => {
                send.emit(Action::Robots(RobotsAction::Type(
                    at.0,
                    at.1,
                    String::new(),
                )));
                (0, 0)
            }
            (" ", false) => {
                send.emit(Action::Robots(RobotsAction::Select(at.0)));
                (0, 0)
            }
            ("a" | "A", true) => {
                send.emit(Action::Robots(RobotsAction::SelectAll));
                (0, 0)
            }
            ("c" | "C", true) => {
                copy::table(&text, &send);
                (0, 0)
            }
            (letter, false) if letter.chars().count() == 1 && !event.alt_key() => {
                begin(letter.to_owned());
                (0, 0)
            }
            _ => return,
        };
        event.prevent_default();
        event.stop_propagation();
        edited.go(by, last, &send);
    })
}

/// The cell so many columns right and rows down, as far as there are some.
fn moved(
    (row, column): (usize, Column),
    (right, down): (i32, i32),
    last: usize,
) -> (usize, Column) {
    let go = |from: usize, by: i32, last: usize| {
        let by = isize::try_from(by).unwrap_or(0);
        from.saturating_add_signed(by).min(last)
    };
    let place = Column::ALL
        .iter()
        .position(|&own| own == column)
        .unwrap_or(0);
    let place = go(place, right, Column::ALL.len() - 1);
    (go(row, down, last), Column::ALL[place])
}
