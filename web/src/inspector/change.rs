//! What changes in the world: the list, the methods, the history; what can be
//! changed of an agent.

use giveway_model::{Battery, tr};
use giveway_page::changing::{self, Breakdown, Choice, Facts, Listed, Past, WIDEST};
use giveway_page::rules::RuleAction;
use giveway_page::{Action, BoardAction, ChangeAction, Edit, RuleEdit, State, Tool};
use yew::prelude::*;

use super::breakdown::{BreakdownCard, BreakdownCardProps};
use crate::field::number;
use crate::part::part;
use crate::{Shown, glyph, icon};

/// The button that lets the world change; nothing where it cannot.
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    if !state.can_change() {
        return html! {};
    }
    let time = state.view.playback.time;
    html! {
        <button type="button" class="btn outline more" title={tr!("Change the world here (x)")}
            onclick={send.reform(|_| Action::Change(ChangeAction::Begin))}>
            { icon::show("change") }{ tr!("Change the world here") }<span class="vh">{ tr!(", at time {time}", time) }</span>
        </button>
    }
}

/// All there is to tell while nothing is selected.
pub(super) fn show(facts: &Facts, methods: Choice, send: &Callback<Action>) -> Html {
    let cards = &facts.breakdowns;
    let one = |listed: &Listed| match cards.iter().find(|card| card.index == listed.index) {
        Some(card) => html! { <li key={listed.index} class="own">{ card_of(card, send) }</li> },
        None => listed_change(listed.index, listed, send),
    };
    html! {
        <>
            <header class="qh">
                <p class="over">{ tr!("The world changes") }</p>
                <h2>{ tr!("At time {time}", time = facts.at) }</h2>
                <p class="remark">{ tr!("Everything up to time {time} has happened and stays.", time = facts.at) }</p>
            </header>
            <section aria-label={tr!("Changes")}>
                <h3>{ tr!("Changes") }</h3>
                if facts.list.is_empty() {
                    <p class="remark">{ tr!("Use the tools on the board: what they do becomes a change. Select a robot for more.") }</p>
                } else {
                    <ul class="changes">{ for facts.list.iter().map(one) }</ul>
                }
                { meets(facts) }
                if facts.is_compared {
                    <button type="button" class="btn ghost add-change" onclick={send.reform(|_| Action::Board(BoardAction::PickTool(Tool::Obstacle)))}>
                        { icon::show("plus") }{ tr!("Add a change on the board") }
                    </button>
                }
            </section>
            { rules(facts, send) }
            { choose(methods, send) }
            { history(&facts.history, true) }
        </>
    }
}

/// The rules in force, each with a button that removes it from now on, and one for a new rule.
fn rules(facts: &Facts, send: &Callback<Action>) -> Html {
    let one = |(index, icon, sentence): &(usize, &'static str, String)| {
        let index = *index;
        let remove =
            send.reform(move |_: MouseEvent| Action::Edit(Edit::Rules(RuleEdit::Remove(index))));
        let name = tr!("Remove from now on: {rule}", rule = sentence);
        html! {
            <li key={index}>{ icon::show(icon) }<span>{ sentence.clone() }</span>
                <button type="button" class="btn ghost round" title={tr!("Remove from now on")} aria-label={name} onclick={remove}>{ icon::show("erase") }</button>
            </li>
        }
    };
    let begin = send.reform(|_: MouseEvent| Action::Rules(RuleAction::Begin));
    html! {
        <section aria-label={tr!("Rules")}>
            <h3>{ tr!("Rules") }</h3>
            if !facts.rules.is_empty() { <ul class="changes">{ for facts.rules.iter().map(one) }</ul> }
            <button type="button" class="btn ghost add-change" onclick={begin}>{ icon::show("plus") }{ tr!("A rule from now on") }</button>
        </section>
    }
}

fn listed_change(index: usize, listed: &Listed, send: &Callback<Action>) -> Html {
    let take_back = send.reform(move |_: MouseEvent| Action::Change(ChangeAction::TakeBack(index)));
    let name = tr!("Take back: {what}", what = listed.text);
    html! {
        <li key={index}>
            if let Some(agent) = listed.agent {
                { glyph::show(agent, "choice-glyph") }
            } else {
                { icon::show(listed.icon) }
            }
            <span><b>{ listed.text.clone() }</b>
                if let Some(detail) = &listed.detail { <small>{ detail.clone() }</small> }
            </span>
            <button type="button" class="btn ghost round" title={tr!("Take back")} aria-label={name} onclick={take_back}>
                { icon::show("cancel") }
            </button>
        </li>
    }
}

