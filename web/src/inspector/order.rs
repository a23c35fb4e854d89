//! The order at a cell: who passes it, what follows if a robot is late, files.

mod links;

use giveway_model::tr;
use giveway_page::order::{
    ArrivalRow, Column, ExportRow, LateCard, MOST_LATE, OrderAction, PassRow,
};
use giveway_page::{Action, State, number};
use web_sys::HtmlSelectElement;
use yew::prelude::*;

use crate::field::{Slot, SlotProps};
use crate::part::part;
use crate::{glyph, icon};

use links::table;

fn act(send: &Callback<Action>, action: OrderAction) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Order(action))
}

/// The question among those about the plan.
#[inline(never)]
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    if !state.offers_order() {
        return Html::default();
    }
    html! {
        <ul class="asks">
            <li><button type="button" class="ask" onclick={act(send, OrderAction::Show(true))}>
                { icon::show("order") }
                <span>{ tr!("Who passes after whom?") }<small>{ tr!("the order that late robots can keep") }</small></span>
                { icon::at_end("chevron") }
            </button></li>
        </ul>
    }
}

/// What scrolls of it.
#[inline(never)]
pub(super) fn show(column: &Column, send: &Callback<Action>) -> Html {
    if let Some(late) = &column.late {
        return late_card(column, late, send);
    }
    if let Some(links) = &column.table {
        return table(&column.title, links, send);
    }
    html! {
        <>
            <header class="qh">
                <button type="button" class="crumb" onclick={act(send, OrderAction::Show(false))}>{ icon::show("back") }{ tr!("Whole plan") }</button>
                <h2>{ column.title.clone() }</h2>
                <p class="lead" role="status">{ column.lead.clone() }</p>
            </header>
            if !column.rows.is_empty() {
                <section>
                    { passes(&column.rows) }
                    <p class="remark">{ tr!("Slack: so many steps may pass before the next one has to wait.") }</p>
                </section>
            }
            if !column.exports.is_empty() {
                <ul class="asks">
                    <li><button type="button" class="ask" onclick={act(send, OrderAction::Late(true))}>
                        { icon::show("clock") }
                        <span>{ tr!("What if a robot is late?") }<small>{ tr!("who is pushed, and by how much") }</small></span>
                        { icon::at_end("chevron") }
                    </button></li>
                </ul>
                { whole(column, send) }
                <section>
                    <h3>{ tr!("Hand on") }</h3>
                    <ul class="asks">{ for column.exports.iter().map(|row| export(row, send)) }</ul>
                </section>
            }
            { pending(column) }
        </>
    }
}

/// What stays at the foot of it.
#[inline(never)]
pub(super) fn foot(column: &Column, send: &Callback<Action>) -> Html {
    let leaves = match column.late {
        Some(_) => OrderAction::Late(false),
        None if column.table.is_some() => OrderAction::Links(false),
        None => OrderAction::Show(false),
    };
    let replan = column.late.as_ref().and_then(|late| late.replan.clone());
    let is_broken = column.late.as_ref().is_some_and(|it| !it.broken.is_empty());
    let class = if is_broken { "primary" } else { "outline" };
    let export = column.export;
    html! {
        <footer class="foot">
            if column.late.is_none() && !column.exports.is_empty() {
                <button type="button" class="btn primary" onclick={act(send, OrderAction::Save(export))}>
                    { icon::show("save") }{ tr!("Export: {file}", file = export.name()) }
                </button>
            }
            if let Some(name) = replan {
                <button type="button" class={classes!("btn", class)} onclick={act(send, OrderAction::Replan)}>{ icon::show("change") }{ name }</button>
            }
            <button type="button" class="btn outline" onclick={act(send, leaves)}>{ tr!("Done") }</button>
        </footer>
    }
}

fn pending(column: &Column) -> Html {
    html! { if let Some(line) = column.pending { <ul class="pending"><li>{ line }</li></ul> } }
}

/// Who passes the cell, in order.
fn passes(rows: &[PassRow]) -> Html {
    let row = |row: &PassRow| {
        html! {
            <tr class={classes!(row.is_in.then_some("in"))}>
                <th scope="row">{ robot(row.agent, &row.name) }</th>
                <td>{ row.comes.clone() }</td><td>{ row.leaves.clone() }</td>
                <td class={classes!(row.is_tight.then_some("tight"))}>{ row.slack.clone() }</td>
            </tr>
        }
    };
    html! {
        <table class="compare by-order" aria-label={tr!("Who passes, in order")}>
            <thead><tr>
                <th scope="col">{ tr!("Robot") }</th><th scope="col">{ tr!("a robot" => "comes") }</th>
                <th scope="col">{ tr!("a robot" => "is out") }</th><th scope="col">{ tr!("slack") }</th>
            </tr></thead>
            <tbody>{ for rows.iter().map(row) }</tbody>
        </table>
    }
}

fn robot(agent: Option<usize>, name: &str) -> Html {
    html! {
        <span class="whom">
            if let Some(agent) = agent { { glyph::show(agent, "cost-glyph") } }
            <bdi>{ name.to_owned() }</bdi>
        </span>
    }
}

