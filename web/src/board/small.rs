//! A scene as a small picture: the map, and everybody at their starts. It is silent:
//! a sentence beside it tells what there is to see.

use std::rc::Rc;

use giveway_page::board::FloorLook;
use giveway_page::{Draft, form};
use yew::prelude::*;

use super::floor::FloorShapes;
use crate::board::floor::FloorProps;
use crate::part::part;

/// About how large a cell is, in pixels.
const CELL_PX: f64 = 24.0;

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct SmallProps {
    /// The scene.
    pub(crate) draft: Rc<Draft>,
}

/// The picture, as large as its place.
#[component]
pub(crate) fn Small(props: &SmallProps) -> Html {
    let grid = props.draft.grid();
    let agent = |(index, agent): (usize, &giveway_model::Agent)| {
        let (x, y) = (100 * agent.start.x + 50, 100 * agent.start.y + 50);
        html! {
            <g class={form::class(index)} transform={format!("translate({x} {y}) scale(1.3)")}>
                { crate::glyph::of_look(index) }
            </g>
        }
    };
    html! {
        <svg class="map d-forms" viewBox={format!("0 0 {} {}", 100 * grid.width(), 100 * grid.height())}
            aria-hidden="true">
            { part::<FloorShapes>(FloorProps { draft: Rc::clone(&props.draft), look: FloorLook::of(CELL_PX), used_by: None::<Rc<_>> }) }
            { for props.draft.agents().iter().enumerate().map(agent) }
        </svg>
    }
}