/// What would go wrong if everyone went on as planned; told as the list changes.
pub(super) fn meets(facts: &Facts) -> Html {
    html! {
        <div role="status">
            if !facts.warnings.is_empty() {
                <ul class="meets">{ for facts.warnings.iter().map(|text| html! { <li key={text.clone()}>{ icon::show("warning") }<span>{ text.clone() }</span></li> }) }</ul>
            }
        </div>
    }
}

/// The button by which the robot selected breaks down; nothing where the world cannot change.
pub(super) fn breaks_down(state: &State, agent: usize, send: &Callback<Action>) -> Html {
    let is_here = state.document.mode.changing().is_none() && state.can_change();
    if !is_here {
        return html! {};
    }
    let time = state.view.playback.time;
    html! {
        <button type="button" class="btn outline more" onclick={send.reform(move |_| Action::Change(ChangeAction::BreakDown(agent)))}>
            { icon::show("stop") }{ tr!("Breaks down here") }<span class="vh">{ tr!(", at time {time}", time) }</span>
        </button>
    }
}

fn choose(methods: Choice, send: &Callback<Action>) -> Html {
    let check = |name: &'static str, what: &'static str, on: bool, with: fn(Choice) -> Choice| {
        let toggle =
            send.reform(move |_: Event| Action::Change(ChangeAction::ChooseMethods(with(methods))));
        html! {
            <label>
                <input type="checkbox" checked={on} onchange={toggle} />
                <span><b>{ name }</b><small>{ what }</small></span>
            </label>
        }
    };
    let width = send.reform(move |n: Option<u32>| {
        Action::Change(ChangeAction::ChooseMethods(Choice {
            width: n.unwrap_or(1),
            ..methods
        }))
    });
    html! {
        <section>
            <h3>{ tr!("Find new plans") }</h3>
            <div class="methods" role="group" aria-label={tr!("Find new plans")}>
                { check(tr!("New times"), tr!("everyone keeps their path"), methods.revise, |c| Choice { revise: !c.revise, ..c }) }
                <div class="with-width">
                    { check(tr!("Near the old paths"), tr!("at most so many cells away"), methods.tunnel, |c| Choice { tunnel: !c.tunnel, ..c }) }
                    <div class="fields">{ number(tr!("Cells away"), Some(methods.width), (0, WIDEST), None, &width) }</div>
                </div>
                { check(tr!("Everything new"), tr!("everyone plans freely"), methods.replan, |c| Choice { replan: !c.replan, ..c }) }
            </div>
        </section>
    }
}

/// The first plan and how it went on; nothing where nothing changed.
pub(super) fn history(past: &[Past], is_open: bool) -> Html {
    if past.len() < 2 {
        return html! {};
    }
    let last = past.len() - 1;
    let one = |(index, past): (usize, &Past)| {
        html! {
            <li key={index} class={classes!((is_open && index == last).then_some("cur"))}>
                <b>{ past.at }</b>
                <span>{ past.text.clone() }
                    if let Some(detail) = &past.detail { <small>{ detail.clone() }</small> }
                </span>
            </li>
        }
    };
    html! {
        <section aria-label={tr!("History")}>
            <h3>{ tr!("History") }</h3>
            <ol class="hist">{ for past.iter().enumerate().map(one) }</ol>
        </section>
    }
}

