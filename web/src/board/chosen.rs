//! The robot that is selected among small ones: its goal and waypoints, large enough to be read,
//! and its form where the others are dots.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::board::{Cast, Detail, Frame, waypoint_numbers};
use yew::prelude::*;

use super::marks::{FLAG, FLAG_CLOTH, FLAG_POLE, STAR};
use super::motion::{Attribute, children, use_motion};
use super::units;
use crate::glyph;

/// The least radius of a star, of a form and of the ring around it, in pixels.
const STAR_PX: f64 = 8.5;
const FORM_PX: f64 = 6.0;
const RING_PX: f64 = 9.0;
/// The radius of a star and of a form, in units.
const STAR_UNITS: f64 = 25.0;
const FORM_UNITS: f64 = 27.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct ChosenProps {
    pub(super) cast: Rc<Cast>,
    pub(super) agent: usize,
    pub(super) frame: Frame,
}

/// Its marks, below all robots.
#[component]
pub(super) fn ChosenMarks(props: &ChosenProps) -> Html {
    let ChosenProps { cast, agent, frame } = props;
    let layer = use_node_ref();
    let waypoints = use_memo((Rc::clone(cast), *agent), |(cast, agent)| {
        waypoint_numbers(cast, *agent)
    });
    {
        let (layer, waypoints) = (layer.clone(), Rc::clone(&waypoints));
        use_motion(move || {
            let stars = children(&layer).into_iter();
            let stars: Vec<_> = stars
                .map(|star| Attribute::new(star, "data-visited"))
                .collect();
            move |time| {
                for (star, (.., visited)) in stars.iter().zip(waypoints.iter()) {
                    star.toggle(visited.is_some_and(|at| f64::from(at) <= time));
                }
            }
        });
    }
    let scale = (frame.units(STAR_PX) / STAR_UNITS).max(1.0);
    let at = |cell: Cell| {
        let unit = |at: u32| units(f64::from(at));
        format!("translate({} {})", unit(cell.x), unit(cell.y))
    };
    let star = |&(cell, number, _): &(Cell, u32, Option<u32>)| {
        html! {
            <g key={number} class="star" transform={at(cell)}>
                <g transform={format!("scale({scale:.2})")}><path class="halo" d={STAR} /><path class="body" d={STAR} /></g>
                if waypoints.len() > 1 { <text class="num" dy="0.36em">{ number }</text> }
            </g>
        }
    };
    let goal = cast.agents.get(*agent).and_then(|own| own.goal);
    let flag = |cell: Cell| {
        html! {
            <g class="flag" transform={format!("{} scale({scale:.2}) translate(-76 -30)", at(cell))}>
                <path class="halo" d={FLAG} /><path class="pole" d={FLAG_POLE} /><path class="cloth" d={FLAG_CLOTH} />
            </g>
        }
    };
    html! {
        <g class={classes!("chosen", glyph::class(*agent))} aria-hidden="true">
            <g ref={layer}>{ for waypoints.iter().map(star) }</g>
            { goal.map(flag) }
        </g>
    }
}

/// Its form above all dots; where robots have forms the ring of the selection is enough.
#[component]
pub(super) fn ChosenForm(props: &ChosenProps) -> Html {
    let ChosenProps { cast, agent, frame } = props;
    let place = use_node_ref();
    {
        let (cast, place, agent) = (Rc::clone(cast), place.clone(), *agent);
        use_motion(move || {
            let place = place.cast().map(|place| Attribute::new(place, "transform"));
            move |time| {
                if let (Some(place), Some(pose)) = (&place, cast.pose(agent, time)) {
                    let (x, y) = (units(pose.at.x), units(pose.at.y));
                    place.set(&format!("translate({x:.1} {y:.1})"));
                }
            }
        });
    }
    if frame.detail() != Detail::Dots {
        return html! {};
    }
    let scale = (frame.units(FORM_PX) / FORM_UNITS).max(1.35);
    html! {
        <g class={classes!("chosen", glyph::class(*agent))} aria-hidden="true" ref={place}>
            <circle class="selring" r={format!("{:.1}", frame.units(RING_PX))} />
            <g transform={format!("scale({scale:.2})")}>{ crate::form(*agent) }</g>
        </g>
    }
}
