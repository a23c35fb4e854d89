//! Goals and waypoints. Where an agent stands on them they shrink into corners.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_page::board::{Cast, Detail, Mark, MarkKind, Occupied};
use yew::prelude::*;

use super::motion::{Attribute, children, use_motion};
use crate::glyph;
use crate::held::Held;

pub(super) const FLAG_POLE: &str = "M66 46V14";
pub(super) const FLAG_CLOTH: &str = "M66 14h24l-7 9 7 9H66Z";
pub(super) const FLAG: &str = "M66 46V14h24l-7 9 7 9H66";
pub(super) const STAR: &str =
    "M0-25 7.4-8.5 25-6.5 11.9 5.4 15.6 23 0 14.2-15.6 23-11.9 5.4-25-6.5-7.4-8.5Z";

/// Whose, and how fine.
#[derive(Clone, PartialEq, Properties)]
pub(super) struct MarksProps {
    pub(super) cast: Rc<Cast>,
    pub(super) detail: Detail,
    /// Whose goals are seen; all where there is none.
    pub(super) lit: Option<Vec<usize>>,
    /// Whose are left out, for they are drawn larger.
    #[prop_or_default]
    pub(super) but: Option<usize>,
    /// The time at which they are drawn at once, on paper.
    #[prop_or_default]
    pub(super) still: Option<f64>,
}

/// All flags and stars.
#[component]
pub(super) fn Marks(props: &MarksProps) -> Html {
    let layer = use_node_ref();
    {
        let (cast, layer) = (Rc::clone(&props.cast), layer.clone());
        use_motion(move || {
            let marks = children(&layer).into_iter().map(|mark| {
                let occupied = Attribute::new(mark.clone(), "data-occupied");
                (occupied, Attribute::new(mark, "data-visited"))
            });
            let marks: Vec<_> = marks.collect();
            let occupied = Held::new(Occupied::default());
            move |time| {
                let mut now = occupied.take();
                now.see(&cast.tracks, time);
                for ((is_occupied, is_visited), mark) in marks.iter().zip(&cast.marks) {
                    is_occupied.toggle(now.has(mark.cell));
                    is_visited.toggle(mark.visited.is_some_and(|at| f64::from(at) <= time));
                }
                occupied.set(now);
            }
        });
    }
    let is_dim = |mark: &Mark| {
        let lit = props.lit.as_ref();
        props.but == Some(mark.agent) || lit.is_some_and(|lit| !lit.contains(&mark.agent))
    };
    let mut occupied = Occupied::default();
    if let Some(time) = props.still {
        occupied.see(&props.cast.tracks, time);
    }
    let shape = |mark: &Mark| {
        let is_visited = mark.visited.zip(props.still);
        let at = Fixed {
            is_occupied: occupied.has(mark.cell),
            is_visited: is_visited.is_some_and(|(at, time)| f64::from(at) <= time),
        };
        match props.detail {
            _ if is_dim(mark) => html! { <g></g> },
            Detail::Dots => dot(mark),
            detail => match mark.kind {
                MarkKind::Goal => flag(mark, detail, at),
                MarkKind::Waypoint => star(mark, detail, at),
            },
        }
    };
    html! {
        <g aria-hidden="true" ref={layer}>{ for props.cast.marks.iter().map(shape) }</g>
    }
}

/// What a frame tells of a mark; on paper it is drawn at once.
#[derive(Clone, Copy)]
struct Fixed {
    is_occupied: bool,
    is_visited: bool,
}

fn flag(mark: &Mark, detail: Detail, at: Fixed) -> Html {
    html! {
        <g class={classes!("flag", glyph::class(mark.agent))} transform={place(mark, (0.0, 0.0))} data-occupied={at.is_occupied.then_some("")}>
            <g class="in">
                <path class="halo" d={FLAG} />
                <path class="pole" d={FLAG_POLE} />
                <path class="cloth" d={FLAG_CLOTH} />
                { label(mark, detail, ("61", "30", "end")) }
            </g>
        </g>
    }
}

fn star(mark: &Mark, detail: Detail, at: Fixed) -> Html {
    html! {
        <g class={classes!("star", glyph::class(mark.agent))} transform={cell(mark, (50.0, 42.0))}
            data-occupied={at.is_occupied.then_some("")} data-visited={at.is_visited.then_some("")}>
            // In the corner of an occupied cell they stand in a row.
            <g class={classes!("by", format!("by-{}", mark.place.min(2)))} transform={shift(mark)}>
                <g class="in">
                    <path class="halo" d={STAR} />
                    <path class="body" d={STAR} />
                    { label(mark, detail, ("0", "46", "middle")) }
                </g>
            </g>
        </g>
    }
}

/// Where nothing else has room: goals as rings; waypoints are left out.
fn dot(mark: &Mark) -> Html {
    let class = classes!("goal-dot", glyph::class(mark.agent));
    let (x, y) = (50.0 + mark.shift.0, 50.0 + mark.shift.1);
    let (x, y) = (
        f64::from(100 * mark.cell.x) + x,
        f64::from(100 * mark.cell.y) + y,
    );
    html! {
        // No transform: it would be a piece to itself.
        <g>
            if mark.kind == MarkKind::Goal {
                <circle {class} cx={x.to_string()} cy={y.to_string()} r="28" />
            }
        </g>
    }
}

fn label(mark: &Mark, detail: Detail, (x, y, anchor): (&str, &str, &str)) -> Html {
    match &mark.label {
        Some(label) if detail == Detail::All => html! {
            <text class="tag" x={x.to_owned()} y={y.to_owned()} text-anchor={anchor.to_owned()}>{ label }</text>
        },
        _ => Html::default(),
    }
}

fn place(mark: &Mark, within: (f64, f64)) -> String {
    cell(mark, (within.0 + mark.shift.0, within.1 + mark.shift.1))
}

fn cell(mark: &Mark, within: (f64, f64)) -> String {
    let Cell { x, y } = mark.cell;
    let x = f64::from(x) * 100.0 + within.0;
    let y = f64::from(y) * 100.0 + within.1;
    format!("translate({x} {y})")
}

fn shift(mark: &Mark) -> String {
    let (x, y) = mark.shift;
    format!("translate({x} {y})")
}
