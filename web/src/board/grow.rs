//! The size of the floor on its way: what comes and what goes, and a handle at each side that is
//! dragged or moved by keys.

use giveway_page::board::Frame;
use giveway_page::grow::{Card, GrowAction, Side, Strip, card};
use giveway_page::{Action, State};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, HtmlElement, KeyboardEvent, PointerEvent};
use yew::prelude::*;

use super::pill::pill;
use crate::Shown;

/// The size of the text of a pill, and half of the room for one, in pixels.
const TEXT_PX: f64 = 12.0;
const PILL_PX: (f64, f64) = (60.0, 14.0);
/// The side of the hatch of what goes, in pixels.
const HATCH_PX: f64 = 8.0;
/// How far a handle stays inside the board, in pixels.
const INSIDE_PX: f64 = 8.0;
/// How far a key goes with Shift.
const FAR: i32 = 5;

/// The hatch of what goes, once on the board.
pub(super) fn hatch_of_what_goes(frame: &Frame) -> Html {
    let side = frame.units(HATCH_PX).to_string();
    html! {
        <pattern id="goes" width={side.clone()} height={side.clone()} patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
            <path class="goes-l" stroke-width={frame.units(3.0).to_string()} d={format!("M0 0V{side}")} />
        </pattern>
    }
}

/// The strips that come and go, with how many rows or columns they are.
pub(super) fn marks(state: &State, frame: &Frame) -> Html {
    let strips = state.size_strips();
    if strips.is_empty() {
        return Html::default();
    }
    let size = frame.units(TEXT_PX);
    let strip = |Strip { told, more, area }: &Strip| {
        let [x0, y0, x1, y1] = area.map(|at| 100.0 * f64::from(at));
        // The pill stays in sight.
        let within = |at: f64, from: f64, length: f64, room: f64| {
            let room = frame.units(room).min(length / 2.0);
            at.clamp(from + room, from + length - room)
        };
        let x = within(f64::midpoint(x0, x1), frame.x, frame.width, PILL_PX.0);
        let y = within(f64::midpoint(y0, y1), frame.y, frame.height, PILL_PX.1);
        let shape = format!("M{x0} {y0}H{x1}V{y1}H{x0}Z");
        html! {
            <>
                if *more > 0 { <path fill="url(#cells)" d={shape.clone()} /> }
                <path class={if *more > 0 { "comes" } else { "goes" }} d={shape} />
                { pill(x, y, size, told) }
            </>
        }
    };
    html! { <g aria-hidden="true">{ hatch_of_what_goes(frame) }<pattern id="cells" width="100" height="100" patternUnits="userSpaceOnUse"><path class="goes-l" stroke-width={frame.units(2.0).to_string()} stroke-opacity="0.3" d="M0 0H100M0 0V100" /></pattern>{ for strips.iter().map(strip) }</g> }
}

#[derive(Clone, PartialEq, Properties)]
pub(super) struct HandlesProps {
    pub(super) state: Shown,
    pub(super) frame: Frame,
    pub(super) send: Callback<Action>,
}

/// A handle at each side of the floor.
#[component]
pub(super) fn Handles(props: &HandlesProps) -> Html {
    let HandlesProps { state, frame, send } = props;
    let place = use_node_ref();
    let outline = state.size_outline().unwrap_or_default();
    {
        let (place, frame) = (place.clone(), *frame);
        use_effect(move || {
            let children = place.cast::<Element>().map(|place| place.children());
            for (index, side) in (0..).zip(Side::ALL) {
                if let Some(handle) = children.as_ref().and_then(|all| all.item(index)) {
                    put(&handle.unchecked_into(), side, outline, &frame);
                }
            }
        });
    }
    let Some(card) = card(state) else {
        return Html::default();
    };
    let handle = |side: Side| handle(side, &card, state, *frame, send, &place);
    html! { <div class="sides" ref={place.clone()}>{ for Side::ALL.into_iter().map(handle) }</div> }
}

