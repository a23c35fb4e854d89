//! The whole map, small, over a corner of the board: pressed or dragged, it moves what
//! is in sight.

use std::rc::Rc;

use giveway_page::Draft;
use giveway_page::board::{Cast, FloorLook, Minimap, dots};
use web_sys::{Element, PointerEvent};
use yew::prelude::*;

use super::floor::FloorShapes;
use super::viewport::Look;

/// The longest side, in pixels.
const SIDE_PX: f64 = 168.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct OverviewProps {
    /// What is in sight.
    pub(super) map: Minimap,
    pub(super) draft: Rc<Draft>,
    pub(super) cast: Rc<Cast>,
    pub(super) time: u32,
    pub(super) selected: Option<usize>,
    /// Changes what is in sight.
    pub(super) look: Callback<Look>,
}

/// The floor, a dot for each robot, and a frame around what is in sight. The keyboard
/// has the cursor of the board, which moves what is in sight, too.
#[component]
pub(super) fn Overview(props: &OverviewProps) -> Html {
    let OverviewProps {
        map,
        draft,
        cast,
        time,
        selected,
        look,
    } = props;
    let (width, height) = (draft.grid().width(), draft.grid().height());
    let cell_px = SIDE_PX / f64::from(width.max(height));
    let go = {
        let (map, look) = (*map, look.clone());
        move |event: PointerEvent| {
            let Some(place) = event
                .current_target()
                .map(web_sys::wasm_bindgen::JsCast::unchecked_into::<Element>)
            else {
                return;
            };
            event.prevent_default();
            if event.type_() == "pointerdown" {
                // Without capture a drag ends at the edge.
                let _ = place.set_pointer_capture(event.pointer_id());
            }
            let rect = place.get_bounding_client_rect();
            let share = |px: i32, from: f64, length: f64| {
                ((f64::from(px) - from) / length.max(1.0)).clamp(0.0, 1.0)
            };
            look.emit(Look::Middle(map.point(
                share(event.client_x(), rect.left(), rect.width()),
                share(event.client_y(), rect.top(), rect.height()),
            )));
        }
    };
    let drag = {
        let go = go.clone();
        move |event: PointerEvent| {
            if event.buttons() & 1 != 0 {
                go(event);
            }
        }
    };
    html! {
        <svg class={classes!("map", "overview", (!map.is_large()).then_some("minor"))} role="img" aria-label={map.name()}
            viewBox={format!("0 0 {} {}", 100 * width, 100 * height)}
            width={(f64::from(width) * cell_px).to_string()} height={(f64::from(height) * cell_px).to_string()}
            onpointerdown={go} onpointermove={drag}>
            <FloorShapes draft={Rc::clone(draft)} look={FloorLook::of(cell_px)} used_by={None::<Rc<_>>} />
            <Dots cast={Rc::clone(cast)} {time} {selected} />
            <rect class="in-sight" x={map.x.to_string()} y={map.y.to_string()} width={map.width.to_string()} height={map.height.to_string()} />
        </svg>
    }
}

#[derive(Clone, Properties)]
struct DotsProps {
    cast: Rc<Cast>,
    time: u32,
    selected: Option<usize>,
}

impl PartialEq for DotsProps {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.cast, &other.cast)
            && self.time == other.time
            && self.selected == other.selected
    }
}

/// Where everybody is, step by step: at this size nobody sees them move in between.
#[component]
fn Dots(props: &DotsProps) -> Html {
    let DotsProps {
        cast,
        time,
        selected,
    } = props;
    html! {
        <>
            <path class="dots" d={dots(cast, *time, |agent| Some(agent) != *selected)} />
            <path class="dots sel" d={dots(cast, *time, |agent| Some(agent) == *selected)} />
        </>
    }
}
