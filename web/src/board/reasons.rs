//! The reasons of an answer, drawn over the map; what is against the rules of a
//! plan of one's own.

use giveway_model::{Cell, tr};
use giveway_page::board::{
    ConflictPlace, Instead, Later, Place, Reasons, Spot, SpotSign, Star, Try,
};
use yew::prelude::*;

use super::layers::square;
use giveway_page::board::CELL;

/// A star with twelve points, and an exclamation mark.
pub(crate) const STAR: &str = "M0-30 6.5-20 17.6-24.3 17-12.3 28.5-9.3 21 0 28.5 9.3 17 12.3 17.6 24.3 6.5 20 0 30-6.5 20-17.6 24.3-17 12.3-28.5 9.3-21 0-28.5-9.3-17-12.3-17.6-24.3-6.5-20Z";

#[derive(Clone, PartialEq, Properties)]
pub(super) struct ReasonsProps {
    pub(super) reasons: Reasons,
    /// The size of a cell on the screen.
    pub(super) cell_px: f64,
}

/// The star of a broken rule.
pub(super) fn burst(place: ConflictPlace, cell_px: f64) -> Html {
    let Star { at: (x, y), radius } = place.star(cell_px);
    let scale = radius / 30.0;
    html! {
        <g class="burst" transform={format!("translate({x:.1} {y:.1}) scale({scale:.2})")}>
            <path d={STAR} /><path class="ex" d="M0-11V3M0 11v.1" />
        </g>
    }
}

/// Numbers where something would go wrong, frames around what excludes it.
#[component]
pub(super) fn ReasonMarks(props: &ReasonsProps) -> Html {
    let place = |place: &Place| {
        let class = if place.is_lit { "core lit" } else { "core" };
        square(class, place.cell, 5)
    };
    let spot = |spot: &Spot| {
        let (x, y) = spot.at;
        let sign = match spot.sign {
            SpotSign::Broken => None,
            SpotSign::Reason => Some("needed"),
            SpotSign::Helps => Some("helps"),
        };
        // Numbers stay as large on the screen, however small the cells are.
        let scale = (22.0 * CELL / (props.cell_px.max(1.0) * 38.0)).max(1.0);
        let scale = if sign.is_some() { scale } else { 1.0 };
        html! {
            <g class={classes!("num", sign, spot.is_lit.then_some("lit"))} transform={format!("translate({x} {y}) scale({scale:.2})")}>
                <circle r="19" /><text y="7" text-anchor="middle">{ spot.number }</text>
            </g>
        }
    };
    let later = |later: &Later| {
        let (x, y) = later.at;
        // The time stands on the upper edge of its cell, on the lower one where the
        // map ends above it; or in the middle of its edge.
        let up = match (later.is_cell, y < 100.0) {
            (true, false) => -49.0,
            (true, true) => 49.0,
            (false, _) => 0.0,
        };
        html! {
            <g class="later-at" transform={format!("translate({x} {y})")}>
                if later.is_cell { <rect x="-43" y="-43" width="86" height="86" rx="14" /> }
                <g transform={format!("translate(0 {up})")}>
                    <rect class="pill" x="-42" y="-15" width="84" height="30" rx="15" />
                    <text y="6">{ tr!("time {time}", time = later.time) }</text>
                </g>
            </g>
        }
    };
    let instead = |at: &Instead| {
        let class = if at.is_first {
            "instead first"
        } else {
            "instead"
        };
        square(class, at.cell, 16)
    };
    let end = |end: &Try| {
        let (x, y) = end.at;
        html! {
            <g class="burst" transform={format!("translate({x} {y})")}>
                <path d={STAR} /><path class="ex" d="M0-11V3M0 11v.1" />
                <text class="at-time" y="46" text-anchor="middle">{ tr!("time {time}", time = end.time) }</text>
            </g>
        }
    };
    html! {
        <g class="reasons-on" aria-hidden="true">
            { for props.reasons.tries.iter().map(end) }
            { for props.reasons.instead.iter().map(instead) }
            { for props.reasons.places.iter().map(place) }
            { for props.reasons.spots.iter().map(spot) }
            { for props.reasons.frames.iter().map(|&cell: &Cell| square("vcell", cell, 4)) }
            { for props.reasons.bursts.iter().map(|&place| burst(place, props.cell_px)) }
            { for props.reasons.later.iter().map(later) }
        </g>
    }
}
