//! The board to be looked at: where the page is shown inside another one, no
//! pointer, wheel or finger is taken from that, and nothing is edited.

use std::rc::Rc;

use giveway_page::board::Camera;
use yew::prelude::*;

use super::beside::Beside;
use super::casts::use_casts;
use super::{BOARD, BoardProps, floor, keys};
use crate::board::beside::BesideProps;
use crate::part::part;

/// The board, all of the map in sight.
#[component]
pub(crate) fn Still(props: &BoardProps) -> Html {
    let BoardProps { state, send } = props;
    let (cast, _) = use_casts(state);
    let rows = state.world().grid().height();
    let onkeydown = keys::use_cursor_keys(state.view.cursor, send, &Callback::noop(), rows);
    html! {
        <main class="stage">
            <svg class="vh" aria-hidden="true">{ floor::hatch("hatch") }</svg>
            { part::<Beside>(BesideProps { name: BOARD, state: state.clone(), cast: Rc::clone(&cast), versus: None::<Rc<_>>, onkeydown, camera: Camera::default() }) }
        </main>
    }
}
