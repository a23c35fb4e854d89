//! The board: the map as one SVG with all that stands and moves on it.
//!
//! What stands still is rendered when it changes; what moves sets its own
//! attributes by hand, frame by frame, from the page's clock. Beneath it are
//! the legend and the buttons of the view.

mod agents;
mod axis;
mod cells;
mod floor;
mod gestures;
mod ghost;
mod keys;
mod legend;
mod marks;
mod motion;
mod reasons;
mod viewport;
mod ways;

use std::rc::Rc;

use giveway_model::{Cell, sorting};
use giveway_page::board::{CELL, Cast, Detail, Frame, Kind, Window, legend};
use giveway_page::{Action, Selection, Tool};
use yew::prelude::*;

use crate::Shown;
use agents::Agents;
use axis::Axis;
use cells::Cells;
use floor::FloorShapes;
use legend::Under;
use marks::Marks;
use reasons::ReasonMarks;
use viewport::use_viewport;
use ways::Ways;

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
    let cast = use_cast(state);
    let board = (state.draft.grid().width(), state.draft.grid().height());
    let viewport = use_viewport(&area, board);
    let frame = viewport.frame(board);
    let detail = frame.detail();

    keys::use_view_keys(&viewport.look);
    let gestures = gestures::use_gestures(gestures::Surface {
        svg: svg.clone(),
        hover: hover.clone(),
        state: state.clone(),
        send: props.send.clone(),
        cast: Rc::clone(&cast),
        look: viewport.look.clone(),
        frame,
        is_fit: viewport.camera.is_fit(),
    });
    let (_, rows) = frame.cells(board);
    let page = rows.1 - rows.0;
    let onkeydown = keys::use_cursor_keys(state.cursor, &props.send, &viewport.look, page);

    let reasons = giveway_page::board::reasons(state);
    let kinds: Vec<Kind> = legend(state, &cast);
    let selected_agent = state.selected_agent();
    let is_stale = state.is_stale() && cast.has_plan();
    let class = classes!(
        "map",
        detail.class(),
        is_stale.then_some("stale"),
        (state.playback.time > 0).then_some("later"),
        (state.tool != Tool::Select).then_some("brush-on"),
        (!viewport.camera.is_fit()).then_some("near"),
    );
    let cursor = state.cursor;
    html! {
        <>
            <div class="bd" ref={area}>
                <svg {class} ref={svg}
                    role="grid" aria-label="Board" tabindex="0"
                    aria-rowcount={board.1.to_string()} aria-colcount={board.0.to_string()}
                    aria-activedescendant={cells::id(cursor)}
                    viewBox={view_box(&frame)}
                    onpointerdown={gestures.down} onpointermove={gestures.moved}
                    onpointerup={gestures.up} onpointercancel={gestures.cancel}
                    onpointerleave={gestures.leave} onwheel={gestures.wheel}
                    {onkeydown}>
                    <FloorShapes draft={Rc::clone(state.world())} is_fine={detail > Detail::Dots} />
                    if state.view.trails {
                        <Ways cast={Rc::clone(&cast)} selected={selected_agent} />
                    }
                    <Agents cast={Rc::clone(&cast)} {detail} selected={selected_agent} />
                    <Marks cast={Rc::clone(&cast)} {detail} />
                    if detail == Detail::All {
                        <Axis {frame} {board} />
                    }
                    <ReasonMarks {reasons} />
                    { problems(state) }
                    { ghost::show(state) }
                    <g aria-hidden="true">
                        if let Selection::Cell(cell) = state.selection {
                            { square("selcell", cell, 3) }
                        }
                        <rect class="hover" ref={hover} width="94" height="94" rx="15" visibility="hidden" />
                    </g>
                    <Cells
                        draft={Rc::clone(state.world())}
                        cast={Rc::clone(&cast)}
                        time={state.playback.time}
                        window={Window::around(cursor, &frame, board)}
                        selection={state.selection} />
                    <g aria-hidden="true">{ square("cursor", cursor, 2) }</g>
                </svg>
            </div>
            <Under {kinds} look={viewport.look.clone()}
                is_fit={viewport.camera.is_fit()}
                is_nearest={viewport.is_nearest(board)} />
        </>
    }
}

/// A frame and a triangle on every cell where something is wrong.
fn problems(state: &Shown) -> Html {
    let cells = state
        .draft
        .problems()
        .iter()
        .filter_map(|problem| problem.cell);
    let cells = sorting::set(cells);
    let mark = |cell: Cell| {
        html! {
            <>
                { square("fault", cell, 3) }
                <path class="fault-sign" transform={format!("translate({} {})", 100 * cell.x, 100 * cell.y)}
                    d="M20 7 33 29H7ZM20 14v7M20 25v.1" />
            </>
        }
    };
    html! { <g aria-hidden="true">{ for cells.into_iter().map(mark) }</g> }
}

/// A frame around a cell, some units inside of it.
fn square(class: &'static str, cell: Cell, inset: u32) -> Html {
    let side = 100 - 2 * inset;
    html! {
        <rect {class} x={(100 * cell.x + inset).to_string()} y={(100 * cell.y + inset).to_string()}
            width={side.to_string()} height={side.to_string()} rx="15" />
    }
}

fn view_box(frame: &Frame) -> String {
    let Frame {
        x,
        y,
        width,
        height,
        ..
    } = frame;
    format!("{x:.2} {y:.2} {width:.2} {height:.2}")
}

/// The middle of a cell on the map, in units.
fn units(cells: f64) -> f64 {
    (cells + 0.5) * CELL
}

/// The cast of the state; the same one as long as it fits.
#[hook]
fn use_cast(state: &Shown) -> Rc<Cast> {
    let kept = use_mut_ref(|| None::<Rc<Cast>>);
    let mut kept = kept.borrow_mut();
    match &*kept {
        Some(cast) if cast.is_of(state) => Rc::clone(cast),
        _ => Rc::clone(kept.insert(Rc::new(Cast::of(state)))),
    }
}
