//! The transport: time shown, playing, speed, and what is shown of the plan.

use giveway_model::tr;
use giveway_page::changing::columns;
use giveway_page::freedom::{Chip, FreedomAction, TITLE, chip, is_offered};
use giveway_page::keys::key_name;
use giveway_page::{
    Action, ChangeAction, FileAction, PlayAction, Speed, State, ViewAction, table, words,
};
use gloo::timers::callback::Timeout;
use yew::prelude::*;

use super::DockProps;
use super::time_field::time_field;
use crate::part::part;
use crate::turning::{Turning, TurningProps};
use crate::{copy, icon};

/// How long it is shown that the table was copied, in milliseconds.
const COPIED_MS: u32 = 1600;

/// The buttons above the lanes.
pub(super) fn transport(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    let has_tabs = state.can_look_inside() || state.can_show_robots();
    html! {
        <div class={classes!("transport", has_tabs.then_some("two"))}>
            { super::places(state, send) }
            { play_keys(state, send) }
            { clock(state, send) }
            { speed(state.view.playback.speed, send) }
            { change(props) }
            <span class="grow"></span>
            { views(props) }
        </div>
    }
}

/// The time shown. No live region: nobody wants every step read aloud.
pub(crate) fn clock(state: &State, send: &Callback<Action>) -> Html {
    let (time, last) = (state.view.playback.time, state.last_time());
    let field = time_field((time, last), state.view.playback.playing, send);
    let changes = state.document.mode.changing();
    if changes.is_some() && state.document.mode.comparing().is_none() {
        return html! {
            <p class="clock" title={tr!("The world changes at time {last}", last)}>{ field }<span>{ tr!("after a bold number" => "change at {last}", last) }</span></p>
        };
    }
    html! {
        <p class="clock" title={tr!("Time {time} of {last}", time, last)}>{ field }<span>{ tr!("after a bold number" => " of {last}", last) }</span>
            if let Some(passed) = words::duration(state.world().scene().units, time) { <small>{ passed }</small> }</p>
    }
}

/// The buttons that play and step.
pub(crate) fn play_keys(state: &State, send: &Callback<Action>) -> Html {
    let playback = state.view.playback;
    let last = state.last_time();
    let button = |icon: &'static str,
                  name: &'static str,
                  key: &'static str,
                  action: Action,
                  off: bool| {
        let send = send.clone();
        html! {
            <button type="button" class="btn ghost round" title={format!("{name} ({})", key_name(key))} disabled={off}
                onclick={move |_| send.emit(action.clone())}>
                { icon::show(icon) }<span class="vh">{ name }</span>
            </button>
        }
    };
    let (at_start, at_end) = (playback.time == 0, playback.time >= last);
    let (icon, name, action) = if playback.playing {
        ("pause", tr!("Pause"), Action::Play(PlayAction::Pause))
    } else {
        ("play", tr!("Play"), Action::Play(PlayAction::Play))
    };
    html! {
        <div class="keys">
            { button("start", tr!("To start"), "Home", Action::Play(PlayAction::Seek(0)), at_start && !playback.playing) }
            { button("step-back", tr!("Step back"), ",", Action::Play(PlayAction::StepBack), at_start) }
            { play_button(icon, name, last == 0, send.reform(move |_| action.clone())) }
            { button("step", tr!("Step forward"), ".", Action::Play(PlayAction::StepForward), at_end) }
            { button("end", tr!("To end"), "End", Action::Play(PlayAction::Seek(last)), at_end) }
        </div>
    }
}

/// The button that plays and pauses. Where the end turns it, it does not begin anew under a
/// press that was to pause.
pub(super) fn play_button(
    icon: &'static str,
    name: &'static str,
    is_off: bool,
    onclick: Callback<MouseEvent>,
) -> Html {
    part::<Turning>(TurningProps {
        meaning: name.into(),
        class: classes!("btn", "playb"),
        title: Some(tr!("{name} (Space)", name).into()),
        label: None,
        is_off,
        is_toggle: true,
        content: html! { <>{ icon::show(icon) }<span class="vh">{ name }</span></> },
        onclick,
    })
}

/// What lets the world change here, or which way to go on is previewed.
fn change(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    let chosen = columns(state).and_then(|columns| columns.into_iter().find(|c| c.is_chosen));
    if let Some(column) = chosen {
        return html! { <span class="preview">{ tr!("Previewing") }{ " " }<b>{ column.titles.join(", ") }</b></span> };
    }
    if !state.can_change() {
        return html! {};
    }
    html! {
        <button type="button" class="btn chip change-here" title={tr!("Change the world here (x)")}
            onclick={send.reform(|_| Action::Change(ChangeAction::Begin))}>
            { icon::show("change") }<span>{ tr!("Change here") }</span>
        </button>
    }
}

