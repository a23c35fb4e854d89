//! The answer to a question: verdict, costs side by side, what would happen,
//! what excludes it, what would help.

use giveway_model::tr;
use giveway_page::ask::{Card, FactRow, Facts, Happening, Offered, Other};
use giveway_page::beside::DifferenceRow;
use giveway_page::{Action, AskAction, Lit, PlayAction};
use yew::prelude::*;

use super::pays::{verdict_card, who_pays};
use crate::icon;

/// What scrolls of the card.
pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    // The facts have the numbers: they come first.
    let is_numbered = card
        .cores
        .iter()
        .flat_map(|core| &core.facts)
        .any(|fact| fact.number.is_some());
    html! {
        <>
            <header class="qh">
                <button type="button" class="crumb" onclick={send.reform(|_| Action::Ask(AskAction::Close))}>
                    { icon::show("back") }{ tr!("Back") }
                </button>
                <h2>{ card.question.clone() }</h2>
            </header>
            <div class="verdict-at" aria-live="polite">
                if let Some(verdict) = &card.verdict { { verdict_card(verdict) } }
            </div>
            // Without a plan to show, what would help is the next step.
            if card.other.is_none() && !card.repairs.is_empty() {
                { repairs(card, true, send) }
            }
            if let Some(pays) = &card.pays { { who_pays(pays, send) } }
            if !card.differences.is_empty() { { what_differs(&card.differences, send) } }
            if !is_numbered {
                { for card.witness.iter().map(|(title, happenings)| witness(title, happenings, send)) }
            }
            { for card.cores.iter().map(|facts| core(facts, send)) }
            if is_numbered {
                { for card.witness.iter().map(|(title, happenings)| witness(title, happenings, send)) }
            }
            if card.other.is_some() && !card.repairs.is_empty() {
                { repairs(card, false, send) }
            }
            if !card.pending.is_empty() {
                <ul class="pending">{ for card.pending.iter().map(|line| html! { <li>{ *line }</li> }) }</ul>
            }
            if let Some(standing) = &card.standing {
                <p class="remark">{ standing.clone() }</p>
            }
        </>
    }
}

/// What stays at the foot of it: first to open the other plan, then to decide.
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    let Some(Other {
        is_shown,
        is_beside,
    }) = card.other
    else {
        return html! {};
    };
    let show = |on: bool| send.reform(move |_| Action::Ask(AskAction::ShowOther(on)));
    if !is_shown {
        return html! {
            <footer class="foot">
                <button type="button" class="btn primary" title={tr!("Show the other plan (n)")} onclick={show(true)}>
                    { icon::show("compare") }{ tr!("Show the other plan") }
                </button>
                <button type="button" class="btn outline" onclick={send.reform(|_| Action::Ask(AskAction::Close))}>{ tr!("Done") }</button>
            </footer>
        };
    }
    html! {
        <footer class="foot">
            <button type="button" class="btn primary" onclick={show(false)}>
                if is_beside { { icon::show("check") }{ tr!("Keep this plan") } } else { { icon::show("compare") }{ tr!("Show this plan") } }
            </button>
            <button type="button" class="btn outline" onclick={send.reform(|_| Action::Ask(AskAction::TakeOther))}>{ tr!("Take the other plan") }</button>
        </footer>
    }
}

/// The times at which the plans begin to differ: pressing one shows it.
fn what_differs(rows: &[DifferenceRow], send: &Callback<Action>) -> Html {
    let row = |row: &DifferenceRow| {
        let time = row.time;
        html! {
            <li><button type="button" class={classes!("differs", row.is_now.then_some("on"))} aria-current={row.is_now.then_some("step")}
                onclick={send.reform(move |_| Action::Play(PlayAction::Seek(time)))}>
                { icon::show("compare") }
                <span>{ tr!("At time {time}", time) }<small>{ row.who.clone() }</small></span>
            </button></li>
        }
    };
    html! {
        <section>
            <h3>{ tr!("What differs") }</h3>
            <ul class="repairs">{ for rows.iter().map(row) }</ul>
        </section>
    }
}

