//! The dock below the board: transport, lanes and plan table; while a plan is
//! sought, how far that has come.

mod bars;
mod clash;
mod epochs;
mod head;
mod inside;
mod lane;
mod order;
mod plan;
mod plan_table;
mod rest;
mod robots;
mod ruler;
mod rules;
mod seen;
mod selected;
mod sizing;
mod tabs;
mod time_field;
mod transport;
mod wait;

use std::rc::Rc;

use giveway_model::{Question, tr};
use giveway_page::{Action, AskAction, Phase, State, ViewAction, ask};
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;
use yew::prelude::*;

use crate::held::use_height_before;
use crate::part::part;
use crate::same::Same;
use crate::timeline::plan::PlanProps;
use crate::timeline::tabs::TabsProps;
use crate::timeline::wait::WaitProps;
use crate::{Shown, icon};
use inside::{Inside, places};
use plan::Plan;
use robots::Robots;
use tabs::Tabs;
use transport::transport;
pub(crate) use transport::{clock, play_keys};
use wait::Wait;

/// Windows lower than this, in pixels, begin with the plan table closed, so
/// that the board keeps its room.
const LOW_WINDOW: f64 = 800.0;
/// Up to this width, in pixels, the page is that of a phone.
const PHONE: f64 = 720.0;

/// The state and where actions go.
#[derive(Clone, PartialEq, Properties)]
pub struct DockProps {
    /// The state.
    pub state: Shown,
    /// Takes actions.
    pub send: Callback<Action>,
}

/// Transport, lanes and plan table.
#[component]
pub fn Dock(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    {
        let send = send.clone();
        use_effect_with((), move |()| {
            if is_low_window() {
                send.emit(Action::View(ViewAction::ShowTable(false)));
            }
        });
    }
    let has_lanes = has_lanes(state);
    let lanes = || {
        gloo::utils::document()
            .query_selector(".dock")
            .ok()
            .flatten()?
            .dyn_into()
            .ok()
    };
    let height = use_height_before(!has_lanes, lanes);
    use_effect_with(height, |&height| keep_height(height));
    if state.shows_sizing() && !state.is_inside() {
        return html! { { part::<sizing::Sizing>(props.clone()) } };
    }
    if state.shows_robots() && !state.is_inside() {
        return html! { { part::<Robots>(props.clone()) } };
    }
    if state.is_inside() {
        return html! { { part::<Inside>(props.clone()) } };
    }
    if let Some(run) = state.awaited() {
        let plays = state.so_far().is_some();
        return html! {
            <section class={classes!("dock", "wait", "calm", plays.then_some("plays"))} aria-label={tr!("Timeline")}>
                if plays {
                    { transport(props) }
                } else {
                    <div class="over-wait">{ places(state, send) }</div>
                }
                { part::<Wait>(WaitProps { id: state.work.id().unwrap_or(0), run: run.clone(), table: state.view.table }) }
            </section>
        };
    }
    if let Some(answer) = state.playing().cloned() {
        // The one dark button is elsewhere while the plan is not the answer.
        let calm = matches!(
            state.phase(),
            Phase::Editing
                | Phase::Solving
                | Phase::Asking
                | Phase::Checking
                | Phase::Counting
                | Phase::Changing
                | Phase::Adapting
                | Phase::Comparing
                | Phase::Steering
                | Phase::Auditing
        ) || ask::offers_next_step(state)
            || state.view.waiting.welcome
            || state.shows_order()
            || state.is_writing_rule();
        let stale = state.shows_stale();
        return html! {
            <section class={classes!("dock", calm.then_some("calm"), stale.then_some("stale"))} aria-label={tr!("Timeline")}>
                { transport(props) }
                { tabs(props) }
                { part::<Plan>(PlanProps { answer: Same::new(answer), beside: state.beside().cloned().map(Same::new), notes: None::<Rc<Vec<giveway_page::inside::Note>>>, state: state.clone(), send: send.clone() }) }
            </section>
        };
    }
    let times = giveway_page::rules::clash_times(state);
    // Nothing else is the next step, until it is asked.
    let asks_why = state.phase() == Phase::None
        && state.document.mode.asking().is_none()
        && !state.is_writing_rule();
    let (head, text) = match state.phase() {
        Phase::None => (
            tr!("Nothing to play"),
            tr!("Change the scene and solve it again."),
        ),
        Phase::Stopped => (
            tr!("No plan within the limits"),
            tr!("Raise the time limit, or change the scene, and solve again."),
        ),
        _ => (
            tr!("Nothing to play yet"),
            tr!("Solve the scene: each robot gets a lane here."),
        ),
    };
    html! {
        <section class={classes!("dock", "empty", times.is_some().then_some("clashing"))} aria-label={tr!("Timeline")}>
            if state.can_show_robots() || state.document.fresh_answer().is_some() { <div class="over-wait">{ places(state, send) }</div> }
            <div class="nil">
                { icon::show("clock") }
                <p><b>{ head }</b>{ text }</p>
                if asks_why {
                    <button type="button" class="btn primary" onclick={send.reform(|_| Action::Ask(AskAction::Ask(Question::Unsolvable)))}>
                        { tr!("Why is there no plan?") }
                    </button>
                }
            </div>
            if let Some(times) = times {
                { tabs(props) }
                { clash::show(&times, send) }
            }
        </section>
    }
}

/// The places of a phone below the board.
fn tabs(props: &DockProps) -> Html {
    let DockProps { state, send } = props;
    part::<Tabs>(TabsProps {
        tab: state.shown_tab(),
        checks: state.audit().is_some() && state.lesson().is_none(),
        teaches: state.lesson().is_some(),
        inside: None,
        has_table: state.playing().is_some(),
        send: send.clone(),
    })
}

/// Whether the lanes of a plan stand below the board, or how far it is in their room.
fn has_lanes(state: &State) -> bool {
    let has_other = state.is_inside() || state.shows_robots() || state.shows_sizing();
    !has_other && (state.awaited().is_some() || state.playing().is_some())
}

/// What takes the place of the lanes is as high as they were: the board stays as it is.
fn keep_height(height: Option<i32>) {
    let root = gloo::utils::document_element().dyn_into::<HtmlElement>();
    if let (Ok(root), Some(height)) = (root, height) {
        // Without it, the board gets another size.
        let _ = root
            .style()
            .set_property("--dock-before", &format!("{height}px"));
    }
}

fn is_low_window() -> bool {
    let window = gloo::utils::window();
    let side = |side: Result<wasm_bindgen::JsValue, _>| side.ok().and_then(|side| side.as_f64());
    let (width, height) = (side(window.inner_width()), side(window.inner_height()));
    width.is_some_and(|width| width > PHONE) && height.is_some_and(|height| height <= LOW_WINDOW)
}
