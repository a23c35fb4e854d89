//! The page as a whole: the state, its reducer, and the places.

use std::rc::Rc;

use giveway_model::format::native;
use giveway_page::{Action, Draft, State, reduce};
use yew::prelude::*;

use crate::{Clock, Shown};

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
    html! {
        <ContextProvider<Clock> context={(*clock).clone()}>
            <div class="app">
                <p role="status">{ format!("{:?}", state.phase()) }</p>
            </div>
        </ContextProvider<Clock>>
    }
}

fn wants_less_motion() -> bool {
    let query = gloo::utils::window().match_media("(prefers-reduced-motion: reduce)");
    query.ok().flatten().is_some_and(|query| query.matches())
}
