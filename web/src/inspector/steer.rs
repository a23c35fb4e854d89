//! A plan of one's own: the agent that is led, what is against the rules, what it
//! costs.

use giveway_model::tr;
use giveway_page::ask::Happening;
use giveway_page::rules::RuleAction;
use giveway_page::steering::{Facts, Lead, facts};
use giveway_page::{Action, PlayAction, Selection, State};
use yew::prelude::*;

use super::{agent, cell, pays};
use crate::{Shown, glyph, icon};

/// The button that begins to lead the agent that is selected; nothing where it
/// cannot be led.
#[inline(never)]
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    let Some(agent) = state.can_steer() else {
        return html! {};
    };
    let agents = state.document.draft.agents();
    let name = agents.get(agent).map_or("", |agent| agent.name.as_str());
    let led = state.document.mode.steering().map(|own| own.agent);
    let text = if led == Some(agent) {
        tr!(
            "Lead {name} again from time {time}",
            name,
            time = state.view.playback.time
        )
    } else {
        tr!("Lead {name} by hand", name)
    };
    html! {
        <button type="button" class="btn outline more" title={tr!("Key: L")}
            onclick={send.reform(|_| Action::Steer(Lead::Begin))}>
            { icon::show("steer") }{ text }
        </button>
    }
}

/// What there is to tell while an agent is led; nothing otherwise.
#[inline(never)]
pub(super) fn show(state: &Shown, send: &Callback<Action>) -> Option<Html> {
    let facts = facts(state)?;
    let other = match state.view.selection {
        Selection::Agent(index) if index != facts.agent => {
            giveway_page::inspect::agent(state, index).map(|about| agent::show(state, &about, send))
        }
        Selection::Cell(at) => {
            giveway_page::inspect::cell(state, at).map(|about| cell::show(state, &about, send))
        }
        _ => None,
    };
    Some(other.unwrap_or_else(|| led(state, &facts, send)))
}

fn led(state: &State, facts: &Facts, send: &Callback<Action>) -> Html {
    let open = |text: &String| html! { <li>{ text.clone() }</li> };
    html! {
        <>
            <header class="ih">
                { glyph::named(state, facts.agent) }
                <div><h2>{ tr!("Your plan") }</h2><p>{ facts.place.clone() }</p></div>
            </header>
            { pad(facts, send) }
            <section aria-label={tr!("Against the rules")}>
                <h3>{ tr!("Against the rules") }</h3>
                if facts.violations.is_empty() {
                    <p class="remark">{ tr!("Nothing so far.") }</p>
                } else {
                    <ul class="problems">{ for facts.violations.iter().map(|v| violation(v, send)) }</ul>
                }
                if let Some(rule) = facts.breaks {
                    <div class="pair">
                        <button type="button" class="btn outline" onclick={send.reform(|_| Action::Steer(Lead::Back))}>{ icon::show("undo") }{ tr!("Take the step back") }</button>
                        <button type="button" class="btn outline" onclick={send.reform(move |_| Action::Rules(RuleAction::Show(rule)))}>{ icon::show("search") }{ tr!("Show the rule") }</button>
                    </div>
                }
                if facts.more > 0 {
                    <p class="remark">{ tr!("And {more} more.", more = facts.more) }</p>
                }
            </section>
            if !facts.to_do.is_empty() {
                <section aria-label={tr!("Not done yet")}>
                    <h3>{ tr!("Not done yet") }</h3>
                    <ul class="to-do">{ for facts.to_do.iter().map(open) }</ul>
                </section>
            }
            if let Some(count) = &facts.count { <p class="remark">{ count.clone() }</p> }
            <section>
                <h3>{ if facts.to_do.is_empty() { tr!("Costs") } else { tr!("Costs so far") } }</h3>
                { pays::costs(&facts.rows, tr!("Costs of both plans"), [tr!("Plan"), tr!("Yours")]) }
            </section>
            <p class="remark">{ tr!("Select another robot to lead it in the same plan, too.") }</p>
        </>
    }
}

/// The keys of a keyboard as buttons: the arrows, waiting, taking back.
fn pad(facts: &Facts, send: &Callback<Action>) -> Html {
    let button = |class: &'static str,
                  name: &'static str,
                  keys: &'static str,
                  lead: Lead,
                  shown: Html| {
        // What cannot be done is said by the status line: a button that is off
        // would lose the focus.
        let is_off = match lead {
            Lead::Back => !facts.can_go_back,
            Lead::Charge => facts.charges.is_none(),
            _ => false,
        };
        let pressed = match lead {
            Lead::Charge if facts.charges == Some(true) => Some("true"),
            Lead::Charge => Some("false"),
            _ => None,
        };
        html! {
            <button type="button" {class} aria-label={name} title={keys} aria-pressed={pressed}
                aria-disabled={is_off.then_some("true")} onclick={send.reform(move |_| Action::Steer(lead))}>
                { shown }
            </button>
        }
    };
    let arrow = |class, name, by| {
        button(
            class,
            name,
            tr!("Arrow key"),
            Lead::Step(by),
            html! { { icon::show("down") } },
        )
    };
    let worded = |class, name, keys, lead, icon: &'static str| {
        button(
            class,
            name,
            keys,
            lead,
            html! { <>{ icon::show(icon) }{ name }</> },
        )
    };
    html! {
        <div class="pad" role="group" aria-label={tr!("Lead it")}>
            { worded("btn ghost", tr!("Back"), "Backspace", Lead::Back, "undo") }
            { arrow("btn outline pad-up", tr!("Up"), (0, -1)) }
            { worded("btn outline", tr!("Wait"), "W", Lead::Step((0, 0)), "pause") }
            { arrow("btn outline pad-left", tr!("Left"), (-1, 0)) }
            { arrow("btn outline", tr!("Down"), (0, 1)) }
            { arrow("btn outline pad-right", tr!("Right"), (1, 0)) }
            if facts.has_battery {
                { worded("btn outline pad-charge", tr!("Charge in the next step"), "C", Lead::Charge, "charger") }
            }
        </div>
    }
}

/// Pressing it shows its time.
fn violation(violation: &Happening, send: &Callback<Action>) -> Html {
    let time = violation.time;
    html! {
        <li><button type="button" class="problem" title={tr!("Show time {time}", time)}
            aria-current={violation.is_lit.then_some("time")} onclick={send.reform(move |_| Action::Play(PlayAction::Seek(time)))}>
            { icon::show("collision") }<span>{ violation.text.clone() }</span>
        </button></li>
    }
}

/// What stays at the foot of the inspector.
#[inline(never)]
pub(super) fn foot(send: &Callback<Action>) -> Html {
    html! {
        <footer class="foot">
            <button type="button" class="btn ghost" onclick={send.reform(|_| Action::Steer(Lead::Discard))}>
                { icon::show("undo") }{ tr!("Discard") }
            </button>
        </footer>
    }
}
