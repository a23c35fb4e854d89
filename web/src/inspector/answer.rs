//! The answer to a question: verdict, costs side by side, what would happen,
//! what excludes it, what would help.

use giveway_model::tr;
use giveway_page::ask::{Card, FactRow, Facts, Happening, Held, Missing, Offered};
use giveway_page::beside::DifferenceRow;
use giveway_page::{Action, AskAction, Lit, PlayAction, SolveAction};
use yew::prelude::*;

use super::coming::{place, progress, verdict_place, ways};
use super::groups;
use super::pays::{it_could, nobody_yet, verdict_card, who_pays};
use super::tight::how_tight;
use crate::icon;
use crate::turning::turning;

/// What scrolls of the card.
#[inline(never)]
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
            <div class={classes!("verdict-at", card.holds_places.then_some("lasting"))} aria-live="polite">
                if let Some(verdict) = &card.verdict { { verdict_card(verdict, send) } }
            </div>
            if held.verdict { { verdict_place() } }
            if let Some(tight) = &card.tight { { how_tight(tight, send) } }
            // Without a plan to show, what would help is the next step.
            if card.other.is_none() && !card.repairs.is_empty() {
                { repairs(card, true, send) }
            }
            if !card.could.is_empty() || held.ways > 0 { { it_could(&card.could, ways(held.ways), send) } }
            if let Some(pays) = &card.pays { { who_pays(pays, held, send) } } else if held.rows > 0 { { nobody_yet(held) } }
            if !card.differences.is_empty() { { what_differs(card, send) } }
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
            { for card.missing.iter().map(missing) }
            if held.reasons { { place(tr!("Because of"), 3) } }
            if held.help { { place(tr!("What would help"), 1) } }
            if let Some(standing) = &card.standing {
                <p class="remark">{ standing.clone() }</p>
            }
        </>
    }
}

/// What stays at the foot of it: how far it is, then to open the other plan, then to decide.
#[inline(never)]
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    let button = |class: &'static str, icon: &'static str, word: &'static str, action: Action| {
        let content = html! { <>{ icon::show(icon) }{ word }</> };
        turning(class, word, content, send.reform(move |_| action.clone()))
    };
    let ask = |action: AskAction| Action::Ask(action);
    let coming = card.coming.as_ref();
    let is_looking = coming.is_some_and(|coming| coming.is_looking);
    // One button leads: to decide, where there is something to decide on.
    let has_next = card.other.is_some() || !card.repairs.is_empty();
    let show = |on: bool| ask(AskAction::ShowOther(on));
    let take = || ask(AskAction::TakeOther);
    let other = card.other.as_ref().map(|other| {
        // To show it and not to show it have the same place, and to take it another one.
        let buttons = if other.is_shown && other.is_beside {
            [
                button("primary", "check", tr!("Keep this plan"), show(false)),
                button("outline", "compare", tr!("Take the other plan"), take()),
            ]
        } else if other.is_shown {
            [
                button("primary", "compare", tr!("Show this plan"), show(false)),
                button("outline", "check", tr!("Take the other plan"), take()),
            ]
        } else if other.is_better {
            let words = match &other.which {
                Some(_) => tr!("Take the other plan"),
                None => tr!("Take the better plan"),
            };
            [
                button("outline", "compare", tr!("Show it"), show(true)),
                button("primary", "check", words, take()),
            ]
        } else {
            let words = tr!("Show the other plan");
            [
                button("primary", "compare", words, show(true)),
                Html::default(),
            ]
        };
        html! {
            <>
                if let Some(which) = &other.which {
                    <p class="which">{ tr!("The other plan: {which}", which) }</p>
                }
                { for buttons }
            </>
        }
    });
    let is_shown = card.other.as_ref().is_some_and(|other| other.is_shown);
    // The last row, so that nothing else comes where it is.
    let end = |icon: &'static str, words: &'static str, action: Action| {
        button(
            if has_next { "outline" } else { "primary" },
            icon,
            words,
            action,
        )
    };
    let end = match coming {
        Some(_) if is_looking => {
            let cancel = Action::Solve(SolveAction::Cancel);
            end("cancel", tr!("Cancel"), cancel)
        }
        Some(_) if !is_shown => end("search", tr!("Keep looking"), ask(AskAction::Again)),
        Some(_) | None if !is_shown => {
            button("outline", "check", tr!("Done"), ask(AskAction::Close))
        }
        Some(_) | None => html! {},
    };
    let held = coming.is_some_and(|coming| coming.held.other);
    html! {
        <footer class={classes!("foot", "decides", coming.map(|_| "at-work"))}>
            if let Some(coming) = coming { { progress(&card.question, coming) } }
            if held { <p class="which held" aria-hidden="true"></p> }
            { other }
            <span class="last">{ end }</span>
        </footer>
    }
}

