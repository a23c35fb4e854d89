//! A plan beside the one on the board: the same map, the same clock, the same
//! part of the map in sight. It is looked at; what is done, is done on the board.

use giveway_model::words::Later;
use std::rc::Rc;

use giveway_page::board::{Camera, Cast, Window, reasons_beside};
use giveway_page::grow::Room;
use giveway_page::inside::Overlay;
use giveway_page::{Answer, words};
use web_sys::{Element, KeyboardEvent};
use yew::prelude::*;

use super::cells::Cells;
use super::layers::{Place, layers, picked, square};
use super::pointer::Pointer;
use super::reasons::{ReasonMarks, ReasonsProps};
use super::viewport::{use_sight, use_viewport};
use super::{LETTERS_PX, cells, view_box};
use crate::Shown;
use crate::board::cells::CellsProps;
use crate::part::part;

/// Which plan, on the map of which state.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct BesideProps {
    /// The name of its grid; no two on the page have the same.
    pub(crate) name: Later,
    /// The map, the time, the cell of the keyboard.
    pub(crate) state: Shown,
    /// The agents by the plan.
    pub(crate) cast: Rc<Cast>,
    /// The same agents by the plan that it is compared with.
    pub(crate) versus: Option<Rc<Cast>>,
    /// What is in sight; else all of the map.
    #[prop_or_default]
    pub(crate) camera: Camera,
    /// Takes the keys that move the cell of the keyboard.
    #[prop_or_default]
    pub(crate) onkeydown: Callback<KeyboardEvent>,
}

/// Where two plans are pages to swipe, the one that was just opened is in sight.
#[hook]
fn use_page(area: &NodeRef) {
    let area = area.clone();
    use_effect_with((), move |()| {
        let pages = area.cast::<Element>();
        let pages = pages.and_then(|area| area.closest(".boards").ok().flatten());
        if let Some(pages) = pages {
            pages.set_scroll_left(pages.scroll_width());
        }
    });
}

/// The grid of that plan, as large as the room that it gets.
#[component]
pub(crate) fn Beside(props: &BesideProps) -> Html {
    let BesideProps {
        name,
        state,
        cast,
        versus,
        camera,
        onkeydown,
    } = props;
    let area = use_node_ref();
    use_page(&area);
    let world = Place::Beside.world(state);
    let board = (world.grid().width(), world.grid().height());
    let viewport = use_viewport(&area, Room::of(board), Camera::default());
    let frame = viewport.frame_of(camera, board);
    let sight = use_sight(frame);
    let pointer = use_memo((), |()| Pointer::default());
    let is_picked = picked(state, frame.detail(), &Overlay::default()).is_some();
    let cursor = state.view.cursor;
    let onkeydown = {
        let onkeydown = onkeydown.clone();
        move |event: KeyboardEvent| {
            // Nothing is done here: the tool is applied on the board.
            if !matches!(event.key().as_str(), "Enter" | " ") {
                onkeydown.emit(event);
            }
        }
    };
    html! {
        <div class="bd" ref={area}>
            <svg class={classes!("map", frame.detail().class(), (!camera.is_fit()).then_some("near"), is_picked.then_some("picked"))}
                font-size={format!("{:.1}", frame.units(LETTERS_PX))}
                role="grid" aria-label={name.text()} tabindex="0"
                aria-rowcount={board.1.to_string()} aria-colcount={board.0.to_string()}
                aria-activedescendant={cells::id(name.english(), cursor)}
                viewBox={view_box(&frame)} {onkeydown}>
                { layers(state, Place::Beside, cast, versus.as_ref(), &sight, &Overlay::default(), &pointer) }
                { part::<ReasonMarks>(ReasonsProps { reasons: reasons_beside(state), cell_px: frame.cell_px }) }
                { part::<Cells>(CellsProps { of: name.english(), draft: Rc::clone(world), cast: Rc::clone(cast), time: state.view.playback.time, window: Window::around(cursor, &frame, board), selection: state.view.selection, notes: Vec::new() }) }
                <g aria-hidden="true">{ square("cursor", cursor, 2) }</g>
            </svg>
        </div>
    }
}

/// What stands above one of two plans: which it is, what is claimed of it, and
/// its costs.
pub(super) fn caption(
    title: &str,
    answer: Option<&Rc<Answer>>,
    claim: Option<&'static str>,
) -> Html {
    let costs = answer.and_then(|answer| {
        let objective = &answer.draft.scene().objective;
        Some(words::values(objective, &answer.solved.costs?))
    });
    html! {
        <figcaption><b title={title.to_owned()}>{ title.to_owned() }</b><span>{ claim.unwrap_or_default() }</span><em>{ costs }</em></figcaption>
    }
}
