//! What the solver is told: objective, rules, limits.

mod order;

use giveway_model::AtGoal;
use giveway_page::{Action, Edit, Settings, State, ViewAction};
use web_sys::HtmlInputElement;
use yew::prelude::*;

use crate::field::number;
use crate::icon;

/// The longest horizon that can be asked for, in time steps.
const LONGEST: u32 = 10_000;
/// The longest time limit, in seconds.
const PATIENCE: u32 = 3600;
/// The highest battery floor.
const HIGHEST_FLOOR: u32 = 100_000;

/// The card with all settings; each takes effect at once.
pub(crate) fn show(state: &State, send: &Callback<Action>, on_close: &Callback<()>) -> Html {
    let settings = state.settings;
    let scene = state.document.draft.scene();
    let close = on_close.reform(|_: MouseEvent| ());
    html! {
        <div class="settings" role="group" aria-labelledby="settings-title">
            <header>
                <h2 id="settings-title">{ "Settings" }</h2>
                <button class="btn ghost round" title="Close (Escape)" onclick={close}>
                    { icon::show("cancel") }<span class="vh">{ "Close" }</span>
                </button>
            </header>
            <fieldset>
                <legend>{ "Objective" }</legend>
                { order::show(&scene.objective, send) }
                { switch("Pareto front of two or three costs", settings.front, send, ViewAction::SetFront) }
            </fieldset>
            <fieldset>
                <legend>{ "At its goal a robot" }</legend>
                { arrival(scene.rules.at_goal, send) }
            </fieldset>
            <fieldset>
                <legend>{ "Limits" }</legend>
                <div class="fields">
                    { number("Battery floor", Some(scene.rules.battery_floor), (0, HIGHEST_FLOOR), None,
                        &send.reform(|n: Option<u32>| Action::Edit(Edit::BatteryFloor(n.unwrap_or(0))))) }
                    { number("Horizon, steps", state.document.within, (0, LONGEST), Some("auto"),
                        &send.reform(|within| Action::Edit(Edit::Within(within)))) }
                    { number("Time limit, s", Some(settings.seconds), (1, PATIENCE), None,
                        &send.reform(|n: Option<u32>| {
                            Action::View(ViewAction::SetSeconds(n.unwrap_or(Settings::default().seconds)))
                        })) }
                </div>
                <p class="hint">
                    { "No battery falls below the floor before its robot arrives. \
                       Only plans within the horizon count; empty leaves it to the solver." }
                </p>
            </fieldset>
            { on_the_board(state, send) }
            <fieldset>
                { switch("Solve on every change", settings.solve_on_change, send, ViewAction::SetSolveOnChange) }
                { switch("Single letters are keys", settings.letter_keys, send, ViewAction::SetLetterKeys) }
            </fieldset>
            <p class="hint">{ format!("Giveway {}", giveway_model::release()) }</p>
        </div>
    }
}

/// What is drawn on the board, for a phone, which has no room for it elsewhere.
fn on_the_board(state: &State, send: &Callback<Action>) -> Html {
    let view = &state.view;
    let agents = state.world().agents();
    let agent = state.selected_agent().and_then(|agent| agents.get(agent));
    html! {
        <fieldset class="phone">
            <legend>{ "On the board" }</legend>
            { switch("Trails", view.layers.trails, send, ViewAction::ShowTrails) }
            { switch("Heat map", view.layers.heat, send, ViewAction::ShowHeat) }
            if let Some(agent) = agent {
                { switch(&format!("Follow {}", agent.name), view.follow, send, ViewAction::Follow) }
            }
        </fieldset>
    }
}

/// Whether agents stay at their goals or leave.
fn arrival(at_goal: AtGoal, send: &Callback<Action>) -> Html {
    let option = |own: AtGoal, name: &'static str| {
        let press = send.reform(move |_| Action::Edit(Edit::AtGoal(own)));
        let pressed = (own == at_goal).to_string();
        html! { <button aria-pressed={pressed} onclick={press}>{ name }</button> }
    };
    html! {
        <div class="seg full" role="group" aria-label="Arrival">
            { option(AtGoal::Stay, "stays") }
            { option(AtGoal::Vanish, "leaves the map") }
        </div>
    }
}

fn switch(name: &str, on: bool, send: &Callback<Action>, action: fn(bool) -> ViewAction) -> Html {
    let change = send.reform(move |event: Event| {
        let input: HtmlInputElement = event.target_unchecked_into();
        Action::View(action(input.checked()))
    });
    html! {
        <label class="switch">
            <input type="checkbox" role="switch" checked={on} onchange={change} />
            <i></i>
            { name.to_owned() }
        </label>
    }
}
