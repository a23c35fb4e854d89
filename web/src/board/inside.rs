//! What is drawn over the map of a step of how the plan was found.

use giveway_page::form;
use giveway_page::inside::{Ban, Meeting, Overlay, Shade};
use yew::prelude::*;

use super::layers::square;
use super::reasons::STAR;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct InsideProps {
    pub(super) overlay: Overlay,
}

/// Where robots can be; it lies on the floor.
#[component]
pub(super) fn InsideFloor(props: &InsideProps) -> Html {
    let shade = |shade: &Shade| {
        html! { <path class={classes!("reach", form::class(shade.agent))} fill-rule="evenodd" d={shade.path.clone()} /> }
    };
    html! { <g aria-hidden="true">{ for props.overlay.shades.iter().map(shade) }</g> }
}

/// What lies over all that stands and moves.
#[component]
pub(super) fn InsideMarks(props: &InsideProps) -> Html {
    let overlay = &props.overlay;
    let burst = |(x, y): &(f64, f64)| {
        html! {
            <g class="burst" transform={format!("translate({x} {y})")}>
                <path d={STAR} /><path class="ex" d="M0-11V3M0 11v.1" />
            </g>
        }
    };
    html! {
        <g aria-hidden="true">
            { for overlay.bans.iter().map(ban) }
            { for overlay.bursts.iter().map(burst) }
            { for overlay.meetings.iter().map(meeting) }
            if let Some((cell, text)) = &overlay.stuck {
                { square("vcell", *cell, 4) }
                { stuck_label(cell.x, cell.y, text) }
            }
        </g>
    }
}

/// How wide a label is, in units.
fn wide(text: &str) -> f64 {
    text.chars().count() as f64 * 9.6 + 22.0
}

fn ban(ban: &Ban) -> Html {
    let (x, y) = ban.label;
    let width = wide(&ban.text);
    html! {
        <g class={classes!("ban", form::class(ban.agent), ban.is_asked.then_some("asked"))}>
            if let Some(cell) = ban.cell {
                <rect class="at" x={(100 * cell.x + 7).to_string()} y={(100 * cell.y + 7).to_string()} width="86" height="86" rx="14" />
            }
            if let Some([(x1, y1), (x2, y2)]) = ban.line {
                <line class="at" x1={x1.to_string()} y1={y1.to_string()} x2={x2.to_string()} y2={y2.to_string()} />
            }
            <g transform={format!("translate({x} {y})")}>
                <rect class="tg" x={(-width / 2.0).to_string()} y="-14" width={width.to_string()} height="28" rx="14" />
                <text y="6" text-anchor="middle">{ ban.text.clone() }</text>
            </g>
        </g>
    }
}

fn meeting(meeting: &Meeting) -> Html {
    let ((x, y), (u, v)) = (meeting.at, meeting.label);
    let width = wide(&meeting.text) + 6.0;
    html! {
        <>
            <circle class="meetring" cx={x.to_string()} cy={y.to_string()} r="56" />
            <g class="meet-at" transform={format!("translate({u} {v})")}>
                <rect x={(-width / 2.0).to_string()} y="-17" width={width.to_string()} height="34" rx="17" />
                <text y="6" text-anchor="middle">{ meeting.text.clone() }</text>
            </g>
        </>
    }
}

/// Above its cell, or below it in the first row.
fn stuck_label(x: u32, y: u32, text: &str) -> Html {
    let middle = f64::from(x) * 100.0 + 50.0;
    let at = if y == 0 { 122.0 } else { f64::from(y) * 100.0 - 20.0 };
    let width = wide(text) + 6.0;
    html! {
        <g class="stuck-at" transform={format!("translate({middle} {at})")}>
            <rect x={(-width / 2.0).to_string()} y="-17" width={width.to_string()} height="34" rx="17" />
            <text y="6" text-anchor="middle">{ text.to_owned() }</text>
        </g>
    }
}
