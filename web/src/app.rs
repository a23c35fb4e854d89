//! The page as a whole: the state, its reducer, and the places.

use std::rc::Rc;

use giveway_model::format::native;
use giveway_page::{Action, Draft, Phase, State, Tab, reduce};
use yew::prelude::*;

use crate::{Clock, Shown, solver::use_solver, status::StatusBar, theme::use_theme, top_bar::TopBar};

/// The scene that the page opens on.
const OPENING: &str = include_str!("../../static/examples/warehouse.json");

impl Reducible for Shown {
    type Action = Action;

    fn reduce(self: Rc<Self>, action: Action) -> Rc<Self> {
        Rc::new(Self::new(reduce(&self, action)))
    }
}

fn opening() -> Shown {
    let scene = native::read_scene(OPENING).unwrap_or_default();
    let draft = Draft::new(scene).unwrap_or_default();
    Shown::new(reduce(&State::new(draft), Action::Solve))
}

/// The page.
#[component]
pub fn App() -> Html {
    let shown = use_reducer(opening);
    let state: Shown = (*shown).clone();
    let send = use_callback(shown.dispatcher(), |action: Action, shown| {
        shown.dispatch(action);
    });
    let clock = {
        let send = send.clone();
        use_memo((), move |()| Clock::new(send, wants_less_motion()))
    };
    {
        let clock = clock.clone();
        use_effect_with(
            (state.playback, state.last_time()),
            move |&(playback, last)| clock.follow(playback, last),
        );
    }
    use_solver(&state, &send);
    use_theme(state.view.theme);
    html! {
        <ContextProvider<Clock> context={(*clock).clone()}>
            <div class={classes!("app", phase_class(state.phase()))} data-tab={tab(state.view.tab)}>
                <TopBar state={state.clone()} send={send.clone()} />
                <StatusBar state={state.clone()} send={send.clone()} />
                <main class="stage"></main>
                <aside class="insp" aria-label="Inspector"></aside>
                <section class="dock empty" aria-label="Timeline"></section>
            </div>
        </ContextProvider<Clock>>
    }
}

/// The phase in the style sheets.
const fn phase_class(phase: Phase) -> &'static str {
    match phase {
        Phase::Editing => "st-editing",
        Phase::Solving => "st-solving",
        Phase::Planned => "st-planned",
        Phase::None => "st-none",
        Phase::Stopped => "st-stopped",
    }
}

/// What a phone shows below the board, in the style sheets.
const fn tab(tab: Tab) -> &'static str {
    match tab {
        Tab::Inspector => "inspector",
        Tab::Timeline => "timeline",
        Tab::Plan => "plan",
    }
}

fn wants_less_motion() -> bool {
    let query = gloo::utils::window().match_media("(prefers-reduced-motion: reduce)");
    query.ok().flatten().is_some_and(|query| query.matches())
}
