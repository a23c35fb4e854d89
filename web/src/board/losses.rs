//! The heat map of lost steps, in the place of the robots and their ways.

use giveway_page::State;
use giveway_page::ledger::{self, Frame, Heat, Shade};
use yew::prelude::*;

use crate::part::part;

/// The radius of a number on the screen, in pixels, and the least in units.
const RADIUS: (f64, f64) = (11.0, 19.0);
/// The largest, in units: a number on a small map does not cover its neighbours.
const LARGEST: f64 = 90.0;

#[derive(Clone, PartialEq, Properties)]
struct LossesProps {
    heat: Heat,
    radius: f64,
}

/// The heat map, where it is shown.
pub(super) fn losses(state: &State, cell_px: f64) -> Html {
    let Some(heat) = ledger::heat(state) else {
        return Html::default();
    };
    let radius = (RADIUS.0 / cell_px * 100.0).clamp(RADIUS.1, LARGEST);
    html! { { part::<Losses>(LossesProps { heat, radius }) } }
}

#[component]
fn Losses(props: &LossesProps) -> Html {
    let LossesProps { heat, radius } = props;
    let shade = |shade: &Shade| {
        html! { <path d={shade.path.clone()} fill-opacity={format!("{:.2}", shade.opacity)} /> }
    };
    let frame = |frame: &Frame| {
        let (x, y, width, height) = frame.area;
        html! {
            <rect class={classes!("loss-frame", frame.is_lit.then_some("lit"))} x={(x - 4.0).to_string()} y={(y - 4.0).to_string()}
                width={(width + 8.0).to_string()} height={(height + 8.0).to_string()} rx="20" />
        }
    };
    let number = |frame: &Frame| {
        let (x, y) = frame.at;
        let scale = radius / 19.0;
        html! {
            <g class="loss-no" transform={format!("translate({x} {y}) scale({scale:.2})")}>
                <circle r="19" /><text y="7" text-anchor="middle">{ frame.number }</text>
            </g>
        }
    };
    html! {
        <g class="losses" aria-hidden="true">
            { for heat.shades.iter().map(shade) }
            { for heat.frames.iter().map(frame) }
            { for heat.frames.iter().map(number) }
        </g>
    }
}
