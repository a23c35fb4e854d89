//! The reasons of an answer, drawn over the map.

use giveway_page::board::{Place, Reasons, Spot};
use yew::prelude::*;

use super::square;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct ReasonsProps {
    pub(super) reasons: Reasons,
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
        html! {
            <g class={classes!("num", spot.is_lit.then_some("lit"))} transform={format!("translate({x} {y})")}>
                <circle r="19" /><text y="7" text-anchor="middle">{ spot.number }</text>
            </g>
        }
    };
    html! {
        <g class="reasons-on" aria-hidden="true">
            { for props.reasons.places.iter().map(place) }
            { for props.reasons.spots.iter().map(spot) }
        </g>
    }
}
