//! The bars and the battery of a lane.

use std::ops::Range;

use giveway_page::freedom::LaneMarks;
use giveway_page::timeline::{Axis, Lane, Row, Shapes};
use yew::prelude::*;

use crate::same::Same;

/// The bolt and the flag of the icons, for use among the bars.
const BOLT: &str = "M11.4 2.8 5 11.2h4.6l-1 6L15 8.8h-4.6Z";
const FLAG: &str = "M5 17.2V3.2M5 4h9.6l-2.4 3.4 2.4 3.4H5";

#[derive(Clone, PartialEq, Properties)]
pub(super) struct BarsProps {
    /// Of which of two plans; of the only one it says nothing.
    pub(super) of: &'static str,
    pub(super) lanes: Same<Vec<Lane>>,
    pub(super) index: usize,
    /// The lane of the other plan: what is not so in it is framed.
    pub(super) versus: Option<(Same<Vec<Lane>>, usize)>,
    /// What of it is in every best plan.
    pub(super) marks: Option<LaneMarks>,
    pub(super) axis: Axis,
    pub(super) row: Row,
    pub(super) columns: Range<u32>,
}

/// The bars and the battery of a lane; the time shown changes nothing in it.
#[component]
pub(super) fn Bars(props: &BarsProps) -> Html {
    let BarsProps {
        of,
        lanes,
        index,
        versus,
        marks,
        axis,
        row,
        columns,
    } = props;
    let Some(lane) = lanes.get(*index) else {
        return Html::default();
    };
    let is_alone = versus.is_none();
    let Drawn {
        shapes,
        over,
        sentence,
    } = drawn(lane, marks.as_ref(), (*axis, *row, columns), is_alone);
    let versus = versus.as_ref();
    let other = versus.and_then(|(lanes, index)| lanes.get(*index));
    let frames = other.map(|other| Shapes::frames(lane, other, *axis, *row, columns));
    let label = if of.is_empty() {
        sentence
    } else {
        format!("{of}: {sentence}")
    };
    let middle = row.middle();
    let radius = shapes.charge_radius;
    let charge = |x: &f64| {
        // The bolt is drawn in a square of 20 around (10, 10).
        let scale = radius * 14.0 / 11.0 / 20.0;
        html! {
            <g key={x.to_string()} class="charge" transform={format!("translate({x} {middle})")}>
                <circle class="ring" r={(radius + 2.0).to_string()} />
                <circle r={(radius - 0.5).to_string()} />
                <path transform={format!("scale({scale:.3}) translate(-10 -10)")} d={BOLT} />
            </g>
        }
    };
    let path = |class: &'static str, d: &str| {
        (!d.is_empty()).then(|| html! { <path class={class} d={d.to_owned()} /> })
    };
    html! {
        <>
        <svg class="bars" width={axis.width().to_string()} height={row.height.to_string()} role="img" aria-label={label}>
            { path("level-area", &shapes.area) }
            { path("level-line", &shapes.level) }
            { path("moves", &shapes.moves) }
            { path("slow", &shapes.slow) }
            { path("stripes", &shapes.stripes) }
            { path("waits", &shapes.waits) }
            { path("pauses", &shapes.pauses) }
            { path("turning", &shapes.turns) }
            { path("turning", &shapes.clocks) }
            { path("broken", &shapes.broken) }
            { path("crosses", &shapes.crosses) }
            { path("after", &shapes.after) }
            { for over.iter().filter_map(|(class, d)| path(class, d)) }
            { path("differs", &frames.unwrap_or_default()) }
            if let Some(x) = shapes.entry {
                <path class="entry" d={format!("M{} {}l5 5-5 5", x - 10.0, middle - 5.0)} />
            }
            if let Some(x) = shapes.flag {
                <path class="flag" transform={format!("translate({} {}) scale(0.85)", x - 3.0, middle - 9.0)} d={FLAG} />
            }
        </svg>
        if !shapes.charges.is_empty() {
            <svg class="bars charges" width={axis.width().to_string()} height={row.height.to_string()} aria-hidden="true">
                { for shapes.charges.iter().map(charge) }
            </svg>
        }
        </>
    }
}

/// A lane as it is drawn and told.
struct Drawn {
    shapes: Shapes,
    /// What is not in every best plan, and how late it may be: classes and paths.
    over: [(&'static str, String); 4],
    sentence: String,
}

fn drawn(
    lane: &Lane,
    marks: Option<&LaneMarks>,
    (axis, row, columns): (Axis, Row, &Range<u32>),
    is_alone: bool,
) -> Drawn {
    let Some(marks) = marks else {
        return Drawn {
            shapes: Shapes::of(lane, axis, row, columns),
            over: <[(&str, String); 4]>::default(),
            sentence: lane.sentence(),
        };
    };
    let marked = marks.shapes(lane, axis, row, columns, is_alone);
    Drawn {
        shapes: marked.shapes,
        over: [
            ("free", marked.free),
            ("open", marked.open),
            ("late-hatch", marked.hatch),
            ("late", marked.late),
        ],
        sentence: lane.sentence() + &marks.sentence(lane),
    }
}
