//! The answer to a question: verdict, costs side by side, what would happen,
//! what excludes it, what would help.

use giveway_model::tr;
use giveway_page::ask::{Card, FactRow, Facts, Happening, Held, Offered, Other};
use giveway_page::beside::DifferenceRow;
use giveway_page::{Action, AskAction, Lit, PlayAction, SolveAction};
use yew::prelude::*;

use super::coming::{place, progress, verdict_place};
use super::groups;
use super::pays::{it_could, nobody_yet, verdict_card, who_pays};
use crate::icon;

/// What scrolls of the card.
pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    // The facts have the numbers: they come first.
    let is_numbered = card
        .cores
        .iter()
        .flat_map(|core| &core.facts)
        .any(|fact| fact.number.is_some());
    let held = card
        .coming
        .as_ref()
        .map_or_else(Held::default, |coming| coming.held);
    html! {
        <>
            <header class="qh">
                <button type="button" class="crumb" onclick={send.reform(|_| Action::Ask(AskAction::Close))}>
                    { icon::show("back") }{ tr!("Back") }
                </button>
                <h2>{ card.question.clone() }</h2>
                if let Some(about) = &card.about { <p>{ about.clone() }</p> }
            </header>
            <div class="verdict-at" aria-live="polite">
                if let Some(verdict) = &card.verdict { { verdict_card(verdict, send) } }
            </div>
            if held.verdict { { verdict_place() } }
            // Without a plan to show, what would help is the next step.
            if card.other.is_none() && !card.repairs.is_empty() {
                { repairs(card, true, send) }
            }
            if !card.could.is_empty() { { it_could(&card.could, send) } }
            if let Some(pays) = &card.pays { { who_pays(pays, held, send) } } else if held.rows > 0 { { nobody_yet(held) } }
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
            if held.reasons { { place(tr!("Because of"), 3) } }
            if held.help { { place(tr!("What would help"), 1) } }
            if let Some(standing) = &card.standing {
                <p class="remark">{ standing.clone() }</p>
            }
        </>
    }
}

/// What stays at the foot of it: how far it is, then to open the other plan, then to decide.
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    let button = |class: &'static str, icon: &'static str, word: &'static str, action: Action| {
        html! {
            <button type="button" class={classes!("btn", class)} onclick={send.reform(move |_| action.clone())}>
                { icon::show(icon) }{ word }
            </button>
        }
    };
    let ask = |action: AskAction| Action::Ask(action);
    let coming = card.coming.as_ref();
    let is_looking = coming.is_some_and(|coming| coming.is_looking);
    // One button leads: to decide, where there is something to decide on.
    let has_next = card.other.is_some() || !card.repairs.is_empty();
    let led = |leads: bool| if leads { "primary" } else { "outline" };
    let other = card.other.map(|other| {
        let show = |on: bool| ask(AskAction::ShowOther(on));
        let take = ask(AskAction::TakeOther);
        match other {
            Other {
                is_shown: true,
                is_beside: true,
                ..
            } => html! {
                <>
                    { button("primary", "check", tr!("Keep this plan"), show(false)) }
                    { button("outline", "compare", tr!("Take the other plan"), take) }
                </>
            },
            Other { is_shown: true, .. } => html! {
                <>
                    { button("primary", "compare", tr!("Show this plan"), show(false)) }
                    { button("outline", "check", tr!("Take the other plan"), take) }
                </>
            },
            Other {
                is_better: true, ..
            } => html! {
                <>
                    { button("primary", "check", tr!("Take the better plan"), take) }
                    { button("outline", "compare", tr!("Show it"), show(true)) }
                </>
            },
            Other { .. } => button("primary", "compare", tr!("Show the other plan"), show(true)),
        }
    });
    let is_shown = card.other.is_some_and(|other| other.is_shown);
    let end = match coming {
        Some(_) if is_looking => button(
            led(!has_next),
            "cancel",
            tr!("Cancel"),
            Action::Solve(SolveAction::Cancel),
        ),
        Some(_) if !is_shown => button(
            led(!has_next),
            "search",
            tr!("Keep looking"),
            ask(AskAction::Again),
        ),
        Some(_) | None if !is_shown => {
            button("outline", "check", tr!("Done"), ask(AskAction::Close))
        }
        Some(_) | None => html! {},
    };
    html! {
        <footer class={classes!("foot", coming.map(|_| "at-work"))}>
            if let Some(coming) = coming { { progress(&card.question, coming) } }
            { other }
            { end }
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
            if facts.groups.is_empty() {
                <ul class="reasons tight">{ for facts.facts.iter().map(one) }</ul>
            } else {
                { groups::show(facts, send) }
            }
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
