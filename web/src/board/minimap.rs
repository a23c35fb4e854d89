//! The whole map, small, over a corner of the board: pressed or dragged, it moves what
//! is in sight.

use std::rc::Rc;

use giveway_page::State;
use giveway_page::board::{Cast, FloorLook, Minimap, dots};
use web_sys::{Element, PointerEvent};
use yew::prelude::*;

use super::floor::FloorShapes;
use super::viewport::Look;
use crate::board::floor::FloorProps;
use crate::part::part;

/// The longest side, in pixels.
const SIDE_PX: f64 = 168.0;

/// The robots as two paths: all others, and the one that is selected. They change step
/// by step: at this size nobody sees them move in between.
#[hook]
pub(super) fn use_dots(is_shown: bool, cast: &Rc<Cast>, state: &State) -> Rc<[String; 2]> {
    let seen = (
        is_shown.then(|| Rc::clone(cast)),
        state.view.playback.time,
        state.selected_agent(),
    );
    use_memo(seen, |(cast, time, selected)| {
        [false, true].map(|is_selected| {
            cast.as_ref().map_or_else(String::new, |cast| {
                let is_one = |agent: usize| (Some(agent) == *selected) == is_selected;
                dots(cast, *time, &is_one)
            })
        })
    })
}

/// The floor, a dot for each robot, and a frame around what is in sight. The keyboard
/// has the cursor of the board, which moves what is in sight, too.
pub(super) fn overview(
    map: Minimap,
    dots: &[String; 2],
    state: &State,
    look: &Callback<Look>,
    place: &NodeRef,
) -> Html {
    let draft = state.world();
    let (width, height) = (draft.grid().width(), draft.grid().height());
    let cell_px = SIDE_PX / f64::from(width.max(height));
    let go = {
        let place = place.clone();
        look.reform(move |event: PointerEvent| Look::Middle(at(map, &place, &event)))
    };
    let onpointerdown = {
        let (go, place) = (go.clone(), place.clone());
        move |event: PointerEvent| {
            event.prevent_default();
            if let Some(place) = place.cast::<Element>() {
                // Without capture a drag ends at the edge.
                let _ = place.set_pointer_capture(event.pointer_id());
            }
            go.emit(event);
        }
    };
    let onpointermove = move |event: PointerEvent| {
        if event.buttons() & 1 != 0 {
            go.emit(event);
        }
    };
    html! {
        <svg ref={place.clone()} class={if map.is_large() { "map overview" } else { "map overview minor" }} role="img" aria-label={map.name()}
            viewBox={format!("0 0 {} {}", 100 * width, 100 * height)}
            width={(f64::from(width) * cell_px).to_string()} height={(f64::from(height) * cell_px).to_string()}
            {onpointerdown} {onpointermove}>
            { part::<FloorShapes>(FloorProps { draft: Rc::clone(draft), look: FloorLook::of(cell_px), used_by: None::<Rc<_>> }) }
            <path class="dots" d={dots[0].clone()} />
            <path class="dots sel" d={dots[1].clone()} />
            <rect class="in-sight" x={map.x.to_string()} y={map.y.to_string()} width={map.width.to_string()} height={map.height.to_string()} />
        </svg>
    }
}

/// The point of the map under a pointer, in cells.
fn at(map: Minimap, place: &NodeRef, event: &PointerEvent) -> giveway_page::Point {
    let Some(place) = place.cast::<Element>() else {
        return map.point(0.5, 0.5);
    };
    let rect = place.get_bounding_client_rect();
    let share = |px: i32, from: f64, length: f64| {
        ((f64::from(px) - from) / length.max(1.0)).clamp(0.0, 1.0)
    };
    map.point(
        share(event.client_x(), rect.left(), rect.width()),
        share(event.client_y(), rect.top(), rect.height()),
    )
}