/// The chip of the trails, in whose place what must be so stands where that is laid over
/// the plan: they come back with a press.
fn trails(state: &State, send: &Callback<Action>) -> Html {
    let is_covered = state.is_laid_over();
    let on = state.view.layers.trails && !is_covered;
    let press = send.reform(move |_| Action::View(ViewAction::ShowTrails(!on)));
    let uncover = send.reform(|()| Action::Freedom(FreedomAction::Show(false)));
    let onclick = move |event: MouseEvent| {
        if is_covered {
            uncover.emit(());
        }
        press.emit(event);
    };
    html! {
        <button type="button" class={classes!("btn", "chip", "view", on.then_some("on"))} title={tr!("Trails")}
            aria-pressed={on.to_string()} {onclick}>
            { icon::show("trail") }<span>{ tr!("Trails") }</span>
        </button>
    }
}

/// The chip that lays what must be so over the plan; where that cannot be, it says why.
fn must_be_so(state: &State, send: &Callback<Action>) -> Html {
    if !is_offered(state) {
        return html! {};
    }
    let (on, title) = match chip(state) {
        Chip::Off(why) => (None, why.to_owned()),
        Chip::Ready => (Some(false), format!("{} (m)", TITLE.text())),
        Chip::On => (Some(true), format!("{} (m)", TITLE.text())),
    };
    let is_on = on == Some(true);
    html! {
        <button type="button" class={classes!("btn", "chip", "must-be", is_on.then_some("on"))} {title}
            aria-pressed={is_on.to_string()} aria-disabled={on.is_none().then_some("true")}
            onclick={send.reform(move |_| Action::Freedom(FreedomAction::Show(!is_on)))}>
            { icon::show("free") }<span>{ TITLE.text() }</span>
        </button>
    }
}

fn views(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    let chip = |class: &'static str,
                icon: &'static str,
                name: &'static str,
                on: bool,
                action: Action| {
        let send = send.clone();
        html! {
            <button type="button" class={classes!("btn", "chip", class, on.then_some("on"))} title={name}
                aria-pressed={on.to_string()} onclick={move |_| send.emit(action.clone())}>
                { icon::show(icon) }<span>{ name }</span>
            </button>
        }
    };
    let view = &state.view;
    html! {
        <div class="views">
            { must_be_so(state, send) }
            { trails(state, send) }
            { chip("view", "heat", tr!("Heat map"), view.layers.heat, Action::View(ViewAction::ShowHeat(!view.layers.heat))) }
            { chip("", "down", tr!("Plan table"), view.table, Action::View(ViewAction::ShowTable(!view.table))) }
            { part::<CopyButton>(props.clone()) }
        </div>
    }
}

/// Copies the plan table as text, and says that it did.
#[component]
fn CopyButton(props: &DockProps) -> Html {
    let copied = use_state_eq(|| false);
    {
        let copied = copied.clone();
        use_effect_with(*copied, move |&is_copied| {
            let later = is_copied.then(|| Timeout::new(COPIED_MS, move || copied.set(false)));
            move || drop(later)
        });
    }
    let onclick = {
        let DockProps { state, send } = props.clone();
        let copied = copied.clone();
        move |_| {
            let Some(answer) = state.shown() else { return };
            let copied = copied.clone();
            let send = send.clone();
            copy::text(
                tr!("plan table"),
                &table::text(answer),
                move |done| match done {
                    Ok(()) => copied.set(true),
                    Err(notice) => send.emit(Action::File(FileAction::Tell(notice))),
                },
            );
        }
    };
    html! {
        <>
            <button type="button" class="btn ghost round" title={tr!("Copy the plan table as text")} {onclick}>
                { icon::show(if *copied { "check" } else { "copy" }) }<span class="vh">{ tr!("Copy as text") }</span>
            </button>
            <span class="vh" aria-live="polite">{ if *copied { tr!("Copied") } else { "" } }</span>
        </>
    }
}

/// The speeds side by side; on a phone one button that goes on to the next.
fn speed(speed: Speed, send: &Callback<Action>) -> Html {
    let one = |&choice: &Speed| {
        let onclick = send.reform(move |_| Action::Play(PlayAction::SetSpeed(choice)));
        html! {
            <button type="button" aria-pressed={(choice == speed).to_string()} {onclick}>{ choice.name() }</button>
        }
    };
    let at = Speed::ALL.iter().position(|&choice| choice == speed);
    let next = Speed::ALL[(at.unwrap_or(0) + 1) % Speed::ALL.len()];
    html! {
        <>
            <div class="seg speed" role="group" aria-label={tr!("Speed")}>{ for Speed::ALL.iter().map(one) }</div>
            <button type="button" class="btn outline speed-next" title={tr!("Speed")}
                onclick={send.reform(move |_| Action::Play(PlayAction::SetSpeed(next)))}>
                <span class="vh">{ tr!("Speed") }{ " " }</span>{ speed.name() }
            </button>
        </>
    }
}
