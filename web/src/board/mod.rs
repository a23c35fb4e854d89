//! The board: the map as one SVG with all that stands and moves on it.
//!
//! What stands still is rendered when it changes; what moves sets its own
//! attributes by hand, frame by frame, from the page's clock. Beneath it are
//! the legend and the buttons of the view.

mod agents;
mod area;
mod axis;
mod beside;
mod casts;
mod cells;
mod chosen;
mod coalesced;
mod differences;
mod film;
mod find;
mod floor;
mod floor_plan;
mod follow;
mod freedom;
mod gestures;
mod ghost;
mod grow;
mod inside;
mod keys;
mod layers;
mod legend;
mod lesson;
mod losses;
mod marks;
mod minimap;
mod motion;
mod nose;
mod options;
mod order;
mod paper;
mod picture;
mod pill;
mod pills;
mod pointer;
mod preview;
mod reasons;
mod rules;
mod short_ways;
mod small;
mod still;
mod thumb;
mod tip;
mod viewport;
mod ways;

use giveway_model::words::Later;
use giveway_model::{tr, tr_later};
use std::rc::Rc;

use giveway_page::beside as titles;
use giveway_page::board::{
    CELL, Camera, Cast, Detail, Frame, Kind, Minimap, PRESENTED_CELL_PX, legend,
};
use giveway_page::freedom::{claim, notes};
use giveway_page::order as order_at;
use giveway_page::{Action, Selection, Tool, ask, ledger};
use yew::prelude::*;

use crate::board::area::{AreaBar, BarProps};
use crate::board::beside::BesideProps;
use crate::board::cells::CellsProps;
use crate::board::grow::{Handles, HandlesProps};
use crate::board::inside::MarksProps;
use crate::board::reasons::ReasonsProps;
use crate::part::part;
use crate::{Shown, icon};
pub(crate) use area::copy_area;
use beside::{Beside, caption};
use casts::use_casts;
use cells::Cells;
pub(crate) use film::Film;
pub(crate) use floor::hatch;
use inside::InsideMarks;
use layers::{Place, layers, problems, square, stopped};
use legend::{Under, under};
use nose::{NoseProps, TurnedNose};
pub(crate) use paper::{PaperBoard, PaperBoardProps};
pub(crate) use picture::picture;
use pointer::Pointer;
pub(crate) use preview::{Preview, PreviewProps};
use reasons::ReasonMarks;
pub(crate) use reasons::STAR;
pub(crate) use small::{Small, SmallProps};
pub(crate) use still::Still;
pub(crate) use thumb::{Thumb, ThumbProps};
use tip::{TipCard, TipProps};
use viewport::{use_sight, use_viewport};

/// The name of the grid of the plan, and of the one of the other plan.
const BOARD: Later = tr_later!("Board");
const OTHER: Later = tr_later!("Other plan");

/// The size of letters on the board where nothing else is said, in pixels: what is to be read at
/// any size of cells has its size in shares of this one.
const LETTERS_PX: f64 = 10.0;

/// What the board shows and where it sends what a person does there.
#[derive(Clone, PartialEq, Properties)]
pub struct BoardProps {
    /// The state of the page.
    pub state: Shown,
    /// Takes actions.
    pub send: Callback<Action>,
}

