//! The table of the robots below the board: edited by keys as a spreadsheet is.

mod keys;
mod row;

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::robots::{CAPACITY, Column, RobotsAction, Table, copied, table};
use web_sys::{HtmlElement, HtmlInputElement};
use yew::prelude::*;

use super::{DockProps, places};
use crate::field::slot;
use crate::held::use_held;
use crate::{Shown, copy, icon};
use keys::{Editing, keys};
use row::{Entry, show_fault, show_row};

/// The cell that is edited: its row as shown, its column, and the text that it began with.
type Edited = Option<(usize, Column, String)>;

/// Takes what was typed, if it is to be so, and where the keyboard goes on: columns right, rows down.
type Finish = Callback<(Option<String>, (i32, i32))>;

/// The table, with what can be done with all of it above.
#[component]
pub(super) fn Robots(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    let edited = Editing {
        drawn: use_state_eq(|| Edited::None),
        by_now: use_held(|| Edited::None),
        at: use_held(|| (0, Column::Name)),
    };
    let was_edited = use_held(|| false);
    let field = use_node_ref();
    let grid = use_node_ref();
    let now = table(state);
    let at = now.as_ref().map_or((0, Column::Name), |table| table.at);
    {
        let (field, grid, was_edited) = (field.clone(), grid.clone(), was_edited.clone());
        let editing = edited
            .drawn
            .as_ref()
            .map(|(row, column, _)| (*row, *column));
        use_effect_with((editing, at), move |(editing, _)| {
            if editing.is_some() {
                if let Some(field) = field.cast::<HtmlInputElement>() {
                    let _ = field.focus();
                }
            } else if let Some(grid) = grid.cast::<HtmlElement>() {
                go_on(&grid, was_edited.get());
            }
            was_edited.set(editing.is_some());
        });
        let by_now = Rc::clone(&edited.at);
        use_effect_with(at, move |&at| by_now.set(at));
    }
    let Some(now) = now else {
        return Html::default();
    };
    let act =
        |action: RobotsAction| send.reform(move |_: MouseEvent| Action::Robots(action.clone()));
    let finish = {
        let (send, edited) = (send.clone(), edited.clone());
        Callback::from(move |(text, on): (Option<String>, (i32, i32))| {
            let Some((row, column, _)) = edited.by_now.get() else {
                return;
            };
            edited.set(None);
            if let Some(text) = text {
                send.emit(Action::Robots(RobotsAction::Type(row, column, text)));
            }
            edited.at.set((row, column));
            edited.go(on, usize::MAX, &send);
        })
    };
    let onkeydown = keys(&now, state, send, &edited, &finish);
    let entry = Entry {
        edited: &edited,
        field: &field,
        finish: &finish,
    };
    let body: Html = now
        .rows
        .iter()
        .enumerate()
        .map(|(index, row)| {
            html! {
                <>
                    { show_row(index, row, &now, &entry, send) }
                    { for row.faults.iter().map(|fault| show_fault(index, fault, send)) }
                </>
            }
        })
        .collect();
    html! {
        <section class="dock robots" aria-label={tr!("Robots")}>
            <div class="rhead">{ places(state, send) }<span class="grow"></span>{ tools(&now, state, send) }<button type="button" class="btn ghost round" aria-label={tr!("Close the table")} title={tr!("Close the table")} onclick={act(RobotsAction::Show(false))}>{ icon::show("cancel") }</button></div>
            if let Some(banner) = &now.banner {
                <div class="rbanner" role="status">
                    { icon::show("warning") }<p>{ banner.told.clone() }</p>
                    if let Some(take) = &banner.take { <button type="button" class="btn outline" onclick={act(RobotsAction::Take)}>{ take.clone() }</button> }
                    <button type="button" class="btn ghost" onclick={act(RobotsAction::Drop)}>{ tr!("Drop them") }</button>
                </div>
            }
            <div class="rscroll">
                <table role="grid" class="rgrid" aria-label={tr!("Robots")} aria-rowcount={(now.rows.len() + 1).to_string()} ref={grid} {onkeydown}>
                    <thead><tr>
                        <th><input type="checkbox" aria-label={tr!("Select all")} checked={now.selected > 0} onchange={send.reform(|_: Event| Action::Robots(RobotsAction::SelectAll))} /></th>
                        { for Column::ALL.iter().map(|&column| head(column, &now, send)) }
                    </tr></thead>
                    <tbody>{ body }</tbody>
                </table>
                if now.rows.is_empty() {
                    <p class="remark">{ if now.filter.is_empty() { tr!("No robots yet. Paste a table of them, or draw them on the board.") } else { tr!("No robot has that.") } }</p>
                }
            </div>
        </section>
    }
}

