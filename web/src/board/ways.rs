//! The way behind each agent, and the way ahead.
//!
//! What stands still within a move has a layer of its own, which the browser
//! need not paint anew in every frame: many dots take long. For the same reason
//! nothing here has a transform or an opacity: each would be a piece to itself.

use std::cell::Cell;
use std::rc::Rc;

use giveway_page::board::Cast;
use web_sys::Element;
use yew::prelude::*;

use super::motion::{Attribute, children, use_motion};
use crate::glyph;

/// The most agents whose ways are all drawn. Of more, nobody could follow one:
/// then only that of the selected agent is.
const MOST: usize = 64;

/// Whose.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct WaysProps {
    pub(super) cast: Rc<Cast>,
    pub(super) selected: Option<usize>,
    /// Whose ways ahead are drawn; all where there is none.
    pub(super) ahead: Option<Vec<usize>>,
    /// Whether only the way of the one selected is drawn.
    #[prop_or_default]
    pub(super) is_alone: bool,
    /// The time at which they are drawn at once, on paper.
    #[prop_or_default]
    pub(super) still: Option<f64>,
}

/// The ways.
#[component]
pub(super) fn Ways(props: &WaysProps) -> Html {
    let (still, ends) = (use_node_ref(), use_node_ref());
    let count = props.cast.agents.len();
    let shown: Vec<usize> = if props.is_alone {
        props.selected.into_iter().collect()
    } else if count <= MOST {
        (0..count).collect()
    } else {
        let concerned = props.ahead.iter().flatten().copied();
        let concerned = concerned.filter(|&agent| agent < count);
        props.selected.into_iter().chain(concerned).collect()
    };
    {
        let (cast, shown) = (Rc::clone(&props.cast), shown.clone());
        let (still, ends) = (still.clone(), ends.clone());
        use_motion(move || {
            let pairs = children(&still).into_iter().zip(children(&ends));
            let ways: Vec<Parts> = pairs
                .filter_map(|(still, end)| Parts::new(&still, &end))
                .collect();
            move |time| {
                for (parts, &agent) in ways.iter().zip(&shown) {
                    parts.show(&cast, agent, time);
                }
            }
        });
    }
    let is_calm = |agent: usize| {
        let ahead = props.ahead.as_ref();
        ahead.is_some_and(|ahead| !ahead.contains(&agent))
    };
    let lines = |agent: usize, points: [Option<String>; 2]| {
        let [behind, ahead] = points;
        html! {
            <g key={agent} class={classes!(glyph::class(agent), is_calm(agent).then_some("no-ahead"))}>
                <polyline class="trail" points={behind} />
                <polyline class="ahead-halo" points={ahead.clone()} />
                <polyline class="ahead" points={ahead} />
            </g>
        }
    };
    let fixed = |agent: usize| {
        let time = props.still?;
        let (way, pose) = (
            &props.cast.ways[agent],
            props.cast.tracks[agent].pose(time)?,
        );
        let stop = way.last_stop(time);
        Some((way.behind(stop), way.ahead(stop), way.ends(stop, pose.at)))
    };
    let still_lines = |&agent: &usize| {
        let fixed = fixed(agent);
        lines(
            agent,
            [fixed.as_ref().map(|it| it.0.clone()), fixed.map(|it| it.1)],
        )
    };
    let end_lines = |&agent: &usize| {
        let fixed = fixed(agent);
        lines(
            agent,
            [
                fixed.as_ref().map(|it| it.2.behind.clone()),
                fixed.map(|it| it.2.ahead),
            ],
        )
    };
    html! {
        <g aria-hidden="true">
            <g class="ways-still" ref={still}>{ for shown.iter().map(still_lines) }</g>
            <g ref={ends}>{ for shown.iter().map(end_lines) }</g>
        </g>
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
    fn new(still: &Element, end: &Element) -> Option<Self> {
        let points =
            |of: &Element, index| Some(Attribute::new(of.children().item(index)?, "points"));
        let dots = |index| {
            Some(Attribute::new(
                end.children().item(index)?,
                "stroke-dashoffset",
            ))
        };
        Some(Self {
            behind: [points(still, 0)?, points(end, 0)?],
            ahead: [
                points(still, 1)?,
                points(end, 1)?,
                points(still, 2)?,
                points(end, 2)?,
            ],
            dots: [dots(1)?, dots(2)?],
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
