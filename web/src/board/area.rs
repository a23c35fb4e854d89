//! A selected part of the floor: its outline with handles, what comes and goes, and the bar of
//! what can be done with it.

use giveway_model::tr;
use giveway_page::area::{
    AreaAction, Direction, FARTHEST, Ghost, MOST_COPIES, Repeat, Shown as AreaShown, card, shown,
};
use giveway_page::board::Frame;
use giveway_page::grow::{GrowAction, LineOffer, offers_of_lines};
use giveway_page::{Action, State, number};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, Event, HtmlElement, HtmlInputElement, PointerEvent};
use yew::prelude::*;

use super::grow::hatch_of_what_goes;
use crate::{Shown, copy, icon};

/// The side of a handle, and of the place around it for a finger, in pixels.
const HANDLE_PX: f64 = 9.0;
const FINGER_PX: f64 = 44.0;
/// The size of the text of the pill, in pixels.
const PILL_PX: f64 = 12.0;
/// The sides and corners: right and down.
const SIDES: [(i8, i8); 8] = [
    (-1, -1),
    (0, -1),
    (1, -1),
    (1, 0),
    (1, 1),
    (0, 1),
    (-1, 1),
    (-1, 0),
];
/// How far the bar is from the area, in pixels.
const GAP_PX: f64 = 10.0;

/// The area on the map; nothing where none is selected.
pub(super) fn marks(state: &State, frame: &Frame) -> Html {
    let Some(area) = shown(state) else {
        return Html::default();
    };
    let ghost = |ghost: &Ghost| {
        let (dx, dy) = ghost.by;
        html! { <path class={classes!("area-ghost", ghost.class)} d={ghost.path.clone()} transform={format!("translate({} {})", 100 * dx, 100 * dy)} /> }
    };
    html! {
        <g class="area" aria-hidden="true">
            if !area.ghosts.is_empty() { { hatch_of_what_goes(frame) } }
            { for area.ghosts.iter().map(ghost) }
            <path class="area-frame" d={area.outline.clone()} />
            if area.has_handles { { handles(&area, frame) } }
            if let Some(pill) = &area.pill { { pill_at(&area, pill, frame) } }
        </g>
    }
}

fn handles(area: &AreaShown, frame: &Frame) -> Html {
    let [x0, y0, x1, y1] = area.frame.map(|side| 100.0 * f64::from(side));
    let place = |side: i8, first: f64, last: f64| match side {
        ..0 => first,
        0 => f64::midpoint(first, last + 100.0),
        1.. => last + 100.0,
    };
    let square = |class: &'static str, x: f64, y: f64, px: f64| {
        let side = frame.units(px);
        let (x, y) = (x - side / 2.0, y - side / 2.0);
        html! { <rect {class} x={x.to_string()} y={y.to_string()} width={side.to_string()} height={side.to_string()} rx={(side / 5.0).to_string()} /> }
    };
    let handle = |(index, &(right, down)): (usize, &(i8, i8))| {
        let (x, y) = (place(right, x0, x1), place(down, y0, y1));
        html! {
            <g class={format!("handle handle-{}", index % 4)} data-side={index.to_string()}>
                { square("finger", x, y, FINGER_PX) }
                { square("body", x, y, HANDLE_PX) }
            </g>
        }
    };
    // On a short side the corners take all the room.
    let has_middles = [x1 - x0, y1 - y0].map(|side| side + 100.0 > frame.units(4.0 * HANDLE_PX));
    let is_shown = |&(_, &(right, down)): &(usize, &(i8, i8))| {
        (right != 0 || has_middles[0]) && (down != 0 || has_middles[1])
    };
    SIDES
        .iter()
        .enumerate()
        .filter(is_shown)
        .map(handle)
        .collect()
}

fn pill_at(area: &AreaShown, pill: &str, frame: &Frame) -> Html {
    let [x0, _, x1, y1] = area.frame.map(|side| 100.0 * f64::from(side));
    let last = area.ghosts.last().map_or((0, 0), |ghost| ghost.by);
    let x = f64::midpoint(x0, x1 + 100.0) + 100.0 * f64::from(last.0);
    let y = y1 + 100.0 * f64::from(last.1) + 100.0 + frame.units(1.6 * PILL_PX);
    let size = frame.units(PILL_PX);
    html! {
        { super::pill::pill(x, y - size / 3.0, size, pill) }
    }
}

/// The side or corner that a pointer takes hold of.
pub(super) fn side(event: &PointerEvent) -> Option<AreaAction> {
    let target: Element = event.target()?.dyn_into().ok()?;
    let handle = target.closest("[data-side]").ok()??;
    let index: usize = handle.get_attribute("data-side")?.parse().ok()?;
    let &(right, down) = SIDES.get(index)?;
    Some(AreaAction::Stretch(right, down))
}

/// Copies what is on the area: for this page, and as drawn text for others.
pub(crate) fn copy_area(state: &State, send: &Callback<Action>) {
    let text = giveway_page::area::text(state);
    send.emit(Action::Area(AreaAction::Copy));
    if let Some(text) = text {
        // Where the browser keeps its clipboard closed, this page still has its own.
        copy::text(tr!("area"), &text, |_| {});
    }
}

#[derive(Clone, PartialEq, Properties)]
pub(super) struct BarProps {
    pub(super) state: Shown,
    pub(super) frame: Frame,
    pub(super) send: Callback<Action>,
}