fn handle(
    side: Side,
    card: &Card,
    state: &Shown,
    frame: Frame,
    send: &Callback<Action>,
    place: &NodeRef,
) -> Html {
    let value = side.of(card.sides.unwrap_or_default());
    let (least, most) = state.side_limits(side);
    let grow = |action: GrowAction| send.reform(move |_: PointerEvent| Action::Grow(action));
    let down = {
        let hold = grow(GrowAction::Hold);
        move |event: PointerEvent| {
            if event.button() == 0 {
                // Without capture a drag ends beside the handle.
                if let Some(handle) = event.target_dyn_into::<Element>() {
                    let _ = handle.set_pointer_capture(event.pointer_id());
                }
                hold.emit(event);
            }
        }
    };
    let moved = {
        let (state, send, place) = (state.clone(), send.clone(), place.clone());
        move |event: PointerEvent| {
            let Some(board) = place.cast::<Element>().filter(|_| event.buttons() & 1 == 1) else {
                return;
            };
            let corner = board.get_bounding_client_rect();
            let at = frame.point((
                f64::from(event.client_x()) - corner.left(),
                f64::from(event.client_y()) - corner.top(),
            ));
            let more = state.side_dragged(side, at);
            if more != value {
                send.emit(Action::Grow(GrowAction::Drag(side, more)));
            }
        }
    };
    let key = {
        let send = send.clone();
        move |event: KeyboardEvent| {
            let far = if event.shift_key() { FAR } else { 1 };
            let Some(by) = goes_by(side, &event.key()).filter(|_| !has_modifier(&event)) else {
                return;
            };
            event.prevent_default();
            event.stop_propagation();
            // Keys may be faster than what is drawn: each goes on from what the one before made.
            send.emit(Action::Grow(GrowAction::Step(side, by * far)));
        }
    };
    let (name, told) = (format!("{side:?}").to_lowercase(), side.told(value));
    html! {
        <div class={classes!("side", name)} role="slider" tabindex="0" aria-label={side.name()} title={side.name()}
            aria-orientation={if side.is_across() { "horizontal" } else { "vertical" }}
            aria-valuemin={least.to_string()} aria-valuemax={most.to_string()} aria-valuenow={value.to_string()}
            aria-valuetext={format!("{told}: {}", card.after)}
            onpointerdown={down} onpointermove={moved} onpointerup={grow(GrowAction::Release)}
            onpointercancel={grow(GrowAction::Abandon)} onkeydown={key} />
    }
}

fn has_modifier(event: &KeyboardEvent) -> bool {
    event.ctrl_key() || event.alt_key() || event.meta_key()
}

/// How many more a key adds: an arrow along the side's own direction moves the side, one across
/// it is that of any slider.
fn goes_by(side: Side, key: &str) -> Option<i32> {
    let (right, up) = match side {
        Side::Left => (-1, 1),
        Side::Top | Side::Right => (1, 1),
        Side::Bottom => (1, -1),
    };
    match key {
        "ArrowRight" => Some(right),
        "ArrowLeft" => Some(-right),
        "ArrowUp" => Some(up),
        "ArrowDown" => Some(-up),
        _ => None,
    }
}

/// Puts a handle at the middle of its side, inside the board.
fn put(handle: &HtmlElement, side: Side, outline: [i32; 4], frame: &Frame) {
    let [x0, y0, x1, y1] = outline.map(|at| 100.0 * f64::from(at));
    let (x, y) = match side {
        Side::Left => (x0, f64::midpoint(y0, y1)),
        Side::Top => (f64::midpoint(x0, x1), y0),
        Side::Right => (x1, f64::midpoint(y0, y1)),
        Side::Bottom => (f64::midpoint(x0, x1), y1),
    };
    let px = |at: f64, from: f64, length: f64| {
        let at = (at - from) * frame.cell_px / 100.0;
        let length = length * frame.cell_px / 100.0;
        format!("{:.1}px", at.min(length - INSIDE_PX).max(INSIDE_PX))
    };
    let style = handle.style();
    // A browser that refuses has the handle in the corner.
    let _ = style.set_property("--left", &px(x, frame.x, frame.width));
    let _ = style.set_property("--top", &px(y, frame.y, frame.height));
}