/// Lights up while it is pointed at or has the focus.
fn lit(lit: Lit, send: &Callback<Action>) -> [Callback<()>; 2] {
    let on = send.reform(move |()| Action::Ask(AskAction::Light(Some(lit))));
    let off = send.reform(|()| Action::Ask(AskAction::Light(None)));
    [on, off]
}

fn witness(title: &str, happenings: &[Happening], send: &Callback<Action>) -> Html {
    let one = |happening: &Happening| {
        let [on, off] = lit(Lit::Witness(happening.index), send);
        let time = happening.time;
        html! {
            <li><button type="button" class={classes!("reason", happening.is_lit.then_some("lit"))}
                title={tr!("Show time {time}", time)} onclick={send.reform(move |_| Action::Play(PlayAction::Seek(time)))}
                onpointerenter={on.reform(|_| ())} onpointerleave={off.reform(|_| ())}
                onfocus={on.reform(|_| ())} onblur={off.reform(|_| ())}>
                if let Some(number) = happening.number {
                    <span class="no">{ number }</span>
                } else {
                    { icon::show("collision") }
                }
                <span>{ happening.text.clone() }</span>
            </button></li>
        }
    };
    html! {
        <section>
            <h3>{ title.to_owned() }</h3>
            <ul class="reasons">{ for happenings.iter().map(one) }</ul>
        </section>
    }
}

/// Lights up, and shows the time of what has one.
fn shown(on: &Callback<()>, time: Option<u32>, send: &Callback<Action>) -> Callback<MouseEvent> {
    let (on, send) = (on.clone(), send.clone());
    Callback::from(move |_| {
        on.emit(());
        if let Some(time) = time {
            send.emit(Action::Play(PlayAction::Seek(time)));
        }
    })
}

fn core(facts: &Facts, send: &Callback<Action>) -> Html {
    let one = |fact: &FactRow| {
        let is_lit = fact.is_lit;
        let [on, off] = lit(Lit::Fact(fact.index), send);
        html! {
            <li><button type="button" class={classes!("fact", is_lit.then_some("lit"))} aria-pressed={is_lit.to_string()}
                onclick={shown(&on, fact.time, send)}
                onpointerenter={on.reform(|_| ())} onpointerleave={off.reform(|_| ())}
                onfocus={on.reform(|_| ())} onblur={off.reform(|_| ())}>
                if let Some(number) = fact.number {
                    <span class="no">{ number }</span>
                } else {
                    { icon::show(fact.icon) }
                }
                <span>{ fact.text.clone() }if let Some(mark) = fact.mark { <small>{ mark }</small> }</span>
            </button></li>
        }
    };
    html! {
        <section>
            <h3>{ facts.title }</h3>
            <ul class="reasons tight">{ for facts.facts.iter().map(one) }</ul>
            <p class="remark">{ facts.claim.clone() }</p>
        </section>
    }
}

fn repairs(card: &Card, leads: bool, send: &Callback<Action>) -> Html {
    let one = |(index, repair): (usize, &Offered)| {
        html! {
            <li><button type="button" class={classes!("repair", (leads && index == 0).then_some("lead"))}
                onclick={send.reform(move |_| Action::Ask(AskAction::TakeRepair(index)))}>
                { icon::show(repair.icon) }
                <span>{ repair.text.clone() }<small>{ repair.costs.clone() }</small></span>
            </button></li>
        }
    };
    html! {
        <section>
            <h3>{ tr!("What would help") }</h3>
            <ul class="repairs">{ for card.repairs.iter().enumerate().map(one) }</ul>
            if let Some(more) = &card.more_repairs { <p class="remark">{ more.clone() }</p> }
        </section>
    }
}