/// The times at which the plans begin to differ: pressing one shows it.
fn what_differs(card: &Card, send: &Callback<Action>) -> Html {
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
            <ul class="repairs">{ for card.differences.iter().map(row) }</ul>
            if let Some(more) = &card.more_differences { <p class="remark">{ more.clone() }</p> }
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

/// What is told in the place of a part that was not found.
fn missing(missing: &Missing) -> Html {
    let sentence = |sentence: &String| html! { <p class="remark">{ sentence.clone() }</p> };
    html! { <section><h3>{ missing.title }</h3>{ for missing.sentences.iter().map(sentence) }</section> }
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
            </button>
            { for groups::loosens(fact, send) }
            </li>
        }
    };
    html! {
        <section>
            <h3>{ facts.title }if let Some(summary) = &facts.summary { { " " }<small>{ summary.clone() }</small> }</h3>
            if facts.groups.is_empty() {
                <ul class="reasons tight">{ for facts.facts.iter().map(one) }</ul>
            } else {
                { groups::show(facts, send) }
            }
            <p class="remark">{ facts.claim.clone() }</p>
        </section>
    }
}

/// What a repair saves or costs more; what is given up with something is no gain.
fn saves((by, is_less): &(String, bool), gives_up: bool) -> Html {
    let class = (*is_less && !gives_up).then_some("better");
    html! { <em class={classes!(class)}>{ by.clone() }</em> }
}

fn repairs(card: &Card, leads: bool, send: &Callback<Action>) -> Html {
    let all = || card.repairs.iter().enumerate();
    let of = |gives_up: bool| all().filter(move |(_, repair)| repair.gives_up == gives_up);
    let is_split = leads && of(true).next().is_some() && of(false).next().is_some();
    // To loosen keeps most of what was wanted.
    let first = if is_split {
        of(false).next()
    } else {
        all().next()
    };
    let first = first.map(|(index, _)| index);
    let one = |(index, repair): (usize, &Offered)| {
        html! {
            <li><button type="button" class={classes!("repair", (leads && Some(index) == first).then_some("lead"))}
                onclick={send.reform(move |_| Action::Ask(AskAction::TakeRepair(index)))}>
                { icon::show(repair.icon) }
                <span>{ repair.text.clone() }<small>{ repair.costs.clone() }</small></span>
                if let Some(by) = &repair.difference { { saves(by, repair.gives_up) } }
            </button></li>
        }
    };
    html! {
        <section>
            <h3>{ tr!("What would help") }</h3>
            if is_split {
                <h4>{ tr!("Loosen one of them") }</h4>
                <ul class="repairs">{ for of(false).map(one) }</ul>
                <h4>{ tr!("Or give one up") }</h4>
                <ul class="repairs">{ for of(true).map(one) }</ul>
            } else {
                <ul class="repairs">{ for all().map(one) }</ul>
            }
            if let Some(more) = &card.more_repairs { <p class="remark">{ more.clone() }</p> }
        </section>
    }
}
