//! Ways to go on where the world changed, side by side: a column each, one of
//! which the board and the timeline preview.

use giveway_model::tr;
use giveway_page::changing::{Column, CostChange, Fix, Group, columns, fixes};
use giveway_page::{Action, ChangeAction, State, ViewAction};
use yew::prelude::*;

use crate::board::Preview;
use crate::board::PreviewProps;
use crate::part::part;
use crate::{Shown, glyph, icon};

/// The columns; nothing while nothing is compared.
pub(crate) fn show(state: &Shown, send: &Callback<Action>) -> Html {
    let Some(columns) = columns(state) else {
        return Html::default();
    };
    let is_one = columns.len() == 1;
    let column = |facts: &Column| column(facts.index, facts, is_one, state, send);
    html! {
        <section class="cmp" aria-label={tr!("Ways to go on")}>
            { help(state, send) }
            <div class="cols" tabindex="0">{ for columns.iter().map(column) }</div>
            <button type="button" class="btn ghost only-ph" onclick={send.reform(|_| Action::Change(ChangeAction::Discard))}>
                { icon::show("undo") }{ tr!("Discard") }
            </button>
        </section>
    }
}

/// What can be tried where no method has a plan.
fn help(state: &State, send: &Callback<Action>) -> Html {
    let fixes = fixes(state);
    if fixes.is_empty() {
        return Html::default();
    }
    // Why there is no plan was asked: the answer offers the next step.
    let leads = state.document.mode.asking().is_none();
    let one = |(index, fix): (usize, &Fix)| {
        let (icon, text) = match fix {
            Fix::TakeBack(_, what) => ("undo", tr!("Take back: {what}", what)),
            Fix::Try(_, text) => ("compare", text.clone()),
            Fix::Longer(seconds) => ("clock", tr!("Search for up to {seconds} s", seconds)),
        };
        let press = {
            let (fix, send) = (fix.clone(), send.clone());
            move |_: MouseEvent| match fix {
                Fix::TakeBack(index, _) => send.emit(Action::Change(ChangeAction::TakeBack(index))),
                Fix::Try(methods, _) => {
                    send.emit(Action::Change(ChangeAction::ChooseMethods(methods)));
                    send.emit(Action::Change(ChangeAction::Adapt));
                }
                Fix::Longer(seconds) => {
                    send.emit(Action::View(ViewAction::SetSeconds(seconds)));
                    send.emit(Action::Change(ChangeAction::Adapt));
                }
            }
        };
        html! {
            <li><button type="button" class={classes!("repair", (leads && index == 0).then_some("lead"))} onclick={press}>
                { icon::show(icon) }<span>{ text }</span>
            </button></li>
        }
    };
    html! {
        <section class="fixes" aria-label={tr!("What you could try")}>
            <h3>{ tr!("No method has a plan. What you could try") }</h3>
            <ul class="repairs">{ for fixes.iter().enumerate().map(one) }</ul>
        </section>
    }
}

fn column(
    index: usize,
    facts: &Column,
    is_one: bool,
    state: &Shown,
    send: &Callback<Action>,
) -> Html {
    let changing = state.document.mode.changing();
    let before = changing.map(|changing| changing.about.clone());
    let has_plan = facts.has_plan();
    let title = facts.titles.join(", ");
    let is_shared = facts.titles.len() > 1;
    let preview = send.reform(move |_: MouseEvent| Action::Change(ChangeAction::Preview(index)));
    let adopt = send.reform(move |_: MouseEvent| Action::Change(ChangeAction::Adopt(index)));
    html! {
        <article key={index} class={classes!("col", facts.is_chosen.then_some("best"), (!has_plan).then_some("none"), is_one.then_some("one"))} aria-label={title.clone()}>
            <header>
                if is_shared {
                    <h2>{ tr!("{n} equal answer is one plan" | "{n} equal answers are one plan" % facts.titles.len()) }</h2>
                } else {
                    <h2>{ title.clone() }</h2>
                }
                if facts.is_least {
                    <span class="badge proved">{ icon::show("proved") }{ tr!("Lowest cost") }</span>
                }
                if is_shared {
                    <ul class="names">{ for facts.titles.iter().map(|name| html! { <li>{ icon::show("check") }{ *name }</li> }) }</ul>
                } else {
                    <p>{ facts.promise.clone() }</p>
                }
            </header>
            if !has_plan {
                <p class="no-plan">{ icon::show("cancel") }{ tr!("No plan") }</p>
                { for facts.notes.iter().map(|note| html! { <p class="why">{ note.clone() }</p> }) }
            }
            if let Some(before) = before {
                { part::<Preview>(PreviewProps { name: facts.board, state: state.clone(), answer: facts.answer.clone(), before }) }
            }
            if !facts.costs.is_empty() {
                <dl class="big">{ for facts.costs.iter().take(2).map(cost) }</dl>
            }
            { for facts.counted.iter().map(|note| html! { <p class="note">{ note.clone() }</p> }) }
            // The way on is in sight, however much there is to tell of the robots.
            <footer>
                if has_plan {
                    <button type="button" class={classes!("btn", if facts.is_chosen { "primary" } else { "outline" })} onclick={adopt}>
                        { icon::show("check") }{ tr!("Use this plan") }<span class="vh">{ format!(" {title}") }</span>
                    </button>
                    <button type="button" class="btn ghost" aria-pressed={facts.is_chosen.to_string()} onclick={preview}>
                        { tr!("Preview") }<span class="vh">{ format!(" {title}") }</span>
                    </button>
                }
                <span class="ms">{ icon::show("clock") }{ facts.time.clone() }</span>
            </footer>
            if !facts.groups.is_empty() {
                <dl class="grp">{ for facts.groups.iter().map(group) }</dl>
            }
            if has_plan {
                { for facts.notes.iter().map(|note| html! { <p class="note">{ note.clone() }</p> }) }
            }
        </article>
    }
}

fn cost(cost: &CostChange) -> Html {
    let class = match cost.before.map(|before| cost.after.cmp(&before)) {
        Some(std::cmp::Ordering::Less) if cost.counts_all => "d better",
        Some(std::cmp::Ordering::Greater) => "d worse",
        _ => "d same",
    };
    html! {
        <div>
            <dt>{ cost.title }</dt>
            <dd>
                if let Some(before) = cost.before {
                    <s><span class="vh">{ tr!("an earlier cost" => "before") }{ " " }</span>{ before }</s>
                }
                <b>{ cost.after }</b>
                if let Some(by) = cost.difference() { <i {class}>{ by }</i> }
            </dd>
        </div>
    }
}

fn group(group: &Group) -> Html {
    let one = |(agent, name): &(usize, String)| {
        html! { <span>{ glyph::show(*agent, "who-glyph") }{ name.clone() }</span> }
    };
    html! {
        <div>
            <dt>{ group.title }</dt>
            <dd class="who">
                if group.agents.is_empty() {
                    <span class="no1">{ tr!("no robots" => "none") }</span>
                } else {
                    { for group.agents.iter().map(one) }
                }
            </dd>
        </div>
    }
}
