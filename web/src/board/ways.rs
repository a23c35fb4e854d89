//! The way behind each agent, and the way ahead.

use std::cell::Cell;
use std::rc::Rc;

use giveway_page::board::{Cast, Way};
use giveway_page::form;
use web_sys::Element;
use yew::prelude::*;

use super::motion::{Attribute, children, use_motion};

/// The most agents whose ways are all drawn. Of more, nobody could follow one:
/// then only that of the selected agent is.
const MOST: usize = 64;

/// Whose.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct WaysProps {
    pub(super) cast: Rc<Cast>,
    pub(super) selected: Option<usize>,
}

/// The ways.
#[component]
pub(super) fn Ways(props: &WaysProps) -> Html {
    let layer = use_node_ref();
    let count = props.cast.agents.len();
    let shown: Vec<usize> = if count <= MOST {
        (0..count).collect()
    } else {
        props.selected.into_iter().collect()
    };
    {
        let (cast, layer, shown) = (Rc::clone(&props.cast), layer.clone(), shown.clone());
        use_motion(move || {
            let ways: Vec<Parts> = children(&layer).iter().filter_map(Parts::new).collect();
            move |time| {
                for (parts, &agent) in ways.iter().zip(&shown) {
                    parts.show(&cast, agent, time);
                }
            }
        });
    }
    let way = |agent: usize| {
        let offset = Way::offset(agent, count);
        html! {
            <g key={agent} class={classes!("way", form::class(agent))} transform={format!("translate({offset} {offset})")}>
                <polyline class="trail" />
                <polyline class="trail" />
                <polyline class="ahead-halo" />
                <polyline class="ahead-halo" />
                <polyline class="ahead" />
                <polyline class="ahead" />
            </g>
        }
    };
    html! {
        <g aria-hidden="true" ref={layer}>{ for shown.iter().map(|&agent| way(agent)) }</g>
    }
}

/// What changes of a way: of each kind of line the part that stands still
/// within a move, and the end that goes with the agent.
struct Parts {
    behind: [Attribute; 2],
    ahead: [Attribute; 4],
    dots: [Attribute; 2],
    stop: Cell<Option<usize>>,
}

impl Parts {
    fn new(way: &Element) -> Option<Self> {
        let part = |index| way.children().item(index);
        let points = |index| Some(Attribute::new(part(index)?, "points"));
        let dots = |index| Some(Attribute::new(part(index)?, "stroke-dashoffset"));
        Some(Self {
            behind: [points(0)?, points(1)?],
            ahead: [points(2)?, points(3)?, points(4)?, points(5)?],
            dots: [dots(3)?, dots(5)?],
            stop: Cell::new(None),
        })
    }

    fn show(&self, cast: &Cast, agent: usize, time: f64) {
        let (way, track) = (&cast.ways[agent], &cast.tracks[agent]);
        let Some(pose) = track.pose(time) else { return };
        let stop = way.last_stop(time);
        let [behind, behind_end] = &self.behind;
        let [halo, halo_end, ahead, ahead_end] = &self.ahead;
        if self.stop.replace(Some(stop)) != Some(stop) {
            let dots = way.ahead(stop);
            behind.set(&way.behind(stop));
            halo.set(&dots);
            ahead.set(&dots);
        }
        let ends = way.ends(stop, pose.at);
        behind_end.set(&ends.behind);
        for end in [halo_end, ahead_end] {
            end.set(&ends.ahead);
        }
        for dots in &self.dots {
            dots.set(&format!("{:.1}", ends.ahead_offset));
        }
    }
}