/// What can be done with the area, beside it: above, else below it.
#[component]
pub(super) fn AreaBar(props: &BarProps) -> Html {
    let BarProps { state, frame, send } = props;
    let place = use_node_ref();
    let area = shown(state).map(|area| area.frame);
    {
        let (place, frame) = (place.clone(), *frame);
        use_effect(move || {
            if let Some((bar, area)) = place.cast::<HtmlElement>().zip(area) {
                put(&bar, area, &frame);
            }
        });
    }
    let Some(card) = card(state) else {
        return Html::default();
    };
    let press = |name: &'static str, icon: &'static str, key: &'static str, on: bool, action| {
        let onclick = send.reform(move |_: MouseEvent| Action::Area(action));
        html! {
            <button type="button" class="btn ghost round" aria-label={name} title={format!("{name} ({key})")}
                aria-pressed={on.then_some("true")} {onclick}>{ icon::show(icon) }</button>
        }
    };
    let copies = {
        let (state, send) = (state.clone(), send.clone());
        Callback::from(move |_: MouseEvent| copy_area(&state, &send))
    };
    let has_ghost = giveway_page::area::has_ghost(state);
    let is_repeated = card.repeat.is_some();
    html! {
        <div class="areabar making" role="toolbar" aria-label={card.name.clone()} ref={place}>
            <button type="button" class="btn ghost round" aria-label={tr!("Copy")} title={format!("{} (Ctrl C)", tr!("Copy"))} onclick={copies}>{ icon::show("copy") }</button>
            if card.can_paste {
                { press(tr!("Paste"), "paste", "Ctrl V", false, AreaAction::Paste) }
            }
            { press(tr!("Mirror left and right"), "mirror-x", "h", false, AreaAction::Mirror(true)) }
            { press(tr!("Mirror above and below"), "mirror-y", "Shift h", false, AreaAction::Mirror(false)) }
            { press(tr!("Turn right"), "turn90", "t", false, AreaAction::Turn) }
            { press(tr!("Repeat"), "repeat", "Ctrl D", is_repeated, AreaAction::Repeat(!is_repeated)) }
            { press(tr!("Erase"), "erase", "Delete", false, AreaAction::Erase) }
            { for offers_of_lines(state).iter().map(|offer| line(offer, send)) }
            if let Some(repeat) = card.repeat { { repeated(repeat, send) } }
            if has_ghost {
                <button type="button" class="btn primary round" aria-label={tr!("Do it")} title={format!("{} (Enter)", tr!("Do it"))}
                    onclick={send.reform(|_| Action::Area(AreaAction::Make))}>{ icon::show("check") }</button>
                { press(tr!("Cancel"), "cancel", "Esc", false, AreaAction::Drop) }
            }
            <output class="vh" role="status">{ card.told.clone().unwrap_or_else(|| card.name.clone()) }</output>
        </div>
    }
}

/// A column or row that comes or goes.
#[inline(never)]
fn line(offer: &LineOffer, send: &Callback<Action>) -> Html {
    let lines = offer.lines;
    let sign = if lines.more > 0 { "plus" } else { "minus" };
    html! {
        <button type="button" class="btn ghost line" onclick={send.reform(move |_: MouseEvent| Action::Grow(GrowAction::Lines(lines)))}>{ icon::show(sign) }{ offer.name.clone() }</button>
    }
}

/// "2 more, 3 cells down".
fn repeated(repeat: Repeat, send: &Callback<Action>) -> Html {
    let turn = {
        let at = Direction::ALL
            .iter()
            .position(|&to| to == repeat.to)
            .unwrap_or(0);
        let next = Direction::ALL[(at + 1) % Direction::ALL.len()];
        send.reform(move |_: MouseEvent| Action::Area(AreaAction::To(next)))
    };
    html! {
        <span class="rep">
            { field(tr!("Copies"), repeat.copies, MOST_COPIES, send, AreaAction::Copies) }
            { tr!("more copies" => "more,") }
            { field(tr!("From one copy to the next, cells"), repeat.step, FARTHEST, send, AreaAction::Step) }
            { tr!("cells") }
            <button type="button" class="btn outline" aria-label={tr!("Direction of the copies: {to}", to = repeat.to.word())} onclick={turn}>{ repeat.to.word() }</button>
        </span>
    }
}

/// A number; what is not possible is taken back.
fn field(
    name: &'static str,
    value: u32,
    most: u32,
    send: &Callback<Action>,
    action: fn(u32) -> AreaAction,
) -> Html {
    let send = send.clone();
    let onchange = Callback::from(move |event: Event| {
        let input: HtmlInputElement = event.target_unchecked_into();
        match number::read(&input.value(), (1, most)) {
            Some(number) => send.emit(Action::Area(action(number))),
            None => input.set_value(&value.to_string()),
        }
    });
    html! {
        <input class="num1" type="text" inputmode="numeric" autocomplete="off" aria-label={name}
            title={number::possible((1, most))} value={value.to_string()} {onchange} />
    }
}

/// Puts the bar beside an area and inside the board: above it, else below, else over it.
fn put(bar: &HtmlElement, [x0, y0, _, y1]: [u32; 4], frame: &Frame) {
    let px = |units: f64| units * frame.cell_px / 100.0;
    let (width, height) = (
        f64::from(bar.offset_width()),
        f64::from(bar.offset_height()),
    );
    let left = px(100.0 * f64::from(x0) - frame.x);
    let top = px(100.0 * f64::from(y0) - frame.y) - height - GAP_PX;
    let below = px(100.0 * f64::from(y1 + 1) - frame.y) + GAP_PX;
    let lowest = px(frame.height) - height;
    let top = match top < 0.0 {
        false => top,
        true if below <= lowest => below,
        true => GAP_PX,
    };
    let most = (px(frame.width) - width).max(0.0);
    let style = bar.style();
    // A browser that refuses has the bar in the corner.
    let _ = style.set_property("--left", &format!("{:.1}px", left.clamp(0.0, most)));
    let _ = style.set_property("--top", &format!("{:.1}px", top.min(lowest).max(0.0)));
}
