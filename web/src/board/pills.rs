//! Names as pills above robots: of the one that is selected, and of the one under the pointer.

use std::rc::Rc;

use giveway_model::words::middle_cut;
use giveway_page::board::{Cast, Detail};
use yew::prelude::*;

use super::motion::{Attribute, children, use_motion};
use super::pointer::{Pointer, use_pointed};
use super::units;
use super::viewport::Sight;
use crate::glyph;

/// The most letters of a name.
const LETTERS: usize = 18;
/// From the middle of a pill to its upper end, and to the robot, in pixels.
const HALF_PX: f64 = 10.0;
const AWAY_PX: f64 = 14.0;
/// The radius of a robot, in units; at least so many pixels.
const RADIUS: (f64, f64) = (42.0, 6.0);
/// The width of a letter, and of the room around all of them, in pixels.
const LETTER_PX: f64 = 7.5;
const ROOM_PX: f64 = 10.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct PillsProps {
    pub(super) cast: Rc<Cast>,
    pub(super) selected: Option<usize>,
    pub(super) detail: Detail,
    pub(super) sight: Sight,
    pub(super) pointer: Rc<Pointer>,
}

/// The pills, which stay in sight.
#[component]
pub(super) fn Pills(props: &PillsProps) -> Html {
    let layer = use_node_ref();
    let pointed = use_pointed(&props.pointer).and_then(|at| at.agent);
    let pointed = pointed.filter(|_| props.selected != pointed);
    // A name that stands on the form is not written twice.
    let is_told = |agent: &usize| {
        let own = props
            .cast
            .agents
            .get(*agent)
            .zip(props.cast.badges.get(*agent));
        own.is_some_and(|(own, badge)| props.detail < Detail::All || own.name != *badge)
    };
    let told = [props.selected, pointed].into_iter().flatten();
    let told: Vec<(usize, String)> = told
        .filter(is_told)
        .map(|agent| (agent, middle_cut(&props.cast.agents[agent].name, LETTERS)))
        .collect();
    {
        let (told, props, layer) = (told.clone(), props.clone(), layer.clone());
        use_motion(move || {
            let pills = children(&layer).into_iter();
            let pills: Vec<_> = pills
                .map(|pill| {
                    (
                        Attribute::new(pill.clone(), "transform"),
                        Attribute::new(pill, "data-gone"),
                    )
                })
                .collect();
            move |time| {
                let frame = props.sight.get();
                let px = |px: f64| frame.units(px);
                for ((place, gone), (agent, name)) in pills.iter().zip(&told) {
                    let Some(pose) = props.cast.pose(*agent, time) else {
                        continue;
                    };
                    gone.toggle(pose.is_gone || !frame.shows(pose.at));
                    let away = RADIUS.0.max(px(RADIUS.1)) + px(AWAY_PX);
                    let (x, y) = (units(pose.at.x), units(pose.at.y));
                    let is_high = y - away - px(HALF_PX) < frame.y;
                    let y = if is_high { y + away } else { y - away };
                    let half = px(wide(name) / 2.0 + 2.0);
                    let x = x.min(frame.x + frame.width - half).max(frame.x + half);
                    place.set(&format!("translate({x:.1} {y:.1})"));
                }
            }
        });
    }
    let pill = |(agent, name): &(usize, String)| {
        let class = if props.selected == Some(*agent) {
            "me"
        } else {
            "at"
        };
        // The size of letters is 10 px: a tenth of it is a pixel.
        let em = |px: f64| format!("{:.2}em", px / 10.0);
        html! {
            <g key={class} class={classes!("pill", class, glyph::class(*agent))}>
                <rect x={em(-wide(name) / 2.0)} y={em(-HALF_PX)} width={em(wide(name))} height={em(2.0 * HALF_PX)} rx={em(5.0)} />
                <text dy="0.36em">{ name.clone() }</text>
            </g>
        }
    };
    html! { <g aria-hidden="true" ref={layer}>{ for told.iter().map(pill) }</g> }
}

/// The width of a name's pill, in pixels.
fn wide(name: &str) -> f64 {
    name.chars().count() as f64 * LETTER_PX + ROOM_PX
}
