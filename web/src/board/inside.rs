//! What is drawn over the map of a step of how the plan was found.

use giveway_page::board::{CELL, Star};
use giveway_page::inside::{Ban, Meeting, Overlay, Shade};
use yew::prelude::*;

use super::layers::square;
use super::reasons::burst;
use crate::glyph;

/// What is written over the map is at least so high, in pixels.
const LETTERS: f64 = 11.0;
/// The same in units, where cells are large enough for it.
const LETTERS_AT: f64 = 18.0;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct InsideProps {
    pub(super) overlay: Overlay,
}

#[derive(Clone, PartialEq, Properties)]
pub(super) struct MarksProps {
    pub(super) overlay: Overlay,
    /// How large a cell is, in pixels.
    pub(super) cell_px: f64,
    /// How many columns the map has.
    pub(super) columns: u32,
}

/// Where robots can be; it lies on the floor.
#[component]
pub(super) fn InsideFloor(props: &InsideProps) -> Html {
    let shade = |shade: &Shade| {
        html! { <path class={classes!("reach", glyph::class(shade.agent))} fill-rule="evenodd" d={shade.path.clone()} /> }
    };
    html! { <g aria-hidden="true">{ for props.overlay.shades.iter().map(shade) }</g> }
}

/// What lies over all that stands and moves.
#[component]
pub(super) fn InsideMarks(props: &MarksProps) -> Html {
    let MarksProps {
        overlay,
        cell_px,
        columns,
    } = props;
    let scale = (LETTERS / (LETTERS_AT * cell_px / CELL)).clamp(1.0, 7.0);
    let label = Label {
        scale,
        right: f64::from(*columns) * CELL,
    };
    let ring = RING.max(RING_PX * CELL / cell_px);
    let stars = overlay.bursts.iter().map(|place| place.star(*cell_px));
    let stars: Vec<Star> = stars.collect();
    html! {
        <g aria-hidden="true">
            { for overlay.bans.iter().map(ban) }
            { for overlay.bursts.iter().map(|&place| burst(place, *cell_px)) }
            { for overlay.bans.iter().map(|each| ban_label(each, label, &stars)) }
            { for overlay.meetings.iter().map(|each| meeting(each, label, ring)) }
            if let Some((cell, text)) = &overlay.stuck {
                { square("vcell", *cell, 4) }
                { stuck_label(cell.x, cell.y, text, label) }
            }
        </g>
    }
}

/// Half the height of the label of a ban, in units.
const HALF_BAN: f64 = 14.0;
/// The radius of the ring around a meeting, in units.
const RING: f64 = 56.0;
/// It is at least so large, in pixels.
const RING_PX: f64 = 9.0;

/// How labels are written.
#[derive(Clone, Copy)]
struct Label {
    /// How much larger than drawn.
    scale: f64,
    /// Where the map ends, in units.
    right: f64,
}

impl Label {
    /// The middle of a label of so much width that is wanted somewhere: the map's
    /// edges cut nothing off.
    fn on_map(self, x: f64, width: f64) -> f64 {
        let half = width * self.scale / 2.0 + 3.0;
        x.min(self.right - half).max(half)
    }

    /// The same beside a star that would cover it.
    fn beside(self, at: (f64, f64), width: f64, stars: &[Star]) -> f64 {
        let half = (width * self.scale / 2.0, HALF_BAN * self.scale);
        let mut aside = stars
            .iter()
            .filter_map(|star| star.aside(at, half, self.right));
        self.on_map(aside.next().unwrap_or(at.0), width)
    }
}

/// How wide a label is, in units.
fn wide(text: &str) -> f64 {
    text.chars().count() as f64 * 9.6 + 22.0
}

fn ban_class(ban: &Ban) -> Classes {
    classes!(
        "ban",
        glyph::class(ban.agent),
        ban.is_asked.then_some("asked")
    )
}

fn ban(ban: &Ban) -> Html {
    html! {
        <g class={ban_class(ban)}>
            if let Some(cell) = ban.cell {
                <rect class="at" x={(100 * cell.x + 7).to_string()} y={(100 * cell.y + 7).to_string()} width="86" height="86" rx="14" />
            }
            if let Some([(x1, y1), (x2, y2)]) = ban.line {
                <line class="at" x1={x1.to_string()} y1={y1.to_string()} x2={x2.to_string()} y2={y2.to_string()} />
            }
        </g>
    }
}

/// What is said of a ban stands above the lines of all of them.
fn ban_label(ban: &Ban, label: Label, stars: &[Star]) -> Html {
    let (_, y) = ban.label;
    let width = wide(&ban.text);
    let (x, scale) = (label.beside(ban.label, width, stars), label.scale);
    html! {
        <g class={ban_class(ban)} transform={format!("translate({x} {y}) scale({scale})")}>
            <rect class="tg" x={(-width / 2.0).to_string()} y={(-HALF_BAN).to_string()} width={width.to_string()} height={(2.0 * HALF_BAN).to_string()} rx={HALF_BAN.to_string()} />
            <text y="6" text-anchor="middle">{ ban.text.clone() }</text>
        </g>
    }
}

fn meeting(meeting: &Meeting, label: Label, ring: f64) -> Html {
    let (x, y) = meeting.at;
    let width = wide(&meeting.text) + 6.0;
    let scale = label.scale;
    let aside = ring + 8.0 + width * scale / 2.0;
    let u = if meeting.is_left {
        x - aside
    } else {
        x + aside
    };
    let u = label.on_map(u, width);
    html! {
        <>
            <circle class="meetring" cx={x.to_string()} cy={y.to_string()} r={ring.to_string()} />
            <g class="meet-at" transform={format!("translate({u} {y}) scale({scale})")}>
                <rect x={(-width / 2.0).to_string()} y="-17" width={width.to_string()} height="34" rx="17" />
                <text y="6" text-anchor="middle">{ meeting.text.clone() }</text>
            </g>
        </>
    }
}

/// Above its cell, or below it in the first row.
fn stuck_label(x: u32, y: u32, text: &str, label: Label) -> Html {
    let scale = label.scale;
    let middle = f64::from(x) * 100.0 + 50.0;
    let up = 17.0 * scale + 3.0;
    let at = if y == 0 {
        CELL + up
    } else {
        f64::from(y) * CELL - up
    };
    let width = wide(text) + 6.0;
    let middle = label.on_map(middle, width);
    html! {
        <g class="stuck-at" transform={format!("translate({middle} {at}) scale({scale})")}>
            <rect x={(-width / 2.0).to_string()} y="-17" width={width.to_string()} height="34" rx="17" />
            <text y="6" text-anchor="middle">{ text.to_owned() }</text>
        </g>
    }
}
