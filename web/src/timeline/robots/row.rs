//! A row of the table of the robots, and what cannot be so in it.

use giveway_model::tr;
use giveway_page::robots::{Column, Fault, RobotsAction, Row, Table};
use giveway_page::{Action, BoardAction, Selection};
use wasm_bindgen::JsCast as _;
use web_sys::{HtmlElement, HtmlInputElement};
use yew::prelude::*;

use super::{Editing, Finish};
use crate::{glyph, icon};

/// The cell that is edited, its field, and what its end is told.
pub(super) struct Entry<'a> {
    pub(super) edited: &'a Editing,
    pub(super) field: &'a NodeRef,
    pub(super) finish: &'a Finish,
}

pub(super) fn show_row(
    index: usize,
    row: &Row,
    now: &Table,
    Entry {
        edited,
        field,
        finish,
    }: &Entry<'_>,
    send: &Callback<Action>,
) -> Html {
    let select = send.reform(move |_: Event| Action::Robots(RobotsAction::Select(index)));
    let name = row
        .cells
        .first()
        .map(|cell| cell.text.clone())
        .unwrap_or_default();
    let cell = |(&column, cell): (&Column, &giveway_page::robots::Cell)| {
        let editing = edited
            .drawn
            .as_ref()
            .filter(|(at, own, _)| (*at, *own) == (index, column));
        let is_at = now.at == (index, column);
        let class = classes!(
            cell.is_faulty.then_some("bad"),
            cell.is_new.then_some("new"),
            column.is_result().then_some("result"),
            is_at.then_some("at")
        );
        let fault = row.faults.iter().find(|fault| fault.column == column);
        let onclick = {
            let (send, agent) = (send.clone(), row.agent);
            Callback::from(move |_: MouseEvent| {
                send.emit(Action::Robots(RobotsAction::Focus(index, column)));
                if let (Column::Name, Some(agent)) = (column, agent) {
                    send.emit(Action::Board(BoardAction::Select(Selection::Agent(agent))));
                }
            })
        };
        let ondblclick = {
            let (edited, text) = ((*edited).clone(), cell.text.clone());
            Callback::from(move |_: MouseEvent| {
                if !column.is_result() {
                    edited.set(Some((index, column, text.clone())));
                }
            })
        };
        html! {
            <td role="gridcell" {class} tabindex={if is_at { "0" } else { "-1" }} aria-invalid={cell.is_faulty.then_some("true")} aria-description={fault.map(|fault| fault.why.clone())} aria-readonly={column.is_result().then_some("true")} {onclick} {ondblclick}>
                if column == Column::Name && let Some(agent) = row.agent { { glyph::show(agent, "choice-glyph") } }
                if let Some((_, _, text)) = editing {
                    { entry(text.clone(), column, field, edited, finish) }
                } else {
                    { cell.text.clone() }
                }
            </td>
        }
    };
    html! {
        <tr aria-selected={row.is_selected.to_string()}>
            <td><input type="checkbox" tabindex="-1" aria-label={tr!("Select {name}", name)} checked={row.is_selected} disabled={row.agent.is_none()} onchange={select} /></td>
            { for Column::ALL.iter().zip(&row.cells).map(cell) }
        </tr>
    }
}

/// The field of the cell that is edited. Enter and Tab go on, Escape takes it back.
fn entry(text: String, column: Column, field: &NodeRef, edited: &Editing, finish: &Finish) -> Html {
    let value = |field: &NodeRef| field.cast::<HtmlInputElement>().map(|input| input.value());
    let onkeydown = {
        let (field, finish, edited) = (field.clone(), finish.clone(), edited.clone());
        Callback::from(move |event: KeyboardEvent| {
            if edited.by_now.get().is_none() {
                // It has been left: the key is for the table.
                return;
            }
            let back = if event.shift_key() { -1 } else { 1 };
            let on = match event.key().as_str() {
                "Enter" => (0, back),
                "Tab" => (back, 0),
                "Escape" => (0, 0),
                _ => return event.stop_propagation(),
            };
            event.prevent_default();
            event.stop_propagation();
            let text = if event.key() == "Escape" {
                None
            } else {
                value(&field)
            };
            finish.emit((text, on));
            // Keys that come before the page is drawn are for the table.
            let cell = event.target_dyn_into::<HtmlElement>();
            let cell = cell.and_then(|field| field.parent_element());
            if let Some(cell) = cell.and_then(|cell| cell.dyn_into::<HtmlElement>().ok()) {
                let _ = cell.focus();
            }
        })
    };
    let onblur = {
        let (field, finish) = (field.clone(), finish.clone());
        Callback::from(move |_: FocusEvent| finish.emit((value(&field), (0, 0))))
    };
    html! { <input type="text" ref={field.clone()} aria-label={column.name()} value={text} {onkeydown} {onblur} /> }
}

pub(super) fn show_fault(index: usize, fault: &Fault, send: &Callback<Action>) -> Html {
    let column = fault.column;
    let remedy = fault.remedy.as_ref().map(|(offer, _)| {
        let onclick =
            send.reform(move |_: MouseEvent| Action::Robots(RobotsAction::Remedy(index, column)));
        html! { <button type="button" class="link" {onclick}>{ offer.clone() }</button> }
    });
    html! {
        <tr class="rfault"><td></td><td colspan="8">{ icon::show("warning") }<b>{ column.name() }</b>{ " " }{ fault.why.clone() }{ " " }{ remedy }</td></tr>
    }
}
