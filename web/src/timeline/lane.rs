//! A lane: an agent's label and its bars.

use std::ops::Range;

use giveway_model::tr;
use giveway_page::freedom::LaneMarks;
use giveway_page::inside::{Note, Stop};
use giveway_page::timeline::{Axis, Lane, Row, ShownName};
use wasm_bindgen::JsCast;
use yew::prelude::*;

use super::bars::Bars;
use crate::board::STAR;
use crate::glyph;
use crate::same::Same;

/// What a lane tells of its robot at a time, behind the name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum LaneLabel {
    /// Nothing.
    Plain,
    /// The battery's level.
    Level(u32),
    /// It has broken down for good.
    BrokenDown,
}

impl LaneLabel {
    /// Of a lane at a time.
    pub(super) fn of(lane: Option<&Lane>, time: u32) -> Self {
        let Some(lane) = lane else {
            return Self::Plain;
        };
        if lane.stopped.is_some_and(|(from, _)| from <= time) {
            return Self::BrokenDown;
        }
        lane.level_at(time).map_or(Self::Plain, Self::Level)
    }
}

#[derive(Clone, PartialEq, Properties)]
pub(super) struct LaneRowProps {
    pub lanes: Same<Vec<Lane>>,
    /// The lanes of the plan beside this one; empty without one.
    pub others: Same<Vec<Lane>>,
    /// Which of the lanes.
    pub index: usize,
    /// The robot's name beside it.
    pub name: ShownName,
    pub axis: Axis,
    pub row: Row,
    /// The columns to draw.
    pub columns: Range<u32>,
    /// What is told of it at the time shown.
    pub label: LaneLabel,
    /// What becomes of the agent, while ways to go on are compared; how late it may be,
    /// where what must be so is laid over the plan.
    pub fate: Option<String>,
    /// What is said of the agent in its order.
    pub note: Option<Note>,
    /// What of it is in every best plan, where that is laid over the plan.
    pub marks: Option<LaneMarks>,
    pub selected: bool,
    /// Whether it stays below the ruler.
    pub is_pinned: bool,
    /// Whether the tab key comes to it.
    pub tab_stop: bool,
    /// When the agent is in the zone that is lit.
    pub in_zone: Vec<(u32, u32)>,
    /// The times at which something is against the rules.
    pub bursts: Vec<f64>,
    /// Takes the index of the lane that was picked, and the time of the wait or the charge that was pressed.
    pub pick: Callback<(usize, Option<u32>)>,
}

/// Half the width of the sign of a charge in which a press is for it, in pixels.
const CHARGE: f64 = 10.0;

/// The time of the charge or the wait that was pressed; `None` where none was.
fn pressed_time(event: &MouseEvent, lanes: &[Lane], index: usize, axis: Axis) -> Option<u32> {
    let row: web_sys::Element = event.current_target()?.dyn_into().ok()?;
    let bars = row.query_selector(".bars").ok()??;
    let left = bars.get_bounding_client_rect().left();
    let x = f64::from(event.client_x()) - left;
    let lane = lanes.get(index)?;
    // A press of the keyboard has no place, and one on the name is left of it.
    if x <= axis.x(0.0) - CHARGE {
        return None;
    }
    let far = |time: u32| (axis.x(f64::from(time)) - x).abs();
    let charges = lane.charges.iter().copied();
    let near = charges.filter(|&time| far(time) <= CHARGE);
    if let Some(charge) = near.min_by(|&a, &b| far(a).total_cmp(&far(b))) {
        return Some(charge);
    }
    let mut waits = lane.steps.iter().filter(|step| step.way.stays());
    let wait = waits.find(|step| {
        let (begins, ends) = (f64::from(step.begins), f64::from(step.ends));
        x > axis.x(0.0) && x >= axis.x(begins) && x < axis.x(ends)
    })?;
    Some(wait.begins)
}

