//! The order at a cell over the lanes: when each robot is in it, and links from lane to lane.

use giveway_page::State;
use giveway_page::order::{LaneLink, LaneOrder, Stay, lane_order};
use giveway_page::timeline::{Axis, Row};
use yew::prelude::*;

use crate::glyph;
use crate::part::part;

/// Lanes lower than this, in pixels, have no room for words between them.
const WORDS_FROM: f64 = 30.0;
/// The height of the words' frame, and the width of a letter, in pixels.
const FRAME: f64 = 16.0;
const LETTER: f64 = 6.2;

#[derive(Clone, PartialEq, Properties)]
struct LinksProps {
    drawn: LaneOrder,
    axis: Axis,
    row: Row,
    /// How many lanes there are.
    lanes: usize,
}

/// What is drawn over the lanes; nothing where the order is not shown.
pub(super) fn show(state: &State, axis: Axis, row: Row, lanes: usize) -> Html {
    match lane_order(state) {
        Some(drawn) => html! { { part::<Links>(LinksProps { drawn, axis, row, lanes }) } },
        None => Html::default(),
    }
}

#[component]
fn Links(props: &LinksProps) -> Html {
    let LinksProps {
        drawn,
        axis,
        row,
        lanes,
    } = props;
    let top = |lane: usize| lane as f64 * row.height + row.bar - 2.0;
    let bottom = |lane: usize| top(lane) + row.thick + 4.0;
    let stay = |stay: &Stay| {
        let x = axis.x(f64::from(stay.from)) + 1.0;
        let end = stay
            .to
            .map_or(axis.width(), |to| axis.x(f64::from(to)) - 1.0);
        html! {
            <rect class={classes!("in-cell", stay.agent.map(glyph::class))} x={x.to_string()} y={top(stay.lane).to_string()}
                width={(end - x).max(2.0).to_string()} height={(row.thick + 4.0).to_string()} rx="3" />
        }
    };
    let link = |link: &LaneLink| {
        let (x, to) = (axis.x(f64::from(link.from.1)), axis.x(f64::from(link.to.1)));
        // A robot that comes again has one lane: the link to it may run upwards.
        let (y, end) = if link.from.0 <= link.to.0 {
            (bottom(link.from.0), top(link.to.0))
        } else {
            (top(link.from.0), bottom(link.to.0))
        };
        let middle = f64::midpoint(y, end);
        let width = link.text.chars().count() as f64 * LETTER + 14.0;
        let left = (to + 10.0).min(axis.width() - width).max(0.0);
        let class = classes!("link", link.is_tight.then_some("tight"));
        html! {
            <g {class}>
                <path d={format!("M{x} {y}C{x} {middle} {to} {middle} {to} {end}")} />
                if row.height >= WORDS_FROM {
                    <rect x={left.to_string()} y={(middle - FRAME / 2.0).to_string()} width={width.to_string()} height={FRAME.to_string()} rx="8" />
                    <text x={(left + width / 2.0).to_string()} y={(middle + 4.0).to_string()} text-anchor="middle">{ link.text.clone() }</text>
                }
            </g>
        }
    };
    let planned = |&(lane, time): &(usize, u32)| {
        let x = axis.x(f64::from(time));
        html! { <path class="planned" d={format!("M{x} {}V{}", top(lane) - 2.0, bottom(lane) + 2.0)} /> }
    };
    html! {
        <svg class="lane-order" width={axis.width().to_string()} height={(*lanes as f64 * row.height).to_string()} role="img" aria-label={drawn.aloud.clone()}>
            { for drawn.stays.iter().map(stay) }
            { for drawn.links.iter().map(link) }
            { for drawn.planned.iter().map(planned) }
        </svg>
    }
}
