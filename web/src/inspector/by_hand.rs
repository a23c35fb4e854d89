//! The column of a search by hand.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::inside::by_hand::{Branch, ConflictRow, HandColumn, RobotRow, StepRow, TallyRow};
use giveway_page::inside::{HandAction, InsideAction};
use gloo::timers::callback::Timeout;
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;
use yew::prelude::*;

use super::inside::{button, told};
use crate::{glyph, icon};

#[derive(Clone, PartialEq, Properties)]
pub(super) struct HandProps {
    pub(super) column: HandColumn,
    pub(super) send: Callback<Action>,
}

fn act(action: HandAction) -> Action {
    Action::Inside(InsideAction::Hand(action))
}

/// What scrolls, and what stays at its foot.
#[component]
pub(super) fn Hand(props: &HandProps) -> Html {
    let HandProps { column, send } = props;
    use_effect_with(column.title.clone(), |_| super::to_top());
    let has_buttons = column.is_in_lesson || !column.conflicts.is_empty();
    html! {
        <>
            <div class="scroll" key="by hand" tabindex={(!has_buttons).then_some("0")}>
                <header class="qh">
                    if column.is_in_lesson {
                        <button type="button" class="crumb" onclick={send.reform(|_| act(HandAction::Read(true)))}>{ icon::show("back") }{ tr!("Lesson") }</button>
                    }
                    <h2>{ column.title.clone() }</h2>
                    if !column.lead.is_empty() { <p class="lead">{ column.lead.clone() }</p> }
                </header>
                if let Some(verdict) = &column.verdict { { told(verdict) } }
                if !column.table.is_empty() { { table(&column.table) } }
                if !column.conflicts.is_empty() { { conflicts(column, send) } }
                if !column.robots.is_empty() { { split(column, send) } }
                if !column.steps.is_empty() {
                    <section>
                        <h3>{ column.steps_title.clone() }</h3>
                        <ol class="cons hsteps">{ for column.steps.iter().map(step) }</ol>
                    </section>
                }
                if let Some(remark) = &column.remark { <p class="remark">{ remark.clone() }</p> }
            </div>
            <footer class="foot">{ for column.foot.iter().map(|one| button(one, send)) }</footer>
        </>
    }
}

/// The arrow keys choose one of some; Enter splits.
fn choosing(
    (at, count): (usize, usize),
    choose: fn(usize) -> HandAction,
    (within, send): (&'static str, &Callback<Action>),
) -> Callback<KeyboardEvent> {
    let send = send.clone();
    Callback::from(move |event: KeyboardEvent| {
        let action = match event.key().as_str() {
            "ArrowDown" | "ArrowRight" => choose((at + 1) % count),
            "ArrowUp" | "ArrowLeft" => choose((at + count - 1) % count),
            "Enter" if !event.repeat() => HandAction::Split,
            _ => return,
        };
        event.prevent_default();
        event.stop_propagation();
        send.emit(act(action));
        keep_focus(within);
    })
}

/// Brings the focus to the chosen one of some, once it is drawn.
fn keep_focus(within: &'static str) {
    let focus = move || {
        let chosen = format!("{within} [aria-checked=true]");
        if let Ok(Some(chosen)) = gloo::utils::document().query_selector(&chosen)
            && let Ok(chosen) = chosen.dyn_into::<HtmlElement>()
        {
            let _ = chosen.focus();
        }
    };
    Timeout::new(0, focus).forget();
}

fn conflicts(column: &HandColumn, send: &Callback<Action>) -> Html {
    let at = column
        .conflicts
        .iter()
        .position(|row| row.is_on)
        .unwrap_or(0);
    let keys = choosing(
        (at, column.conflicts.len()),
        HandAction::Conflict,
        (".cfls", send),
    );
    let row = |(place, row): (usize, &ConflictRow)| {
        let [(a, first), (b, second)] = &row.robots;
        let title = (place < 9).then(|| tr!("Key {n}", n = place + 1));
        html! {
            <button type="button" role="radio" class="cfl" aria-checked={row.is_on.to_string()} aria-label={row.name.clone()} {title}
                tabindex={if row.is_on { "0" } else { "-1" }} onclick={send.reform(move |_| act(HandAction::Conflict(place)))}>
                <span>{ robot(*a) }<b>{ first.clone() }</b><em>{ format!(" {} ", row.verb) }</em>{ robot(*b) }<b>{ second.clone() }</b></span>
                <small>{ row.place.clone() }</small>
            </button>
        }
    };
    html! {
        <div>
            <div class="cfls" role="radiogroup" aria-label={tr!("Conflict to split on")} onkeydown={keys}>
                { for column.conflicts.iter().enumerate().map(row) }
            </div>
            if let Some(more) = &column.more { <p class="remark">{ more.clone() }</p> }
        </div>
    }
}

fn robot(agent: Option<usize>) -> Html {
    match agent {
        Some(agent) => glyph::show(agent, "cost-glyph"),
        None => html! {},
    }
}

/// The robot that the split names, and what it gives.
fn split(column: &HandColumn, send: &Callback<Action>) -> Html {
    let at = column.robots.iter().position(|row| row.is_on).unwrap_or(0);
    let keys = choosing(
        (at, column.robots.len()),
        HandAction::Robot,
        (".split-on", send),
    );
    let one = |(place, row): (usize, &RobotRow)| {
        html! {
            <button type="button" role="radio" aria-checked={row.is_on.to_string()} tabindex={if row.is_on { "0" } else { "-1" }}
                onclick={send.reform(move |_| act(HandAction::Robot(place)))}>{ robot(row.agent) }{ row.name.clone() }</button>
        }
    };
    html! {
        <section>
            <div class="sph">
                <h3 id="split-on">{ tr!("Split on") }</h3>
                <div class="seg split-on" role="radiogroup" aria-labelledby="split-on" onkeydown={keys}>{ for column.robots.iter().enumerate().map(one) }</div>
            </div>
            <ul class="cons kids">{ for column.branches.iter().map(branch) }</ul>
        </section>
    }
}

fn branch(branch: &Branch) -> Html {
    html! {
        <li>
            if let Some(agent) = branch.agent { { glyph::show(agent, "cons-glyph") } }
            <span>{ branch.text.clone() }<small>{ branch.small.clone() }</small></span>
            <b>{ branch.cost.clone() }</b>
        </li>
    }
}

fn step(row: &StepRow) -> Html {
    html! {
        <li>
            <b>{ row.cost.clone() }</b>
            <span>{ row.text.clone() }<small>{ row.gave.clone() }</small><small>{ icon::show("tree") }{ row.planner.clone() }</small></span>
        </li>
    }
}

fn table(rows: &[TallyRow]) -> Html {
    let row = |row: &TallyRow| {
        html! { <tr><th scope="row">{ row.name.clone() }</th><td>{ row.own.clone() }</td><td>{ row.planner.clone() }</td></tr> }
    };
    html! {
        <table class="compare" aria-label={tr!("What it took")}>
            <thead><tr><td></td><th scope="col">{ tr!("You") }</th><th scope="col">{ tr!("who splits" => "Planner") }</th></tr></thead>
            <tbody>{ for rows.iter().map(row) }</tbody>
        </table>
    }
}
