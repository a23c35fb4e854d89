//! What all best plans share: told of the plan as a whole, of the robot or cell
//! selected, and of a cell that is closed for a look.

use giveway_model::{Cell, tr};
use giveway_page::freedom::{
    CellRow, Cells, Chip, Column, FreedomAction, Late, Other, Row, Section, TITLE, Ways, chip,
};
use giveway_page::{Action, BoardAction, Selection, State};
use yew::prelude::*;

use super::proof;
use crate::{glyph, icon};

/// What is told of the plan as a whole.
#[inline(never)]
pub(super) fn show(column: &Column, save: Html, is_wide: bool, send: &Callback<Action>) -> Html {
    html! {
        <div class="freedom-told">
            <header class="qh">
                <button type="button" class="crumb" onclick={act(FreedomAction::Show(false), send)}>
                    { icon::show("back") }{ tr!("Whole plan") }
                </button>
                <h2>{ TITLE.text() }</h2>
                <p class="lead">{ column.lead.clone() }</p>
            </header>
            { stopped(column, send) }
            if let Some(found) = &column.ways { { section(tr!("Ways to choose from"), found, |found| ways(found, send)) } }
            { section(tr!("Who may be late"), &column.late, |found| late(found, send)) }
            { section(tr!("Cells that matter"), &column.cells, |found| cells(found, send)) }
            if let Some(found) = &column.other {
                { section(tr!("Another plan as good"), found, |found| other(found, is_wide, send)) }
            }
            if let Some(reach) = &column.reach { <p class="remark">{ reach.clone() }</p> }
            { save }
        </div>
    }
}

fn act(action: FreedomAction, send: &Callback<Action>) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Freedom(action))
}

/// That something is open, and the button that looks for it.
fn stopped(column: &Column, send: &Callback<Action>) -> Html {
    let Some(why) = &column.stopped else {
        return Html::default();
    };
    html! {
        <div class="cut-off">
            <p>{ why.clone() }</p>
            <button type="button" class="btn outline" onclick={act(FreedomAction::GoOn, send)}>
                { icon::show("search") }<span>{ tr!("Look for the rest") }</span>
            </button>
        </div>
    }
}

/// A part with its title; its place is kept while it is being looked for.
fn section<T>(title: &'static str, found: &Section<T>, told: impl Fn(&T) -> Html) -> Html {
    html! {
        <section>
            <h3>{ title }</h3>
            { match found {
                Section::Known(found) => told(found),
                Section::Coming => html! { <ul class="pending"><li>{ tr!("Looking") }</li></ul> },
                Section::Open => html! { <p class="remark">{ tr!("Not found out.") }</p> },
            } }
        </section>
    }
}

/// Robots, each with what is told of it; pressing one selects it.
fn rows(rows: &[Row], send: &Callback<Action>) -> Html {
    let row = |row: &Row| {
        let agent = row.agent;
        let select = Action::Board(BoardAction::Select(Selection::Agent(agent)));
        html! {
            <li key={agent}><button type="button" class="frow" onclick={send.reform(move |_| select.clone())}>
                { glyph::show(agent, "choice-glyph") }
                <span>{ row.title.clone() }<small>{ row.detail.clone() }</small></span>
                <em class={classes!(row.is_fixed.then_some("fixed"))}>{ row.value.clone() }</em>
            </button></li>
        }
    };
    if rows.is_empty() {
        return Html::default();
    }
    html! { <ul class="frows">{ for rows.iter().map(row) }</ul> }
}

fn ways(ways: &Ways, send: &Callback<Action>) -> Html {
    html! { <>{ rows(&ways.rows, send) }<p class="remark">{ ways.sum.clone() }</p></> }
}

fn late(late: &Late, send: &Callback<Action>) -> Html {
    html! {
        <>
            { rows(&late.rows, send) }
            if let Some(nobody) = &late.nobody { <p class="remark">{ nobody.clone() }</p> }
        </>
    }
}