/// All links of the plan: how many, the rule against those without slack, rotations, losses.
fn whole(column: &Column, send: &Callback<Action>) -> Html {
    let line = |text: &String| html! { <li>{ text.clone() }</li> };
    html! {
        <section class="order-whole">
            <h3>{ tr!("The whole plan") }</h3>
            <p>{ column.links.clone() }</p>
            if let Some(all) = &column.all {
                <button type="button" class="btn outline" onclick={act(send, OrderAction::Links(true))}>{ icon::show("order") }{ all.clone() }</button>
            }
            if let Some(tight) = &column.tight { <p>{ tight.clone() }</p> }
            if let Some(gap) = &column.gap {
                <button type="button" class="btn outline" onclick={act(send, OrderAction::AddGap)}>{ icon::show("gap") }{ gap.clone() }</button>
            }
            if !column.rotations.is_empty() || !column.losses.is_empty() {
                <ul class="order-notes">
                    { for column.rotations.iter().map(line) }
                    { for column.losses.iter().map(line) }
                </ul>
            }
        </section>
    }
}

fn export(row: &ExportRow, send: &Callback<Action>) -> Html {
    html! {
        <li><button type="button" class="ask" onclick={act(send, OrderAction::Save(row.export))}>
            { icon::show("save") }<span>{ row.name }<small>{ row.detail }</small></span>
        </button></li>
    }
}

/// The sentence with its slots, and what follows.
fn late_card(column: &Column, late: &LateCard, send: &Callback<Action>) -> Html {
    let robots: Vec<(String, bool)> = late.robots.clone();
    let cells = late.cells.iter();
    let cells: Vec<(String, bool)> = cells.map(|it| (it.1.clone(), it.2)).collect();
    let visits: Vec<usize> = late.cells.iter().map(|it| it.0).collect();
    let to = move |chosen: usize| OrderAction::To(visits.get(chosen).copied().unwrap_or(0));
    let line =
        |text: &String| html! { <li>{ icon::show("warning") }<span>{ text.clone() }</span></li> };
    html! {
        <>
            <header class="qh">
                <button type="button" class="crumb" onclick={act(send, OrderAction::Late(false))}>{ icon::show("back") }{ column.title.clone() }</button>
                <h2>{ tr!("What if a robot is late?") }</h2>
            </header>
            <p class="late-sentence" role="group" aria-label={tr!("A robot that is late")}>
                { choice(tr!("The late robot"), &robots, send, OrderAction::Robot) }
                { " " }{ tr!("a robot is late" => "comes") }{ " " }
                { steps(late.steps, send) }
                { " " }{ tr!("a robot is late" => "steps late to") }{ " " }
                { choice(tr!("The cell that it comes late to"), &cells, send, to) }
            </p>
            <div aria-live="polite">
                if let Some(title) = &late.title {
                    <div class="verdict unknown">
                        <p class="vb">{ icon::show("clock") }<b>{ title.clone() }</b></p>
                        <p class="vs">{ late.sentence.clone() }</p>
                    </div>
                }
                if !late.broken.is_empty() {
                    <section class="late-broken">
                        <h3>{ tr!("This does not go well then") }</h3>
                        <ul>{ for late.broken.iter().map(line) }</ul>
                    </section>
                }
            </div>
            if !late.arrivals.is_empty() {
                { arrivals(&late.arrivals) }
                <p class="remark">{ tr!("From the links alone: nothing is planned anew.") }</p>
            }
            { pending(column) }
        </>
    }
}

fn steps(value: u32, send: &Callback<Action>) -> Html {
    let range = (1, MOST_LATE);
    let send = send.clone();
    let on_change = Callback::from(move |typed: String| {
        if let Some(steps) = number::read(&typed, range) {
            send.emit(Action::Order(OrderAction::Steps(steps)));
        }
    });
    html! { { part::<Slot>(SlotProps { name: tr!("Steps late"), value: value.to_string().into(), empty: None, range: Some(range), on_change }) } }
}

/// A list of which one is chosen.
fn choice(
    name: &'static str,
    choices: &[(String, bool)],
    send: &Callback<Action>,
    action: impl Fn(usize) -> OrderAction + 'static,
) -> Html {
    let onchange = send.reform(move |event: Event| {
        let list: HtmlSelectElement = event.target_unchecked_into();
        Action::Order(action(usize::try_from(list.selected_index()).unwrap_or(0)))
    });
    html! {
        <select class="field" aria-label={name} {onchange}>
            { for choices.iter().map(|(words, is_chosen)| html! { <option selected={*is_chosen}>{ words.clone() }</option> }) }
        </select>
    }
}

fn arrivals(rows: &[ArrivalRow]) -> Html {
    let row = |row: &ArrivalRow| {
        let by = if row.is_late { "worse" } else { "same" };
        html! {
            <tr class={classes!(row.agent.is_none().then_some("sum"))}>
                <th scope="row">{ robot(row.agent, &row.name) }</th>
                <td>{ row.planned }</td><td>{ row.now.clone() }</td><td class={classes!("d", by)}>{ row.by.clone() }</td>
            </tr>
        }
    };
    html! {
        <table class="compare by-order" aria-label={tr!("When each robot arrives")}>
            <thead><tr>
                <th scope="col">{ tr!("a robot" => "Arrives") }</th><th scope="col">{ tr!("a time" => "planned") }</th>
                <th scope="col">{ tr!("a time" => "now") }</th><th scope="col"><span class="vh">{ tr!("later by") }</span></th>
            </tr></thead>
            <tbody>{ for rows.iter().map(row) }</tbody>
        </table>
    }
}
