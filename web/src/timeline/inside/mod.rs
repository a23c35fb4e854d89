//! How the plan was found, in the place of the lanes: the proof, the tree, the orders, the steps
//! of planners of crowds.

mod by_hand;
mod chart;
mod proof;
mod switch;
mod tree;

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::inside::{InsideAction, Method, notes, steps};
use giveway_page::keys::key_name;
use giveway_page::lesson::Lesson;
use giveway_page::{Action, State};
use gloo::timers::callback::Interval;
use yew::prelude::*;

use super::DockProps;
use super::plan::Plan;
use super::tabs::Tabs;
use super::transport::play_button;
use crate::icon;
use crate::part::part;
use crate::same::Same;
use crate::timeline::inside::tree::TreeProps;
use crate::timeline::plan::PlanProps;
use crate::timeline::tabs::TabsProps;
use crate::turning::turning;
use by_hand::HandTabs;
use proof::Proof;
use switch::methods;
pub(super) use switch::places;
use tree::Tree;

/// How long a step is shown where they follow each other, in milliseconds.
const STEP_MS: u32 = 1000;

/// What stands below the board.
#[component]
pub(super) fn Inside(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    {
        let send = send.clone();
        use_effect_with(state.inside.is_playing, move |&is_playing| {
            let tick = move || send.emit(Action::Inside(InsideAction::Tick));
            let ticking = is_playing.then(|| Interval::new(STEP_MS, tick));
            move || drop(ticking)
        });
    }
    let class = match state.inside.method {
        Method::Proof => "pf-proof",
        Method::Tree => "pf-tree",
        Method::Orders => "pf-orders",
        Method::Pibt | Method::Lacam => "pf-crowd",
    };
    html! {
        <section class={classes!("dock", "pf", "calm", class)} aria-label={tr!("How it was proved")}>
            <div class="transport">
                { places(state, send) }
                if state.is_by_hand() { { by_hand::keys(state, send) } } else { { keys(state, send) } }
                <span class="grow"></span>
                if state.inside.method == Method::Tree { { by_hand::who(state, send) } }
                if !state.lesson().is_some_and(Lesson::is_by_hand) { { methods(state, send) } }
            </div>
            if state.is_by_hand() {
                { part::<HandTabs>(by_hand::TabsProps::of(state, send)) }
            } else {
                { part::<Tabs>(TabsProps { tab: state.view.tab, checks: false, teaches: false, inside: Some(state.inside.method), has_table: false, send: send.clone() }) }
            }
            { body(props) }
            <p class="vh" aria-live="polite">{ giveway_page::inside::said(state) }</p>
        </section>
    }
}

fn body(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    match state.inside.method {
        Method::Proof => html! { { part::<Proof>(props.clone()) } },
        Method::Tree => match giveway_page::inside::tree_view(state) {
            Some(view) => html! { { part::<Tree>(TreeProps { view, send: send.clone() }) } },
            None => waiting(state, send),
        },
        Method::Orders => match (notes(state), state.shown()) {
            (Some(notes), Some(answer)) => html! {
                { part::<Plan>(PlanProps { answer: Same::new(Rc::clone(answer)), beside: None::<Same<_>>, notes: Some(Rc::new(notes)), state: state.clone(), send: send.clone() }) }
            },
            _ => waiting(state, send),
        },
        Method::Pibt | Method::Lacam => match state.inside_answer() {
            Some(answer) => html! {
                { part::<Plan>(PlanProps { answer: Same::new(Rc::clone(answer)), beside: None::<Same<_>>, notes: None::<Rc<_>>, state: state.clone(), send: send.clone() }) }
            },
            None => waiting(state, send),
        },
    }
}

/// While nothing is known yet, or where nothing could be found out.
fn waiting(state: &State, send: &Callback<Action>) -> Html {
    let nothing = giveway_page::inside::nothing(state);
    let button = nothing.action.map(|(text, action)| {
        let press = send.reform(move |_: MouseEvent| action.clone());
        turning("outline", text, html! { { text } }, press)
    });
    html! {
        <div class="nil lanes" id="lanes">
            { icon::show("clock") }
            <p><b>{ nothing.title }</b>{ nothing.text }</p>
            { button }
        </div>
    }
}

/// The buttons that step, and which step it is.
fn keys(state: &State, send: &Callback<Action>) -> Html {
    let steps = steps(state);
    let button = |icon: &'static str,
                  name: &'static str,
                  key: &'static str,
                  action: InsideAction,
                  on: bool| {
        html! {
            <button type="button" class="btn ghost round" title={format!("{name} ({})", key_name(key))} disabled={!on}
                onclick={send.reform(move |_| Action::Inside(action))}>
                { icon::show(icon) }<span class="vh">{ name }</span>
            </button>
        }
    };
    let before = steps.as_ref().is_some_and(|steps| steps.has_before);
    let after = steps.as_ref().is_some_and(|steps| steps.has_after);
    let is_playing = steps.as_ref().is_some_and(|steps| steps.is_playing);
    let (icon, name) = if is_playing {
        ("pause", tr!("Pause"))
    } else {
        ("play", tr!("Play"))
    };
    let play = send.reform(move |_| Action::Inside(InsideAction::Play(!is_playing)));
    html! {
        <>
            <div class="keys">
                { button("start", tr!("First step"), "Home", InsideAction::First, before) }
                { button("step-back", tr!("Step before"), ",", InsideAction::Back, before) }
                { play_button(icon, name, !before && !after, play) }
                { button("step", tr!("Next step"), ".", InsideAction::Next, after) }
                { button("end", tr!("Last step"), "End", InsideAction::Last, after) }
            </div>
            if let Some(steps) = steps {
                <p class="clock"><b>{ steps.at }</b><span>{ format!(" {}", steps.of) }</span></p>
            }
        </>
    }
}
