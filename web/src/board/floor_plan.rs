//! A picture of a floor under the grid, the cells that come of it, and the handles that move
//! it. The column has a field for each handle.

use giveway_model::Cell;
use giveway_page::Action;
use giveway_page::board::Frame;
use giveway_page::floor_plan::{End, FloorPlanAction, Laid, laid};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, PointerEvent};
use yew::prelude::*;

use super::layers::square;
use crate::Shown;

/// The radius of a handle, in pixels.
const HANDLE_PX: f64 = 7.0;

/// The picture.
pub(super) fn picture(state: &Shown) -> Html {
    let Some(laid) = laid(state) else {
        return Html::default();
    };
    let (width, height) = (laid.pixels.0.to_string(), laid.pixels.1.to_string());
    let class = classes!("floor-plan", laid.corners.is_none().then_some("faint"));
    html! {
        <image {class} aria-hidden="true" href={laid.address.clone()} {width} {height} preserveAspectRatio="none"
            transform={laid.transform.clone()} />
    }
}

/// Cells that come, and what is taken hold of.
pub(super) fn handles(state: &Shown, send: &Callback<Action>, frame: &Frame) -> Html {
    let cell_px = frame.cell_px;
    let Some((laid, corners)) = laid(state).and_then(|laid| laid.corners.map(|at| (laid, at)))
    else {
        return Html::default();
    };
    let Laid {
        cells: [made, close],
        points,
        apart,
        ..
    } = laid;
    let dotted = |class: &'static str| move |&cell: &Cell| square(class, cell, 3);
    let unit = 100.0 / cell_px;
    let [a, b] = points.map(|(x, y)| (100.0 * x, 100.0 * y));
    let middle = (f64::midpoint(a.0, b.0), f64::max(a.1, b.1) + 22.0 * unit);
    let point = |end: End| move |right: f64, down: f64| FloorPlanAction::Point(end, right, down);
    let wide = corners[1].0 - corners[0].0;
    html! {
        <g class="floor-plan" aria-hidden="true">
            { for made.iter().map(dotted("made")) }
            { for close.iter().map(dotted("close")) }
            <path class="measure" d={format!("M{:.1} {:.1}L{:.1} {:.1}", a.0, a.1, b.0, b.1)} />
            <text class="measure" x={format!("{:.1}", middle.0)} y={format!("{:.1}", middle.1)} font-size={format!("{:.1}", 12.0 * unit)}>{ apart }</text>
            { handle("points", points[0], frame, send, point(End::First)) }
            { handle("points", points[1], frame, send, point(End::Second)) }
            { handle("move", corners[0], frame, send, FloorPlanAction::Move) }
            { handle("stretch", corners[1], frame, send, move |right, _| FloorPlanAction::Wide(wide + right)) }
        </g>
    }
}

/// A circle that is dragged: what it does is told by how far it went, in cells. Where its place is
/// out of sight it stands at the edge of the board.
fn handle(
    class: &'static str,
    at: (f64, f64),
    frame: &Frame,
    send: &Callback<Action>,
    action: impl Fn(f64, f64) -> FloorPlanAction + 'static,
) -> Html {
    let cell_px = frame.cell_px;
    let inside = |at: f64, from: f64, length: f64| {
        let rim = frame.units(HANDLE_PX + 3.0).min(length / 2.0);
        (100.0 * at).clamp(from + rim, from + length - rim)
    };
    let x = inside(at.0, frame.x, frame.width);
    let y = inside(at.1, frame.y, frame.height);
    let down = Callback::from(|event: PointerEvent| {
        // The board does nothing of it.
        event.stop_propagation();
        if let Some(element) = event
            .target()
            .and_then(|target| target.dyn_into::<Element>().ok())
        {
            // Without capture a drag ends beside the handle.
            let _ = element.set_pointer_capture(event.pointer_id());
        }
    });
    let stop = Callback::from(|event: PointerEvent| event.stop_propagation());
    let send = send.clone();
    let moved = Callback::from(move |event: PointerEvent| {
        event.stop_propagation();
        let by = (f64::from(event.movement_x()), f64::from(event.movement_y()));
        if event.buttons() & 1 == 1 && by != (0.0, 0.0) {
            send.emit(Action::FloorPlan(action(by.0 / cell_px, by.1 / cell_px)));
        }
    });
    let radius = HANDLE_PX * 100.0 / cell_px;
    let circle = |class: &'static str, radius: f64| {
        html! { <circle {class} cx={format!("{x:.1}")} cy={format!("{y:.1}")} r={format!("{radius:.1}")} /> }
    };
    html! {
        <g class={classes!("handle", class)} onpointerdown={down} onpointermove={moved} onpointerup={stop.clone()} onpointercancel={stop}>
            { circle("grip", 3.0 * radius) }
            { circle("dot", radius) }
        </g>
    }
}
