//! A plan of one's own: the agent that is led, what is against the rules, what it
//! costs.

use giveway_page::ask::Happening;
use giveway_page::steering::{Facts, Lead, facts};
use giveway_page::{Action, Selection, State};
use yew::prelude::*;

use super::{agent, answer, cell};
use crate::{Glyph, Icon, Shown};

/// The button that begins to lead the agent that is selected; nothing where it
/// cannot be led.
pub(super) fn begin(state: &State, send: &Callback<Action>) -> Html {
    let Some(agent) = state.can_steer() else {
        return html! {};
    };
    let agents = state.draft.agents();
    let name = agents.get(agent).map_or("", |agent| agent.name.as_str());
    let led = state.steering.as_deref().map(|own| own.agent);
    let text = if led == Some(agent) {
        format!("Lead {name} anew from time {}", state.playback.time)
    } else {
        format!("Lead {name} by hand")
    };
    html! {
        <button type="button" class="btn outline more" title={format!("{text} (l)")}
            onclick={send.reform(|_| Action::Steer(Lead::Begin))}>
            <Icon name="steer" />{ text }
        </button>
    }
}

/// What there is to tell while an agent is led; nothing otherwise.
pub(super) fn show(state: &Shown, send: &Callback<Action>) -> Option<Html> {
    let facts = facts(state)?;
    let other = match state.selection {
        Selection::Agent(index) if index != facts.agent => {
            giveway_page::inspect::agent(state, index).map(|about| agent::show(&about, send))
        }
        Selection::Cell(at) => {
            giveway_page::inspect::cell(state, at).map(|about| cell::show(state, &about, send))
        }
        _ => None,
    };
    Some(other.unwrap_or_else(|| led(&facts, send)))
}

fn led(facts: &Facts, send: &Callback<Action>) -> Html {
    let open = |text: &String| html! { <li>{ text.clone() }</li> };
    html! {
        <>
            <header class="ih">
                <Glyph agent={facts.agent} name={facts.name.clone()} class="insp-glyph" />
                <div><h2>{ "Your plan" }</h2><p>{ facts.place.clone() }</p></div>
            </header>
            { pad(facts, send) }
            <section aria-label="Against the rules">
                <h3>{ "Against the rules" }</h3>
                if facts.violations.is_empty() {
                    <p class="remark">{ "Nothing so far." }</p>
                } else {
                    <ul class="problems">{ for facts.violations.iter().map(|v| violation(v, send)) }</ul>
                }
                if facts.more > 0 {
                    <p class="remark">{ format!("And {} more.", facts.more) }</p>
                }
            </section>
            if !facts.to_do.is_empty() {
                <section aria-label="Not done yet">
                    <h3>{ "Not done yet" }</h3>
                    <ul class="to-do">{ for facts.to_do.iter().map(open) }</ul>
                </section>
            }
            <section>
                <h3>{ if facts.to_do.is_empty() { "Costs" } else { "Costs so far" } }</h3>
                { answer::costs(&facts.rows, "Costs of both plans", ["Plan", "Yours"]) }
            </section>
            <p class="remark">{ "Select another agent to lead it in the same plan, too." }</p>
        </>
    }
}

/// The keys of a keyboard as buttons: the arrows, waiting, taking back.
fn pad(facts: &Facts, send: &Callback<Action>) -> Html {
    let press = |lead: Lead| send.reform(move |_: MouseEvent| Action::Steer(lead));
    let arrow = |name: &'static str, class: &'static str, by: (i32, i32)| {
        html! {
            <button type="button" class={classes!("btn", "outline", class)} aria-label={name}
                title={format!("{name} (arrow key)")} onclick={press(Lead::Step(by))}>
                <Icon name="down" />
            </button>
        }
    };
    html! {
        <div class="pad" role="group" aria-label={format!("Lead {}", facts.name)}>
            <button type="button" class="btn ghost" title="Back (Backspace)" aria-disabled={(!facts.can_go_back).to_string()}
                onclick={press(Lead::Back)}><Icon name="undo" />{ "Back" }</button>
            { arrow("Up", "pad-up", (0, -1)) }
            <button type="button" class="btn outline" title="Wait (w)" onclick={press(Lead::Step((0, 0)))}>
                <Icon name="pause" />{ "Wait" }
            </button>
            { arrow("Left", "pad-left", (-1, 0)) }
            { arrow("Down", "pad-down", (0, 1)) }
            { arrow("Right", "pad-right", (1, 0)) }
            if facts.has_battery {
                <button type="button" class="btn outline pad-charge" title="Charge in the next step (c)"
                    aria-pressed={(facts.charges == Some(true)).to_string()}
                    aria-disabled={facts.charges.is_none().to_string()} onclick={press(Lead::Charge)}>
                    <Icon name="charger" />{ "Charge in the next step" }
                </button>
            }
        </div>
    }
}

/// Pressing it shows its time.
fn violation(violation: &Happening, send: &Callback<Action>) -> Html {
    let time = violation.time;
    html! {
        <li><button type="button" class="problem" title={format!("Show time {time}")}
            aria-current={violation.is_lit.then_some("time")} onclick={send.reform(move |_| Action::Seek(time))}>
            <Icon name="collision" /><span>{ violation.text.clone() }</span>
        </button></li>
    }
}

/// What stays at the foot of the inspector.
pub(super) fn foot(send: &Callback<Action>) -> Html {
    html! {
        <footer class="foot">
            <button type="button" class="btn ghost" onclick={send.reform(|_| Action::Steer(Lead::Discard))}>
                <Icon name="undo" />{ "Discard" }
            </button>
        </footer>
    }
}
