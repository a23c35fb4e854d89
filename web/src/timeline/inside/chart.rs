//! The chart of the proof: bound and best plan, with a playhead that is a slider.

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::inside::{Chart, InsideAction, Tick};
use giveway_page::{Action, PlayAction};
use wasm_bindgen::JsCast;
use web_sys::Element;
use yew::prelude::*;

use crate::held::use_held;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct ChartProps {
    pub(super) chart: Chart,
    /// How many steps there are in all.
    pub(super) count: usize,
    pub(super) send: Callback<Action>,
}

/// The chart, and the slider over it.
#[component]
pub(super) fn ChartSlider(props: &ChartProps) -> Html {
    let ChartProps { chart, count, send } = props;
    let dragging = use_held(|| false);
    let seek = {
        let (chart, send) = (chart.clone(), send.clone());
        move |event: &PointerEvent| {
            let Some(place) = event.current_target() else {
                return;
            };
            let Ok(place) = place.dyn_into::<Element>() else {
                return;
            };
            let x = f64::from(event.client_x()) - place.get_bounding_client_rect().left();
            send.emit(Action::Inside(InsideAction::Step(chart.step_at(x))));
        }
    };
    let onpointerdown = {
        let (dragging, seek) = (Rc::clone(&dragging), seek.clone());
        move |event: PointerEvent| {
            if event.button() != 0 {
                return;
            }
            if let Some(Ok(place)) = event.current_target().map(JsCast::dyn_into::<Element>) {
                let _ = place.set_pointer_capture(event.pointer_id());
            }
            dragging.set(true);
            seek(&event);
        }
    };
    let onpointermove = {
        let dragging = Rc::clone(&dragging);
        move |event: PointerEvent| {
            if dragging.get() {
                seek(&event);
            }
        }
    };
    let release = move |_: PointerEvent| dragging.set(false);
    let onkeydown = {
        let (send, at, last) = (send.clone(), chart.head.1, count.saturating_sub(1));
        move |event: KeyboardEvent| {
            if event.ctrl_key() || event.meta_key() || event.alt_key() {
                return;
            }
            let page = (last / 10).max(5);
            let action = match event.key().as_str() {
                "ArrowRight" | "ArrowUp" => Action::Play(PlayAction::StepForward),
                "ArrowLeft" | "ArrowDown" => Action::Play(PlayAction::StepBack),
                "PageUp" => Action::Inside(InsideAction::Step((at + page).min(last))),
                "PageDown" => Action::Inside(InsideAction::Step(at.saturating_sub(page))),
                "Home" => Action::Inside(InsideAction::First),
                "End" => Action::Inside(InsideAction::Last),
                _ => return,
            };
            event.prevent_default();
            event.stop_propagation();
            send.emit(action);
        }
    };
    html! {
        <>
            { picture(chart) }
            <div class="chart-slide" role="slider" tabindex="0" aria-label={tr!("Step")} aria-valuemin="0" aria-valuemax={(count - 1).to_string()}
                aria-valuenow={chart.head.1.to_string()} aria-valuetext={tr!("{step} of {last}", step = chart.head.1, last = count - 1)}
                {onpointerdown} {onpointermove} onpointerup={release.clone()} onpointercancel={release} {onkeydown}></div>
        </>
    }
}

fn picture(chart: &Chart) -> Html {
    let Chart {
        head: (x, number),
        across_from: (left, right),
        ..
    } = *chart;
    let across = |tick: &Tick| {
        let y = tick.at.to_string();
        html! {
            <>
                <line class="gl" x1={left.to_string()} x2={right.to_string()} y1={y.clone()} y2={y} />
                <text x={(left - 8.0).to_string()} y={(tick.at + 4.0).to_string()} text-anchor="end">{ tick.value }</text>
            </>
        }
    };
    let below = |tick: &Tick| html! { <text class="bx" x={tick.at.to_string()} y="100%" dy="-7" text-anchor="middle">{ tick.value }</text> };
    let dot = |index: usize| {
        let dot = chart.dots[index].as_ref();
        dot.map(|dot| {
            let (class, name, by) = if index == 0 { ("dp up", "tu", 17.0) } else { ("dp", "td", -8.0) };
            let is_left = x + 50.0 > right;
            let (at, anchor) = if is_left { (x - 10.0, "end") } else { (x + 10.0, "start") };
            html! {
                <>
                    <circle class={class} cx={x.to_string()} cy={dot.y.to_string()} r="5" />
                    <text class={name} x={at.to_string()} y={(dot.y + by).to_string()} text-anchor={anchor}>{ dot.value }</text>
                </>
            }
        })
    };
    // Where the playhead's own figures stand, the name of the line makes way.
    let label = |class: &'static str, y: Option<f64>, words: &'static str| {
        let y = y.filter(|_| x > left + 130.0)?;
        Some(
            html! { <text {class} x={(left + 8.0).to_string()} y={y.to_string()}>{ words }</text> },
        )
    };
    html! {
        <svg class="chart" role="img" aria-label={chart.name.clone()} width="100%" height="100%">
            <defs><pattern id="chart-gap" width="9" height="9" patternUnits="userSpaceOnUse" patternTransform="rotate(25)"><path d="M4 0V9" /></pattern></defs>
            { for chart.across.iter().map(across) }
            <path class="gaph" d={chart.gap.clone()} />
            <path class="dn" d={chart.best.clone()} />
            <path class="up" d={chart.bound.clone()} />
            { label("td", chart.names[1], tr!("Best plan so far")) }
            { label("tu", chart.names[0], tr!("Proved: at least")) }
            <text class="tt" x={right.to_string()} y="12" text-anchor="end">{ chart.title.clone() }</text>
            <line class="ph" x1={x.to_string()} x2={x.to_string()} y1="22" y2="100%" />
            { dot(1) }{ dot(0) }
            { for chart.below.iter().map(below) }
            if let Some((x, y)) = chart.seal {
                <g class="meet" transform={format!("translate({x} {y})")}><circle r="10" /><path d="m-4 0 3 3 5-6" /></g>
            }
            <svg class="thumb-at" x={x.to_string()} y="100%" overflow="visible">
                <rect class="pt" x="-16" y="-24" width="32" height="22" rx="11" /><text class="ptt" y="-9" text-anchor="middle">{ number }</text>
            </svg>
        </svg>
    }
}
