//! The page as a whole: the state, its reducer, and the places.

use std::rc::Rc;

use giveway_model::format::native;
use giveway_page::{Action, Draft, State, reduce};
use yew::prelude::*;

use crate::Clock;

/// The scene that the page opens on.
const OPENING: &str = include_str!("../../static/examples/warehouse.json");

/// The state in the hands of Yew.
#[derive(Clone, PartialEq)]
struct Desk(Rc<State>);

impl Reducible for Desk {
    type Action = Action;

    fn reduce(self: Rc<Self>, action: Action) -> Rc<Self> {
        Rc::new(Self(Rc::new(reduce(&self.0, action))))
    }
}

fn opening() -> Desk {
    let scene = native::read_scene(OPENING).unwrap_or_default();
    let draft = Draft::new(scene).unwrap_or_default();
    Desk(Rc::new(reduce(&State::new(draft), Action::Solve)))
}

/// The page.
#[component]
pub fn App() -> Html {
    let desk = use_reducer_eq(opening);
    let state = Rc::clone(&desk.0);
    let send = use_callback(desk.dispatcher(), |action: Action, desk| {
        desk.dispatch(action);
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
