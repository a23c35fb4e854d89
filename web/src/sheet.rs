//! The page on paper: while the browser prints, the scene's board, its answer and the plan
//! table stand in the place of what is pressed (`static/css/print.css`).

use std::ops::Range;
use std::pin::pin;
use std::rc::Rc;
use std::task;

use giveway_model::tr;
use giveway_page::board::Cast;
use giveway_page::sheet::{Row, Sheet, Table};
use gloo::events::EventListener;
use yew::prelude::*;

use crate::board::PaperBoardProps;
use crate::board::{PaperBoard, hatch};
use crate::part;
use crate::{Shown, glyph};

/// Whether the browser is printing the page.
#[hook]
pub(crate) fn use_printing() -> bool {
    use_between("beforeprint", "afterprint")
}

/// Whether the window has had an event, and not yet the one that ends it. What changes by
/// that is rendered before the event returns.
#[hook]
pub(crate) fn use_between(begin: &'static str, end: &'static str) -> bool {
    let is_between = use_state_eq(|| false);
    let setter = is_between.setter();
    use_effect_with((), move |()| {
        let window = gloo::utils::window();
        let listen = |event: &'static str, is_on: bool| {
            let setter = setter.clone();
            EventListener::new(&window, event, move |_| {
                setter.set(is_on);
                render_now();
            })
        };
        let listening = [listen(begin, true), listen(end, false)];
        move || drop(listening)
    });
    *is_between
}

/// Renders what is due before it returns. The browser prints as soon as its event returns;
/// Yew would render in a later task, and after a pause where another render was on its way.
fn render_now() {
    let mut flush = pin!(yew::scheduler::flush());
    // The first poll renders. What it may then wait for is a pause that has nothing left to do.
    let mut context = task::Context::from_waker(task::Waker::noop());
    let _ = flush.as_mut().poll(&mut context);
}

/// What stands before the answer: title, sentence, board, signs.
pub(crate) fn head(state: &Shown) -> Html {
    let cast = Rc::new(Cast::by(state, state.shown()));
    let sheet = Sheet::of(state, &cast);
    html! {
        <header class="paper paper-head">
            <p class="where">{ "Giveway" }</p>
            <h1>{ sheet.title.clone() }</h1>
            if !sheet.standing.is_empty() { <p class="stand">{ sheet.standing.clone() }</p> }
            <p class="where">{ sheet.facts.join("; ") }</p>
            <svg class="vh" aria-hidden="true">{ hatch("hatch-paper") }</svg>
            <figure>{ part::part::<PaperBoard>(PaperBoardProps { state: state.clone(), cast }) }</figure>
            <ul class="legend">{ for sheet.signs.iter().map(|kind| html! { <li><i class={kind.class()}></i>{ kind.on_paper() }</li> }) }</ul>
        </header>
    }
}

/// What stands behind the answer: the plan table.
pub(crate) fn foot(state: &Shown) -> Html {
    let cast = Rc::new(Cast::by(state, state.shown()));
    let Some(table) = Sheet::of(state, &cast).table else {
        return html! {};
    };
    html! {
        <section class="paper paper-plan">
            <h2>{ tr!("Plan") }</h2>
            if let Some(why) = &table.left_out {
                <p>{ why.clone() }</p>
            } else {
                <p class="where">{ table.caption() }</p>
                { for table.parts.iter().map(|robots| part(&table, robots)) }
            }
        </section>
    }
}

/// The table of some robots: its head stands on each page anew.
fn part(table: &Table, robots: &Range<usize>) -> Html {
    let head = |(look, name): (usize, &str)| {
        html! { <th scope="col">{ glyph::show(look, "cost-glyph") }<bdi>{ name.to_owned() }</bdi></th> }
    };
    let row = |row: &Row| match *row {
        Row::Time(time) => {
            let entries = table.row(robots, time);
            html! { <tr><th scope="row">{ time }</th>{ for entries.map(|entry| html! { <td>{ entry }</td> }) }</tr> }
        }
        Row::Still(first, last) => {
            html! {
                <tr class="still">
                    <th scope="row">{ format!("{first}\u{2013}{last}") }</th>
                    <td colspan={robots.len().to_string()}>{ tr!("Nobody moves: all as in the row above.") }</td>
                </tr>
            }
        }
    };
    html! {
        <table>
            <thead><tr><th scope="col">{ tr!("Time") }</th>{ for table.heads(robots).map(head) }</tr></thead>
            <tbody>{ for table.rows.iter().map(row) }</tbody>
        </table>
    }
}