/// One lane.
#[component]
pub(super) fn LaneRow(props: &LaneRowProps) -> Html {
    let Some(lane) = props.lanes.get(props.index) else {
        return Html::default();
    };
    let index = props.index;
    let is_two = !props.others.is_empty();
    let level = match props.label {
        LaneLabel::Level(level) => Some(level),
        LaneLabel::BrokenDown | LaneLabel::Plain => None,
    };
    let level = level.zip(lane.capacity).filter(|_| !is_two);
    let other = props.others.iter().position(|o| o.agent == lane.agent);
    let bars = |of: &'static str,
                lanes: [&Same<Vec<Lane>>; 2],
                indices: [usize; 2],
                marks: Option<LaneMarks>| {
        html! {
            <div class="half">
                <Bars {of} {marks} lanes={lanes[0].clone()} index={indices[0]} versus={Some((lanes[1].clone(), indices[1]))}
                    axis={props.axis} row={props.row} columns={props.columns.clone()} />
            </div>
        }
    };
    let onclick = {
        let (lanes, axis) = (props.lanes.clone(), props.axis);
        let pick = props.pick.clone();
        move |event: MouseEvent| pick.emit((index, pressed_time(&event, &lanes, index, axis)))
    };
    let note = props.note.as_ref();
    let told = note.map(|note| format!("{}, {}", note.place, note.around));
    let title = match props.fate.as_ref().or(told.as_ref()) {
        Some(fate) => format!("{}, {fate}", lane.name),
        None => lane.name.clone(),
    };
    html! {
        <div class={classes!("row", "lane", glyph::class(lane.agent), note.is_some_and(|note| !note.is_planned).then_some("later"), props.selected.then_some("sel"), props.is_pinned.then_some("pinned"))}
            onclick={onclick}>
            <button type="button" class="lab" aria-pressed={props.selected.to_string()}
                tabindex={if props.tab_stop { "0" } else { "-1" }} data-lane={index.to_string()} title={title}>
                if let Some(note) = note { <b class="no">{ note.place }</b> }
                { glyph::show(lane.agent, "lane-glyph") }
                <span class="lane-name">
                    <b>{ glyph::narrow_name(&lane.name, &props.name) }</b>
                    if let Some(note) = note {
                        <small>{ note.around.clone() }</small>
                    } else if let Some(fate) = &props.fate {
                        <small class="fate">{ fate.clone() }</small>
                    } else if props.label == LaneLabel::BrokenDown {
                        <small>{ tr!("behind a robot" => "broken down") }</small>
                    } else if let Some((level, capacity)) = level {
                        <small>{ tr!("{level} of {capacity}", level, capacity) }</small>
                    }
                    if is_two {
                        <small>{ tr!("this / other") }</small>
                    }
                </span>
            </button>
            if !props.in_zone.is_empty() { { in_zone(props) } }
            if !props.bursts.is_empty() { { bursts(props) } }
            if let Some(end) = note.and_then(|note| note.stop.as_ref()) { { stop(props, end) } }
            if let Some(other) = other {
                <div class="halves">
                    { bars(tr!("This plan"), [&props.lanes, &props.others], [index, other], props.marks.clone()) }
                    { bars(tr!("Other plan"), [&props.others, &props.lanes], [other, index], None) }
                </div>
            } else {
                <Bars of="" marks={props.marks.clone()} lanes={props.lanes.clone()} {index} versus={None::<(Same<Vec<Lane>>, usize)>}
                    axis={props.axis} row={props.row} columns={props.columns.clone()} />
            }
        </div>
    }
}

/// A line over the lane while the agent is in the zone that is lit.
fn in_zone(props: &LaneRowProps) -> Html {
    let column = props.axis.column;
    let one = |&(from, to): &(u32, u32)| {
        format!(
            "M{} 2H{}",
            f64::from(from) * column,
            f64::from(to + 1) * column
        )
    };
    let d: String = props.in_zone.iter().map(one).collect();
    html! {
        <svg class="bars in-zone" width={props.axis.width().to_string()} height="4" aria-hidden="true"><path {d} /></svg>
    }
}

/// A burst in a ring at each time at which something is against the rules.
fn bursts(props: &LaneRowProps) -> Html {
    let LaneRowProps { axis, row, .. } = props;
    let is_seen = |time: &&f64| {
        let columns = &props.columns;
        **time >= f64::from(columns.start) && **time <= f64::from(columns.end)
    };
    let one = |time: &f64| {
        let (x, y) = (axis.x(*time), row.middle());
        html! {
            <g key={time.to_string()} transform={format!("translate({x} {y})")}>
                <circle r="9" /><path transform="scale(0.19)" d={STAR} />
            </g>
        }
    };
    html! {
        <svg class="bars bad-at" width={axis.width().to_string()} height={row.height.to_string()} aria-hidden="true">
            { for props.bursts.iter().filter(is_seen).map(one) }
        </svg>
    }
}

/// Where the agent ends without having arrived.
fn stop(props: &LaneRowProps, end: &Stop) -> Html {
    let LaneRowProps { axis, row, .. } = props;
    let wide = |said: &str| said.chars().count() as f64 * 7.2 + 38.0;
    let x = axis.x(f64::from(end.time)) + 6.0;
    let fits = x + wide(&end.text) <= axis.width();
    let said = if fits { end.text.as_str() } else { end.short };
    let width = wide(said);
    let x = x.min(axis.width() - width).max(0.0);
    html! {
        <svg class="bars bad-at stop" width={axis.width().to_string()} height={row.height.to_string()}>
            <g transform={format!("translate({x} {})", row.middle() - 12.0)}>
                <rect width={width.to_string()} height="24" rx="12" />
                <path d="m11 8 8 8m0-8-8 8" /><text x="27" y="16">{ said.to_owned() }</text>
            </g>
        </svg>
    }
}
