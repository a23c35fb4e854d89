//! What the column says of a step of how the plan was found.

use giveway_model::tr;
use giveway_page::inside::{Button, Choice, Column, Fact, InsideAction, Listed, OrderRow, Verdict};
use giveway_page::{Action, files};
use yew::prelude::*;

use crate::{Shown, glyph, icon};

/// What scrolls of it.
#[inline(never)]
pub(super) fn show(column: &Column, state: &Shown, send: &Callback<Action>) -> Html {
    let export = {
        let state = state.clone();
        Callback::from(move |_: MouseEvent| {
            if let Some(saved) = files::trace_file(&state) {
                crate::files::save(&saved);
            }
        })
    };
    html! {
        <>
            <header class="qh">
                <p class="over">{ column.over.clone() }</p>
                <h2>{ column.title.clone() }</h2>
                if let Some(about) = &column.about { <p class="lead">{ about.clone() }</p> }
            </header>
            if let Some(verdict) = &column.verdict { { told(verdict) } }
            if !column.why.is_empty() {
                <section>
                    <h3>{ tr!("Why") }</h3>
                    <div class="prose">{ for column.why.iter().map(|text| html! { <p>{ text.clone() }</p> }) }</div>
                </section>
            }
            if let Some(means) = &column.means {
                <section>
                    <h3>{ tr!("What this means") }</h3>
                    <div class="prose"><p>{ means.clone() }</p></div>
                </section>
            }
            { for column.facts.iter().map(|(title, facts)| list(title, facts)) }
            if let Some((title, choices)) = &column.choices {
                <section>
                    <h3>{ title.clone() }</h3>
                    <ul class="choices">{ for choices.iter().map(|one| choice(one, send)) }</ul>
                </section>
            }
            if let Some((title, rows)) = &column.orders {
                <section>
                    <h3>{ title.clone() }</h3>
                    <ul class="orders">{ for rows.iter().map(|row| order(row, send)) }</ul>
                </section>
            }
            if let Some(listed) = &column.table { { table(listed) } }
            if let Some(press) = column.can_export.then(|| export.clone()) {
                <p><button type="button" class="btn outline" onclick={press}>{ icon::show("save") }<span>{ tr!("Save this record") }</span></button></p>
            }
            if let Some(note) = &column.note {
                <p class="sealed">{ icon::show("proved") }<span>{ note.clone() }</span></p>
            }
            if let Some(remark) = &column.remark { <p class="remark">{ remark.clone() }</p> }
        </>
    }
}

pub(super) fn told(verdict: &Verdict) -> Html {
    let (class, icon) = verdict.tint.look();
    html! {
        <div class={classes!("verdict", class)}>
            <p class="vb">{ icon::show(icon) }<b>{ verdict.word.clone() }</b><em>{ verdict.beside.clone() }</em></p>
            if !verdict.text.is_empty() { <p class="vs">{ verdict.text.clone() }</p> }
        </div>
    }
}

fn list(title: &str, facts: &[Fact]) -> Html {
    let fact = |fact: &Fact| {
        html! {
            <li>
                if let Some(agent) = fact.agent { { glyph::show(agent, "cons-glyph") } }
                <span>{ fact.text.clone() }if !fact.small.is_empty() { <small>{ fact.small.clone() }</small> }</span>
            </li>
        }
    };
    html! {
        <section>
            <h3>{ title.to_owned() }</h3>
            <ul class="cons">{ for facts.iter().map(fact) }</ul>
        </section>
    }
}

fn act(action: InsideAction, send: &Callback<Action>) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Inside(action))
}

fn choice(choice: &Choice, send: &Callback<Action>) -> Html {
    html! {
        <li><button type="button" class="choice" onclick={act(choice.action, send)}>
            if let Some(agent) = choice.agent { { glyph::show(agent, "choice-glyph") } }
            <span><b>{ choice.text.clone() }</b><small>{ choice.small.clone() }</small></span>
            { icon::at_end("chevron") }
        </button></li>
    }
}

fn order(row: &OrderRow, send: &Callback<Action>) -> Html {
    let place = row.place;
    let agent = |(index, (agent, name)): (usize, &(Option<usize>, String))| {
        html! {
            <>
                if index > 0 { { icon::show("chevron") } }
                if let Some(agent) = *agent { { glyph::show(agent, "cost-glyph") } }
                <span>{ name.clone() }</span>
            </>
        }
    };
    html! {
        <li><button type="button" aria-current={row.is_current.then_some("true")} onclick={act(InsideAction::Order(place), send)}>
            <span class="seq">{ for row.agents.iter().enumerate().map(agent) }</span>
            <em class={classes!(row.is_stuck.then_some("bad"))}>{ row.outcome.clone() }</em>
        </button></li>
    }
}

fn table(listed: &Listed) -> Html {
    let row = |(agent, name, cells): &(Option<usize>, String, [String; 2])| {
        html! {
            <tr>
                <th scope="row">if let Some(agent) = *agent { { glyph::show(agent, "cost-glyph") } }{ name.clone() }</th>
                { for cells.iter().map(|cell| html! { <td>{ cell.clone() }</td> }) }
            </tr>
        }
    };
    html! {
        <section>
            <h3>{ listed.title.clone() }</h3>
            <table class="compare" aria-label={listed.title.clone()}>
                <thead><tr><th scope="col">{ tr!("Robot") }</th>{ for listed.columns.iter().map(|name| html! { <th scope="col">{ *name }</th> }) }</tr></thead>
                <tbody>{ for listed.rows.iter().map(row) }</tbody>
            </table>
        </section>
    }
}

/// What stays at its foot.
#[inline(never)]
pub(super) fn foot(column: &Column, send: &Callback<Action>) -> Html {
    if column.foot.is_empty() {
        return html! {};
    }
    html! { <footer class="foot">{ for column.foot.iter().map(|one| button(one, send)) }</footer> }
}

/// A button of the foot.
pub(super) fn button(button: &Button, send: &Callback<Action>) -> Html {
    let class = if button.is_primary {
        "primary"
    } else {
        "outline"
    };
    let press = button.action.map(|action| act(action, send));
    html! {
        <button type="button" class={classes!("btn", class)} aria-disabled={button.action.is_none().then_some("true")} onclick={press}>
            if !button.icon.is_empty() { { icon::show(button.icon) } }
            <span>{ button.text }</span>
        </button>
    }
}