fn cells(cells: &Cells, send: &Callback<Action>) -> Html {
    let row = |row: &CellRow| html! { <li key={row.title.clone()}>{ close(row.cell, &row.title, &row.detail, send) }</li> };
    html! {
        <>
            if !cells.rows.is_empty() { <ul class="asks">{ for cells.rows.iter().map(row) }</ul> }
            if let Some(remark) = &cells.remark { <p class="remark">{ remark.clone() }</p> }
        </>
    }
}

/// What closes a cell for a look.
fn close(cell: Cell, title: &str, detail: &str, send: &Callback<Action>) -> Html {
    html! {
        <button type="button" class="ask" onclick={act(FreedomAction::Close(cell), send)}>
            { icon::show("obstacle") }
            <span>{ title.to_owned() }<small>{ detail.to_owned() }</small></span>
            { icon::at_end("chevron") }
        </button>
    }
}

fn other(other: &Other, is_wide: bool, send: &Callback<Action>) -> Html {
    let words = match (other.is_shown, is_wide) {
        (false, true) => tr!("Show it beside this one"),
        (false, false) => tr!("Show it"),
        (true, true) => tr!("One plan"),
        (true, false) => tr!("Show this plan"),
    };
    html! {
        <>
            <p class="remark">{ other.sentence.clone() }</p>
            <button type="button" class="btn outline more" aria-pressed={other.is_shown.to_string()}
                onclick={act(FreedomAction::ShowOther(!other.is_shown), send)}>
                { icon::show("compare") }<span>{ words }</span>
            </button>
        </>
    }
}

/// What begins it, at a plan that is proved a best one.
#[inline(never)]
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    if chip(state) != Chip::Ready {
        return Html::default();
    }
    html! {
        <ul class="asks"><li><button type="button" class="ask" onclick={act(FreedomAction::Show(true), send)}>
            { icon::show("free") }
            <span>{ tr!("What do all best plans share?") }</span>
            { icon::at_end("chevron") }
        </button></li></ul>
    }
}

/// What all best plans share of the robot or the cell selected, or what could be asked of it.
pub(super) fn part(state: &State, send: &Callback<Action>) -> Html {
    let Some(part) = giveway_page::freedom::part(state) else {
        return Html::default();
    };
    let ask = |ask: &String| {
        html! {
            <li key={ask.clone()}><button type="button" class="ask" onclick={act(FreedomAction::Ask, send)}>
                { icon::show("free") }<span>{ ask.clone() }</span>{ icon::at_end("chevron") }
            </button></li>
        }
    };
    html! {
        <section class="must-be-told">
            <h3>{ TITLE.text() }</h3>
            { for part.facts.iter().map(|fact| html! { <p>{ fact.clone() }</p> }) }
            if !part.asks.is_empty() || part.closing.is_some() {
                <ul class="asks">
                    { for part.asks.iter().map(ask) }
                    if let Some((cell, title)) = &part.closing { <li>{ close(*cell, title, "", send) }</li> }
                </ul>
            }
            if chip(state) == Chip::On { { proof::saving(state, send) } }
        </section>
    }
}

/// A cell that is closed for a look, what that comes to, and the way back.
pub(super) fn closed(state: &State, send: &Callback<Action>) -> Html {
    let Some(closed) = state.closed_cell() else {
        return Html::default();
    };
    html! {
        <div class="verdict costly closed-cell" role="group" aria-label={tr!("Closed for a look")}>
            <p class="vb">{ icon::show("obstacle") }<b>{ closed.title() }</b></p>
            <p class="vs">{ closed.sentence.clone() }</p>
            <button type="button" class="btn outline" title={tr!("Open it again (Escape)")} onclick={act(FreedomAction::Open, send)}>
                { icon::show("undo") }<span>{ tr!("Open it again") }</span>
            </button>
        </div>
    }
}