/// The board, with its legend and the buttons of the view below: two parts of
/// the area `stage`.
#[component]
pub fn Board(props: &BoardProps) -> Html {
    let state = &props.state;
    let area = use_node_ref();
    let svg = use_node_ref();
    let hover = use_node_ref();
    let whole = use_node_ref();
    let (cast, other) = use_casts(state);
    let board = (state.world().grid().width(), state.world().grid().height());
    let is_presented = state.is_presented();
    let whole_map = if is_presented {
        Camera::up_to(PRESENTED_CELL_PX)
    } else {
        Camera::default()
    };
    let room = state.room();
    let viewport = use_viewport(&area, room, whole_map);
    let frame = viewport.frame(room);
    let frame = if picture::use_drawn() {
        picture::enlarged(frame)
    } else {
        frame
    };
    let sight = use_sight(frame);
    let detail = frame.detail();

    let followed = state.followed().filter(|_| cast.has_plan());
    follow::use_follow(followed, &cast, &viewport);
    follow::use_sought(state.view.sought, &viewport.look);
    let look = follow::use_by_hand(followed, &viewport.look, &props.send);
    keys::use_view_keys(&look);
    let map = Minimap::of(&frame, board).filter(|_| !viewport.camera.is_fit());
    let dots = minimap::use_dots(map.is_some(), &cast, state);
    let pointer = use_memo((), |()| Pointer::default());
    let gestures = gestures::use_gestures(gestures::Surface {
        svg: svg.clone(),
        hover: hover.clone(),
        state: state.clone(),
        send: props.send.clone(),
        cast: Rc::clone(&cast),
        look: look.clone(),
        pointer: Rc::clone(&pointer),
        frame,
        is_fit: viewport.camera.is_fit(),
    });
    let (_, rows) = frame.cells(board);
    let page = rows.1 - rows.0;
    let mut onkeydown = keys::use_cursor_keys(state.view.cursor, &props.send, &look, page);
    if is_presented {
        // Arrows go through the plan, wherever the focus is.
        onkeydown = Callback::noop();
    }

    let onkeydown = keys::use_tip_keys(&onkeydown, &pointer, state, &cast);
    let onblur = {
        let pointer = Rc::clone(&pointer);
        move |_: FocusEvent| pointer.set(None)
    };
    let overlay = giveway_page::inside::overlay(state);
    let reasons = giveway_page::board::reasons(state);
    let kinds: Vec<Kind> = legend(state, &cast);
    let is_stale = state.shows_stale() && cast.has_plan();
    let class = classes!(
        "map",
        detail.class(),
        is_stale.then_some("stale"),
        (state.view.playback.time > 0).then_some("later"),
        (state.view.tool != Tool::Select).then_some("brush-on"),
        (!viewport.camera.is_fit()).then_some("near"),
        state.shows_losses().then_some("lossy"),
        layers::picked(state, detail, &overlay)
            .is_some()
            .then_some("picked"),
        state.has_area().then_some("has-area"),
    );
    let cursor = state.view.cursor;
    let window = cells::use_window(cursor, frame, board);
    let board_now = html! {
        <div class="bd" ref={area}>
            <svg {class} ref={svg} data-board="main"
                role="grid" aria-label={BOARD.text()} tabindex="0"
                aria-rowcount={board.1.to_string()} aria-colcount={board.0.to_string()}
                aria-activedescendant={cells::id(BOARD.english(), cursor)}
                viewBox={view_box(&frame)} font-size={format!("{:.1}", frame.units(LETTERS_PX))} {onblur}
                onpointerdown={gestures.down} onpointermove={gestures.moved}
                onpointerup={gestures.up} onpointercancel={gestures.cancel}
                onpointerleave={gestures.leave} onwheel={gestures.wheel} onmousedown={gestures.mouse_down} oncontextmenu={gestures.menu}
                onkeydown={onkeydown.clone()}>
                { floor::hatch("hatch") }
                { layers(state, Place::Board, &cast, other.as_ref(), &sight, &overlay, &pointer) }
                { losses::losses(state, frame.cell_px) }
                { order::strip(state, &cast, frame.cell_px) }
                { part::<ReasonMarks>(ReasonsProps { reasons, cell_px: frame.cell_px }) }
                { part::<InsideMarks>(MarksProps { overlay: overlay.clone(), cell_px: frame.cell_px, columns: board.0 }) }
                { stopped(state) }
                { problems(state) }
                { lesson::marks(state) }
                { ghost::show(state) }
                { floor_plan::handles(state, &props.send, &frame) }
                { area::marks(state, &frame) }
                { grow::marks(state, &frame) }
                if let Some(nose) = giveway_page::board::nose(state) {
                    { part::<TurnedNose>(NoseProps { nose, send: props.send.clone() }) }
                }
                <g aria-hidden="true">
                    if let Selection::Cell(cell) = state.view.selection {
                        { square("selcell", cell, 3) }
                    }
                    <rect class="hover" ref={hover} width="94" height="94" rx="15" visibility="hidden" />
                </g>
                { part::<Cells>(CellsProps { of: BOARD.english(), draft: Rc::clone(state.world()), cast: Rc::clone(&cast), time: state.view.playback.time, window, selection: state.view.selection, notes: ledger::notes(state).or_else(|| order_at::notes(state)).unwrap_or_else(|| notes(state)) }) }
                { freedom::presses(state, detail) }
                <g aria-hidden="true">{ square("cursor", cursor, 2) }</g>
            </svg>
            { part::<TipCard>(TipProps { state: state.clone(), cast: Rc::clone(&cast), frame, pointer }) }
            if state.size_outline().is_some() { { part::<Handles>(HandlesProps { state: state.clone(), frame, send: props.send.clone() }) } }
            if state.has_area() { { part::<AreaBar>(BarProps { state: state.clone(), frame, send: props.send.clone() }) } }
        </div>
    };
    let below = Under {
        kinds,
        signs: giveway_page::inside::legend(state, &overlay)
            .or_else(|| ledger::legend(state))
            .or_else(|| order_at::legend(state)),
        look: &look,
        is_fit: viewport.camera.is_fit(),
        is_nearest: viewport.is_nearest(room.size),
        is_small: frame.detail() < Detail::Plain || !viewport.camera.is_fit(),
        follow: follow(state, &cast),
        send: &props.send,
        state,
    };
    html! {
        <>
            <div class={classes!("boards", other.is_some().then_some("pair"))}>
                <figure class="pl">
                    if other.is_some() {
                        { caption(&titles::title(state), state.shown(), None) }
                    }
                    { board_now }
                    if let Some(map) = map {
                        { minimap::overview(map, &dots, state, &look, &whole) }
                    }
                    if !viewport.camera.is_fit() {
                        { fit(&look) }
                    }
                </figure>
                if let Some(other) = other {
                    <figure class="pl other">
                        { caption(&titles::other_title(state), state.beside(), ask::closeness(state).or_else(|| claim(state))) }
                        { part::<Beside>(BesideProps { name: OTHER, state: state.clone(), cast: other, versus: Some(Rc::clone(&cast)), camera: viewport.camera, onkeydown }) }
                    </figure>
                }
            </div>
            { under(&below) }
        </>
    }
}

/// The agent that the camera can go with, by name, and whether it does.
fn follow(state: &Shown, cast: &Cast) -> Option<(AttrValue, bool)> {
    let agent = cast.agents.get(state.selected_agent()?)?;
    let name = cast.has_plan().then(|| agent.name.clone())?;
    Some((name.into(), state.view.follow))
}

/// The way back to all of the map for a finger, where there is no row of such buttons.
fn fit(look: &Callback<viewport::Look>) -> Html {
    html! {
        <button type="button" class="btn outline fit" onclick={look.reform(|_: MouseEvent| viewport::Look::Fit)}>
            { icon::show("fit") }{ tr!("Fit") }
        </button>
    }
}

fn view_box(frame: &Frame) -> String {
    let (x, y) = (frame.x, frame.y);
    format!("{x:.2} {y:.2} {:.2} {:.2}", frame.width, frame.height)
}

/// The middle of a cell on the map, in units.
fn units(cells: f64) -> f64 {
    (cells + 0.5) * CELL
}
