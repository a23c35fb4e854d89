//! The plan table: time by agent, in the columns of the lanes.

use std::ops::Range;

use giveway_model::tr;
use giveway_page::Reserve;
use giveway_page::table::{self, Place, RowKind as Kind, level, place, spans};
use giveway_page::timeline::{Axis, Lane, ShownName};
use yew::prelude::*;

use crate::glyph;
use crate::same::Same;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct PlanTableProps {
    pub lanes: Same<Vec<Lane>>,
    /// The names of their robots.
    pub names: Same<Vec<ShownName>>,
    pub axis: Axis,
    /// The width of the column of names, in pixels.
    pub label: f64,
    /// The columns to draw.
    pub columns: Range<u32>,
    /// The lane whose rows stay above all others.
    pub pinned: Option<usize>,
    /// The rows to draw of those that scroll.
    pub rows: Range<usize>,
    /// The room above and below them, in pixels.
    pub beyond: (f64, f64),
    /// The time shown.
    pub time: u32,
}

/// The table `Plan`.
#[component]
pub(super) fn PlanTable(props: &PlanTableProps) -> Html {
    let PlanTableProps {
        lanes,
        names,
        axis,
        label,
        columns,
        pinned,
        rows,
        beyond: (above, below),
        time,
    } = props;
    let all = use_memo((lanes.clone(), *pinned), |(lanes, pinned)| {
        table::rows(lanes, *pinned)
    });
    let [first, rest] = &*all;
    let times = axis.times;
    let drawn = columns.start.min(times)..columns.end.min(times);
    // Columns that are not drawn are wide cells on each side.
    let side = |columns: u32| -> Html {
        let wide = |span: u32| html! { <td class="side" colspan={span.to_string()}></td> };
        spans(columns).map(wide).collect()
    };
    let head = |at: u32| {
        let now = (at == *time).then_some("now");
        html! { <th key={at} class={classes!(now)} scope="col">{ at }</th> }
    };
    let row = |at: usize| {
        let above = first.get(at);
        let pin = above.map(|_| "pin");
        let (index, kind) = *above.or_else(|| rest.get(at - first.len()))?;
        let lane = lanes.get(index)?;
        let entries = drawn
            .clone()
            .map(|entry| cell(lane, kind, entry, entry == *time));
        let begins = (kind == Kind::Cells).then_some("first");
        Some(html! {
            <tr key={at} class={classes!(glyph::class(lane.agent), begins, pin, (kind == Kind::Levels).then_some("lv"))}
                aria-rowindex={(at + 2).to_string()}>
                if kind == Kind::Cells {
                    <th scope="row" class="lab"><span title={lane.name.clone()}>{ glyph::narrow_name(&lane.name, names.get(index)?) }{ " " }<small>{ tr!("cell") }</small></span></th>
                } else {
                    <th scope="row" class="lab"><span><span class="vh">{ lane.name.clone() }{ " " }</span><small>{ tr!("level") }</small></span></th>
                }
                { side(drawn.start) }
                { for entries }
                { side(times - drawn.end) }
            </tr>
        })
    };
    let spacer = |height: f64| {
        let wide =
            |span: u32| html! { <td colspan={span.to_string()} height={height.to_string()}></td> };
        (height > 0.0).then(|| {
            html! {
                <tr class="side" aria-hidden="true">{ for spans(times + 1).map(wide) }</tr>
            }
        })
    };
    html! {
        <table aria-label={tr!("Plan")} class="tbl" aria-rowcount={(first.len() + rest.len() + 1).to_string()} aria-colcount={(times + 1).to_string()}
            width={(label + axis.width()).to_string()}>
            <colgroup>
                <col class="c0" />
                { for spans(times).map(|span| html! { <col span={span.to_string()} width={axis.column.to_string()} /> }) }
            </colgroup>
            <thead>
                <tr aria-rowindex="1">
                    <th scope="col" class="lab">{ tr!("Time") }</th>
                    { side(drawn.start) }
                    { for drawn.clone().map(head) }
                    { side(times - drawn.end) }
                </tr>
            </thead>
            <tbody>
                { for (0..first.len()).filter_map(row) }
                { spacer(*above) }
                { for rows.clone().filter_map(|at| row(at + first.len())) }
                { spacer(*below) }
            </tbody>
        </table>
    }
}

fn cell(lane: &Lane, kind: Kind, time: u32, is_now: bool) -> Html {
    let now = is_now.then_some("now");
    match kind {
        Kind::Cells => {
            let place = place(lane, time);
            let half = (place == Place::Half).then_some("half");
            html! { <td key={time} class={classes!(now, half)}>{ place.text() }</td> }
        }
        Kind::Levels => {
            let Some(entry) = level(lane, time) else {
                return html! { <td key={time} class={classes!(now)}></td> };
            };
            let charges = entry.charges.then_some("chg");
            let low = (entry.reserve == Reserve::Critical && !entry.charges).then_some("low");
            html! {
                <td key={time} class={classes!(now, charges, low)}>
                    { entry.level }
                    if entry.charges {
                        <span aria-hidden="true">{ "\u{2191}" }</span><span class="vh">{ tr!(", charges") }</span>
                    }
                </td>
            }
        }
    }
}