/// Leaves the keyboard on its cell, where it was in the table or in the field of a cell.
fn go_on(grid: &HtmlElement, was_edited: bool) {
    let now = gloo::utils::document().active_element();
    let is_in_grid = now.is_some_and(|now| grid.contains(Some(&now)) && now.tag_name() == "TD");
    let cell = grid.query_selector("td[tabindex='0']").ok().flatten();
    if let Some(cell) = cell.filter(|_| is_in_grid || was_edited)
        && let Ok(cell) = wasm_bindgen::JsCast::dyn_into::<HtmlElement>(cell)
    {
        let _ = cell.focus();
    }
}

fn tools(now: &Table, state: &Shown, send: &Callback<Action>) -> Html {
    let filter = send.reform(|event: InputEvent| {
        let input: HtmlInputElement = event.target_unchecked_into();
        Action::Robots(RobotsAction::Filter(input.value()))
    });
    let press = |name: String, sign: &'static str, action: RobotsAction| {
        let onclick = send.reform(move |_: MouseEvent| Action::Robots(action.clone()));
        html! { <button type="button" class="btn ghost round" aria-label={name.clone()} title={name} {onclick}>{ icon::show(sign) }</button> }
    };
    let text = copied(state);
    let copies = {
        let send = send.clone();
        Callback::from(move |_: MouseEvent| copy::table(&text, &send))
    };
    let saves = {
        let state = state.clone();
        Callback::from(move |_: MouseEvent| crate::files::save_robots(&state))
    };
    let level = {
        let send = send.clone();
        Callback::from(move |level: Option<u32>| {
            if let Some(level) = level {
                send.emit(Action::Robots(RobotsAction::Level(level)));
            }
        })
    };
    html! {
        <>
            if now.selected > 0 {
                <span class="rbattery">{ tr!("Battery") }{ slot(tr!("Battery of those selected, steps"), None, (0, CAPACITY), send.reform(|number| Action::Robots(RobotsAction::Battery(number)))) }</span>
                <span class="rbattery">{ tr!("At the start") }{ slot(tr!("Level at the start of those selected"), None, (0, CAPACITY), level) }</span>
                { press(tr!("Duplicate those selected").to_owned(), "plus", RobotsAction::Duplicate) }
                { press(tr!("Delete those selected").to_owned(), "erase", RobotsAction::Delete) }
            }
            <span class="rcount" role="status">{ now.count.clone() }</span>
            <input class="rfilter" type="search" placeholder={tr!("Filter")} aria-label={tr!("Filter robots")} title={tr!("A name, start 37, waits > 0, no battery")} value={now.filter.clone()} oninput={filter} />
            <button type="button" class="btn ghost round" aria-label={tr!("Copy for a spreadsheet")} title={tr!("Copy for a spreadsheet")} onclick={copies}>{ icon::show("copy") }</button>
            <button type="button" class="btn ghost round" aria-label={tr!("Save robots (CSV)")} title={tr!("Save robots (CSV)")} onclick={saves}>{ icon::show("save") }</button>
        </>
    }
}

fn head(column: Column, now: &Table, send: &Callback<Action>) -> Html {
    let onclick = send.reform(move |_: MouseEvent| Action::Robots(RobotsAction::Sort(column)));
    let sorted = now
        .sort
        .filter(|(own, _)| *own == column)
        .map(|(_, is_back)| is_back);
    let order = match sorted {
        Some(true) => "descending",
        Some(false) => "ascending",
        None => "none",
    };
    html! {
        <th scope="col" aria-sort={order}><button type="button" tabindex="-1" {onclick}>{ column.name() }if sorted.is_some() { { icon::show("down") } }</button></th>
    }
}
