//! An agent at the time shown.

use giveway_model::{Units, tr};
use giveway_page::inspect::{AgentFacts, BatteryFacts};
use giveway_page::rules::{self, Lit, RuleAction};
use giveway_page::timeline::{Lane, Way};
use giveway_page::{Action, PlayAction, State, words};
use yew::prelude::*;

use super::back;
use crate::glyph;

pub(super) fn show(state: &State, facts: &AgentFacts, send: &Callback<Action>) -> Html {
    let (visited, waypoints) = facts.waypoints;
    html! {
        <>
            <header class="ih">
                { back(send) }
                { glyph::named(state, facts.agent) }
                <div><h2><bdi>{ facts.name.clone() }</bdi></h2><p class="doing">{ facts.doing.clone() }{ waits_for(state, facts.agent, send) }</p></div>
            </header>
            <dl class="facts">
                if let Some(battery) = facts.battery {
                    <div><dt>{ tr!("Battery") }</dt><dd>{ show_battery(battery) }</dd></div>
                }
                if waypoints > 0 {
                    <div><dt>{ tr!("Waypoints") }</dt><dd><span><b>{ visited }</b>{ tr!("after a bold number" => " of {waypoints} visited", waypoints) }</span></dd></div>
                }
                if let Some(lane) = &facts.lane {
                    { show_plan(lane, state.world().scene().units, send) }
                }
            </dl>
        </>
    }
}

/// The rules for which it waits, behind what it does: pressing one shows it.
fn waits_for(state: &State, agent: usize, send: &Callback<Action>) -> Html {
    if state.view.playback.playing {
        return Html::default();
    }
    let rules = rules::waits_for(state, agent, state.view.playback.time);
    if rules.is_empty() {
        return Html::default();
    }
    let rule = |(place, (index, text)): (usize, &(usize, String))| {
        let (index, before) = (*index, if place == 0 { "" } else { ", " });
        let light =
            move |on: bool| Action::Rules(RuleAction::Light(on.then_some(Lit::Rule(index))));
        html! {
            <>{ before }<button type="button" class="zone-name" onmouseenter={send.reform(move |_| light(true))} onfocus={send.reform(move |_| light(true))}
                onmouseleave={send.reform(move |_| light(false))} onclick={send.reform(move |_| Action::Rules(RuleAction::Show(index)))}>{ text.clone() }</button></>
        }
    };
    html! { <>{ tr!("behind a wait, before the rule that causes it" => " for ") }{ for rules.iter().enumerate().map(rule) }</> }
}

/// How many stops of a robot are listed.
const STOPS: usize = 8;

fn show_plan(lane: &Lane, units: Option<Units>, send: &Callback<Action>) -> Html {
    let (slow, waits, broken) = (lane.count(Way::Slow), lane.waits(), lane.count(Way::Broken));
    let turns = lane.turns();
    let arrival = lane.arrival;
    let stops = lane.stops();
    html! {
        <>
            <div><dt>{ tr!("Arrives") }</dt><dd><span>{ tr!("before a time" => "at") }{ " " }{ time(arrival, send) }if let Some(after) = words::duration(units, arrival) { { format!(" ({after})") } }</span></dd></div>
            <div>
                <dt>{ tr!("Path") }</dt>
                <dd><span>
                    <b>{ lane.moves() }</b>{ tr!("after a bold number" => " move" | " moves" % lane.moves()) }
                    if slow > 0 { { tr!(", {slow} of them slow", slow) } }
                </span></dd>
            </div>
            if waits > 0 {
                <div><dt>{ tr!("Waits") }</dt><dd><span class="times">
                    <b>{ waits }</b>{ tr!("after a bold number" => " step" | " steps" % waits) }
                    if turns > 0 { { tr!(", {turns} of them to turn", turns) } }
                    if broken == waits { { tr!(", in which it is broken down") } } else if broken > 0 { { tr!(", {broken} of them broken down", broken) } }
                    { tr!("after how many steps a robot waits, before times" => ", from") }{ " " }{ for stops.iter().take(STOPS).map(|&at| html! { <>{ time(at, send) }{ " " }</> }) }
                    if stops.len() > STOPS { { "\u{2026}" } }
                </span></dd></div>
            }
            if !lane.charges.is_empty() {
                <div>
                    <dt>{ tr!("Charges") }</dt>
                    <dd><span class="times">{ tr!("before times" => "at") }{ " " }{ for lane.charges.iter().map(|&at| html! { <>{ time(at, send) }{ " " }</> }) }</span></dd>
                </div>
            }
        </>
    }
}

/// A time that can be shown by pressing it.
fn time(at: u32, send: &Callback<Action>) -> Html {
    html! {
        <button type="button" class="link time" title={tr!("Show time {at}", at)} onclick={send.reform(move |_| Action::Play(PlayAction::Seek(at)))}>{ at }</button>
    }
}

fn show_battery(battery: BatteryFacts) -> Html {
    let (full, cells) = battery.cells();
    let cell = |n: u32| {
        let class = match n {
            n if n < full => Some("on"),
            _ if battery.charges => Some("fill"),
            _ => None,
        };
        html! { <i class={classes!(class)}></i> }
    };
    html! {
        <>
            <span class={classes!("cells", battery.reserve.class())} aria-hidden="true">{ for (0..cells).map(cell) }</span>
            <span><b>{ battery.level }</b>{ tr!("after a bold number" => " of {capacity}", capacity = battery.capacity) }{ if battery.charges { tr!(", then full") } else { "" } }</span>
        </>
    }
}