/// What can be changed of the agent that is selected.
pub(super) fn agent(
    state: &Shown,
    index: usize,
    breakdowns: &[Breakdown],
    send: &Callback<Action>,
) -> Html {
    let Some(offers) = changing::offers(state, index) else {
        return html! {};
    };
    let list = |make: fn(usize, u32) -> Edit| {
        let send = send.clone();
        Callback::from(move |n: Option<u32>| {
            if let Some(n) = n {
                send.emit(Action::Edit(make(index, n)));
            }
        })
    };
    let level = list(Edit::SetLevel);
    let remove = send.reform(move |_: MouseEvent| Action::Edit(Edit::RemoveAgent(index)));
    let waypoint = |&cell: &giveway_model::Cell| {
        let place = format!("({}, {})", cell.x, cell.y);
        let press = send.reform(move |_: MouseEvent| Action::Edit(Edit::DropWaypoint(index, cell)));
        html! {
            <li>{ &place }<button type="button" class="btn ghost round" onclick={press}
                aria-label={tr!("Drop waypoint {place}", place)} title={tr!("Drop")}>
                { icon::show("cancel") }
            </button></li>
        }
    };
    html! {
        <section aria-label={tr!("Change this robot")}>
            <h3>{ tr!("Change {name} at time {time}", name = offers.name, time = offers.at) }</h3>
            <div class="edit-body">
                <div class="fields">
                    if let Some((value, capacity)) = offers.level {
                        { number(tr!("Set battery"), Some(value), (0, capacity), None, &level) }
                    }
                    if let Some(battery) = offers.battery { { joining_battery(index, battery, send) } }
                </div>
                { breakdown(&offers, index, breakdowns, send) }
                if !offers.waypoints.is_empty() {
                    <ul class="removable" aria-label={tr!("Waypoints")}>{ for offers.waypoints.iter().map(waypoint) }</ul>
                }
                <button type="button" class="btn outline" onclick={remove}>{ tr!("Remove {name}", name = offers.name) }</button>
            </div>
        </section>
    }
}

/// The battery of a robot that joins: its capacity, and its level at the start.
fn joining_battery(index: usize, battery: Option<Battery>, send: &Callback<Action>) -> Html {
    const MOST: u32 = 1_000_000;
    let set = |with: fn(Option<Battery>, u32) -> Battery| {
        send.reform(move |n: Option<u32>| {
            Action::Edit(Edit::SetBattery(index, n.map(|n| with(battery, n))))
        })
    };
    let capacity = set(|battery, capacity| Battery {
        capacity,
        initial: battery.map_or(capacity, |own| own.initial.min(capacity)),
    });
    let initial = set(|battery, initial| Battery {
        capacity: battery.map_or(initial, |own| own.capacity),
        initial,
    });
    html! {
        <>
            { number(tr!("Capacity, steps"), battery.map(|own| own.capacity), (1, MOST), Some(tr!("no limit of a battery" => "none")), &capacity) }
            if let Some(own) = battery { { number(tr!("At the start"), Some(own.initial), (0, own.capacity), None, &initial) } }
        </>
    }
}

/// The card of the robot's breakdown; without one, for how long it is to break down.
fn breakdown(
    offers: &changing::Offers,
    index: usize,
    breakdowns: &[Breakdown],
    send: &Callback<Action>,
) -> Html {
    if let Some(card) = breakdowns.iter().find(|card| card.agent == index) {
        return card_of(card, send);
    }
    let for_good = send.reform(move |_: MouseEvent| Action::Edit(Edit::Stop(index)));
    let some = send.reform(move |_: MouseEvent| Action::Change(ChangeAction::BreakDown(index)));
    html! {
        <div class="breaks" role="group" aria-label={tr!("Breaks down here")}>
            <p><b>{ icon::show("stop") }{ tr!("Breaks down here") }</b>
                if let Some(cell) = offers.place { <span>{ tr!("at {cell}", cell) }</span> }</p>
            <div class="seg">
                <button type="button" aria-pressed="false" onclick={some}>{ tr!("For some steps") }</button>
                <button type="button" aria-pressed="false" disabled={offers.place.is_none()} onclick={for_good}>{ tr!("For good") }</button>
            </div>
        </div>
    }
}

fn card_of(card: &Breakdown, send: &Callback<Action>) -> Html {
    html! { { part::<BreakdownCard>(BreakdownCardProps { breakdown: card.clone(), send: send.clone() }) } }
}

/// What stays at the foot of the inspector.
pub(super) fn foot(send: &Callback<Action>) -> Html {
    html! {
        <footer class="foot">
            <button type="button" class="btn ghost" onclick={send.reform(|_| Action::Change(ChangeAction::Discard))}>
                { icon::show("undo") }{ tr!("Discard") }
            </button>
        </footer>
    }
}
