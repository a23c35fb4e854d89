//! The ruler: the slider of the time shown.

use std::ops::Range;

use giveway_model::tr;
use giveway_page::timeline::Axis;
use giveway_page::{Action, PlayAction};
use web_sys::Element;
use yew::prelude::*;

use crate::held::use_held;
use crate::part::part;

/// Half the width of the thumb and a little more, in pixels.
const THUMB: f64 = 17.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct RulerProps {
    pub axis: Axis,
    /// The columns to draw.
    pub columns: Range<u32>,
    /// The time shown.
    pub time: u32,
    /// The thumb, for the clock to move.
    pub thumb: NodeRef,
    pub send: Callback<Action>,
}

/// The slider `Time`.
#[component]
pub(super) fn Ruler(props: &RulerProps) -> Html {
    let RulerProps {
        axis,
        columns,
        time,
        thumb,
        send,
    } = props;
    let track = use_node_ref();
    let dragging = use_held(|| false);
    let last = axis.times - 1;
    let seek = {
        let (track, send, axis) = (track.clone(), send.clone(), *axis);
        move |event: &PointerEvent| {
            if let Some(track) = track.cast::<Element>() {
                let left = track.get_bounding_client_rect().left();
                let x = f64::from(event.client_x()) - left;
                send.emit(Action::Play(PlayAction::Seek(axis.time_at(x))));
            }
        }
    };
    let onpointerdown = {
        let (track, dragging, seek) = (track.clone(), dragging.clone(), seek.clone());
        move |event: PointerEvent| {
            if event.button() != 0 {
                return;
            }
            if let Some(track) = track.cast::<Element>() {
                let _ = track.set_pointer_capture(event.pointer_id());
            }
            dragging.set(true);
            seek(&event);
        }
    };
    let onpointermove = {
        let dragging = dragging.clone();
        move |event: PointerEvent| {
            if dragging.get() {
                seek(&event);
            }
        }
    };
    let release = move |_: PointerEvent| dragging.set(false);
    let onkeydown = {
        let (send, time) = (send.clone(), *time);
        move |event: KeyboardEvent| {
            if event.ctrl_key() || event.meta_key() || event.alt_key() {
                return;
            }
            let page = (last / 10).max(5);
            let action = match event.key().as_str() {
                "ArrowRight" | "ArrowUp" => Action::Play(PlayAction::StepForward),
                "ArrowLeft" | "ArrowDown" => Action::Play(PlayAction::StepBack),
                "PageUp" => Action::Play(PlayAction::Seek(time.saturating_add(page).min(last))),
                "PageDown" => Action::Play(PlayAction::Seek(time.saturating_sub(page))),
                "Home" => Action::Play(PlayAction::Seek(0)),
                "End" => Action::Play(PlayAction::Seek(last)),
                _ => return,
            };
            event.prevent_default();
            event.stop_propagation();
            send.emit(action);
        }
    };
    html! {
        <div class="row ruler">
            <span class="lab">{ tr!("Time") }</span>
            <div class="track" role="slider" tabindex="0" aria-label={tr!("Time")} ref={track}
                aria-valuemin="0" aria-valuemax={last.to_string()} aria-valuenow={time.to_string()}
                aria-valuetext={tr!("{time} of {last}", time, last)}
                {onpointerdown} {onpointermove} onpointerup={release.clone()} onpointercancel={release}
                {onkeydown}>
                { part::<Labels>(LabelsProps { axis: *axis, columns: columns.clone(), time: *time }) }
                <i class="thumb" ref={thumb}><b>{ time }</b></i>
            </div>
        </div>
    }
}

#[derive(Clone, PartialEq, Properties)]
struct LabelsProps {
    axis: Axis,
    columns: Range<u32>,
    time: u32,
}

/// The times that have room for their names.
#[component]
fn Labels(props: &LabelsProps) -> Html {
    let LabelsProps {
        axis,
        columns,
        time: now,
    } = props;
    let times = axis.labels().into_iter();
    let drawn = times.filter(|time| columns.contains(time));
    let label = |time: u32| {
        let apart = f64::from(time.abs_diff(*now)) * axis.column;
        let digits = time.to_string().len() as f64;
        // The thumb says the time shown itself.
        let cut = apart < THUMB + digits * 3.5;
        html! {
            <text key={time} class={classes!(cut.then_some("cut"))} x={axis.x(f64::from(time)).to_string()}
                y="16" text-anchor="middle">{ time }</text>
        }
    };
    html! {
        <svg width={axis.width().to_string()} height="24" aria-hidden="true">{ for drawn.map(label) }</svg>
    }
}
