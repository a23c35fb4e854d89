//! What the solver is told: objective, rules, limits.

mod order;

use giveway_model::{AtGoal, tr};
use giveway_page::{Action, Edit, Settings, State, ViewAction};
use web_sys::{HtmlInputElement, HtmlSelectElement};
use yew::prelude::*;

use crate::field::number;
use crate::{icon, language};

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
                <h2 id="settings-title">{ tr!("Settings") }</h2>
                <button class="btn ghost round" title={tr!("Close (Escape)")} onclick={close}>
                    { icon::show("cancel") }<span class="vh">{ tr!("Close") }</span>
                </button>
            </header>
            <fieldset>
                <legend>{ tr!("Objective") }</legend>
                { order::show(&scene.objective, send) }
                { switch(tr!("Pareto front of two or three costs"), settings.front, send, ViewAction::SetFront) }
            </fieldset>
            <fieldset>
                <legend>{ tr!("At its goal a robot") }</legend>
                { arrival(scene.rules.at_goal, send) }
            </fieldset>
            <fieldset>
                <legend>{ tr!("Limits") }</legend>
                <div class="fields">
                    { number(tr!("Battery floor"), Some(scene.rules.battery_floor), (0, HIGHEST_FLOOR), None,
                        &send.reform(|n: Option<u32>| Action::Edit(Edit::BatteryFloor(n.unwrap_or(0))))) }
                    { number(tr!("Horizon, steps"), state.document.within, (0, LONGEST), Some(tr!("auto")),
                        &send.reform(|within| Action::Edit(Edit::Within(within)))) }
                    { number(tr!("Time limit, s"), Some(settings.seconds), (1, PATIENCE), None,
                        &send.reform(|n: Option<u32>| {
                            Action::View(ViewAction::SetSeconds(n.unwrap_or(Settings::default().seconds)))
                        })) }
                </div>
                <p class="hint">
                    { tr!("No battery falls below the floor before its robot arrives. \
                       Only plans within the horizon count; empty leaves it to the solver.") }
                </p>
            </fieldset>
            { on_the_board(state, send) }
            <fieldset>
                { switch(tr!("Solve on every change"), settings.solve_on_change, send, ViewAction::SetSolveOnChange) }
                { switch(tr!("Single letters are keys"), settings.letter_keys, send, ViewAction::SetLetterKeys) }
            </fieldset>
            { language(send) }
            <p class="hint">{ format!("Giveway {}", giveway_model::release()) }</p>
        </div>
    }
}

/// The languages; each is named in itself.
fn language(send: &Callback<Action>) -> Html {
    let chosen = language::choice();
    let send = send.clone();
    let onchange = move |event: Event| {
        let select: HtmlSelectElement = event.target_unchecked_into();
        language::choose(&select.value(), &send);
    };
    let option = |(tag, name): (&'static str, &'static str)| {
        html! { <option value={tag} lang={tag} selected={chosen == tag}>{ name }</option> }
    };
    html! {
        <fieldset>
            <legend><label for="language">{ tr!("Language") }</label></legend>
            <select id="language" class="field" {onchange}>
                <option value="" selected={chosen.is_empty()}>{ tr!("a language" => "As the browser") }</option>
                { for language::all().map(option) }
            </select>
        </fieldset>
    }
}

/// What is drawn on the board, for a phone, which has no room for it elsewhere.
fn on_the_board(state: &State, send: &Callback<Action>) -> Html {
    let view = &state.view;
    let agents = state.world().agents();
    let agent = state.selected_agent().and_then(|agent| agents.get(agent));
    html! {
        <fieldset class="phone">
            <legend>{ tr!("On the board") }</legend>
            { switch(tr!("Trails"), view.layers.trails, send, ViewAction::ShowTrails) }
            { switch(tr!("Heat map"), view.layers.heat, send, ViewAction::ShowHeat) }
            if let Some(agent) = agent {
                { switch(&tr!("Follow {agent}", agent = agent.name), view.follow, send, ViewAction::Follow) }
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
        <div class="seg full" role="group" aria-label={tr!("Arrival")}>
            { option(AtGoal::Stay, tr!("a robot at its goal" => "stays")) }
            { option(AtGoal::Vanish, tr!("a robot at its goal" => "leaves the map")) }
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
