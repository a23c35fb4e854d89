//! A cell: what it is and who passes when.

use giveway_model::tr;
use giveway_page::inspect::{CellFacts, Pass};
use giveway_page::{Action, BoardAction, PlayAction, Selection};
use yew::prelude::*;

use super::{back, grow, in_draft, rules};
use crate::{Shown, glyph, icon};

/// The most lines of who passes.
const MAX_PASSES: usize = 60;

pub(super) fn show(state: &Shown, facts: &CellFacts, send: &Callback<Action>) -> Html {
    html! {
        <>
            <header class="ih">
                { back(send) }
                <span class={classes!("cellsw", facts.icon)}>
                    if let Some(icon) = facts.icon { { icon::show(icon) } }
                </span>
                <div><h2>{ facts.title.clone() }</h2><p>{ facts.ground }</p></div>
            </header>
            // It stays where it is when lines come and go: what follows is of the plan.
            { grow::lines(state, send) }
            if !facts.roles.is_empty() {
                <ul class="choices">
                    { for facts.roles.iter().map(|(agent, role)| show_role(*agent, role, send)) }
                </ul>
            }
            if !facts.zones.is_empty() {
                <p class="zones">{ tr!("Zones") }{ " " }{ for facts.zones.iter().map(|zone| rules::zone_button(zone, false, send)) }</p>
            }
            if let Some(passes) = &facts.passes {
                <section>
                    <h3>{ tr!("Who is here when") }</h3>
                    if passes.is_empty() {
                        <p class="remark">{ tr!("Nobody passes here.") }</p>
                    } else {
                        <ul class="choices">{ for passes.iter().take(MAX_PASSES).map(|pass| show_pass(state, pass, send)) }</ul>
                        if passes.len() > MAX_PASSES {
                            <p class="remark">{ tr!("And {more} more.", more = passes.len() - MAX_PASSES) }</p>
                        }
                    }
                </section>
            }
        </>
    }
}

fn show_role(agent: usize, role: &str, send: &Callback<Action>) -> Html {
    let onclick = send.reform(move |_| Action::Board(BoardAction::Select(Selection::Agent(agent))));
    html! {
        <li><button type="button" class="choice" {onclick}>
            { glyph::show(agent, "choice-glyph") }<span>{ role.to_owned() }</span>{ icon::at_end("chevron") }
        </button></li>
    }
}

/// Pressing it shows the time at which the agent comes.
fn show_pass(state: &Shown, pass: &Pass, send: &Callback<Action>) -> Html {
    let from = pass.from;
    let time = state.view.playback.time;
    let is_past = time > from;
    let agent = in_draft(state, &pass.name).unwrap_or(pass.agent);
    html! {
        <li><button type="button" class={classes!("choice", is_past.then_some("past"))} title={tr!("Show time {from}", from)}
            onclick={send.reform(move |_| Action::Play(PlayAction::Seek(from)))}>
            { glyph::show(agent, "choice-glyph") }<span><b>{ pass.name.clone() }</b>{ format!(" {}", pass.when) }</span>
        </button></li>
    }
}
