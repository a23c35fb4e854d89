//! The cell that the order is shown at, and beside it who passes, in order.

use giveway_page::State;
use giveway_page::board::{CELL, Cast};
use giveway_page::order::{self, Strip, StripRobot};
use yew::prelude::*;

use crate::glyph;
use crate::part::part;

/// The room of a robot in the strip, in pixels, and the least and the most in units.
const EACH_PX: f64 = 32.0;
const EACH: (f64, f64) = (70.0, 320.0);

#[derive(Clone, PartialEq, Properties)]
struct StripProps {
    strip: Strip,
    /// What stands on the form of each robot.
    badges: Vec<String>,
    /// The room of a robot, in units.
    each: f64,
    /// The width and the height of the map, in units.
    map: (f64, f64),
}

/// The cell and the strip, where the order is shown.
pub(super) fn strip(state: &State, cast: &Cast, cell_px: f64) -> Html {
    let Some(strip) = order::strip(state) else {
        return Html::default();
    };
    let grid = state.world().grid();
    let badge = |robot: &StripRobot| cast.badges.get(robot.agent).cloned().unwrap_or_default();
    let props = StripProps {
        badges: strip.robots.iter().map(badge).collect(),
        strip,
        each: (EACH_PX / cell_px * CELL).clamp(EACH.0, EACH.1),
        map: (
            f64::from(grid.width()) * CELL,
            f64::from(grid.height()) * CELL,
        ),
    };
    html! { { part::<OrderStrip>(props) } }
}

#[component]
fn OrderStrip(props: &StripProps) -> Html {
    let StripProps {
        strip,
        badges,
        each,
        map,
    } = props;
    let (x, y) = (
        f64::from(strip.cell.x) * CELL,
        f64::from(strip.cell.y) * CELL,
    );
    let more = |n: usize| if n > 0 { 0.8 * each } else { 0.0 };
    let (before, after) = (more(strip.more.0), more(strip.more.1));
    let width = strip.robots.len() as f64 * each + before + after + 0.2 * each;
    let height = 0.95 * each;
    // Above the cell and to its right; below it where the map ends.
    let left = (x + 0.6 * CELL).min(map.0 - width - 6.0).max(6.0);
    let is_below = y - height - 10.0 < 0.0;
    let top = if is_below {
        y + CELL + 10.0
    } else {
        y - height - 10.0
    };
    let scale = each / 90.0;
    let middle = top + height / 2.0;
    let at = |place: usize| left + 0.1 * each + before + (place as f64 + 0.5) * each;
    let robot = |(place, robot): (usize, &StripRobot)| {
        let class = classes!(
            glyph::class(robot.agent),
            robot.is_through.then_some("through")
        );
        let badge = badges.get(place).cloned().unwrap_or_default();
        let is_long = giveway_page::form::is_long(&badge);
        html! {
            <g transform={format!("translate({:.1} {middle:.1}) scale({scale:.2})", at(place))}>
                <g {class}>
                    { glyph::form(robot.agent) }
                    <text class={classes!("gname", is_long.then_some("long"))} y={if is_long { "6.5" } else { "8.5" }} text-anchor="middle">{ badge }</text>
                </g>
                if robot.is_in { <circle class="ring-in" r="36" /> }
                if place > 0 { <path class="next" d="M-49-7l7 7-7 7" /> }
            </g>
        }
    };
    let count = |n: usize, middle_x: f64| {
        html! {
            <text class="more" x={format!("{middle_x:.1}")} y={format!("{:.1}", middle + 8.0 * scale)} font-size={format!("{:.0}", 24.0 * scale)} text-anchor="middle">{ format!("+{n}") }</text>
        }
    };
    html! {
        <g class="order-strip" aria-hidden="true">
            <rect class="order-cell" x={(x + 3.0).to_string()} y={(y + 3.0).to_string()} width={(CELL - 6.0).to_string()} height={(CELL - 6.0).to_string()} rx="12" />
            if !strip.robots.is_empty() {
                <rect class="pill" x={format!("{left:.1}")} y={format!("{top:.1}")} width={format!("{width:.1}")} height={format!("{height:.1}")} rx={format!("{:.1}", height / 2.0)} />
                if before > 0.0 { { count(strip.more.0, left + 0.1 * each + before / 2.0) } }
                { for strip.robots.iter().enumerate().map(robot) }
                if after > 0.0 { { count(strip.more.1, at(strip.robots.len()) - 0.5 * each + after / 2.0) } }
            }
        </g>
    }
}
