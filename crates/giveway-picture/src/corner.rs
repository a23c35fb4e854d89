//! What stands in the corners of a cell beside the robot on it: a badge, a flag, stars.
//! The page has the same numbers in its style sheet (`static/css/board.css`).

use crate::MarkKind;

/// A badge of 17 units around its middle, and a rim of 2: how far its middle is from that
/// of the robot, across and down, and how large it is drawn.
const BADGE: (f64, f64) = (35.0, 0.76);

/// Where a flag of an occupied cell stands from where it stands else, and how large.
const FLAG: [f64; 3] = [39.0, -6.0, 0.6];

/// The middles of the first three stars of an occupied cell, from its upper left corner,
/// and how large they are.
const STARS: [(f64, f64); 3] = [(14.0, 86.0), (8.0, 64.0), (8.0, 39.0)];
const STAR: f64 = 0.4;

/// Where a mark stands in an occupied cell, across and down from the corner of the cell,
/// and how large; `place` is its number among those of its kind.
pub(crate) fn of_mark(kind: MarkKind, place: usize, shift: (f64, f64)) -> [f64; 3] {
    match kind {
        MarkKind::Goal => [FLAG[0] + shift.0, FLAG[1] + shift.1, FLAG[2]],
        MarkKind::Waypoint => {
            let (x, y) = STARS[place.min(STARS.len() - 1)];
            [x, y, STAR]
        }
    }
}

/// The transform of a badge: in the corner at the upper right, or at the lower right
/// where a flag stands in that one.
pub fn of_badge(has_flag: bool) -> String {
    let (away, scale) = BADGE;
    let down = if has_flag { away } else { -away };
    format!("translate({away} {down}) scale({scale})")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The radius of a robot's body without a battery, in units: 27, drawn 1.2 times as
    /// large.
    const BODY: f64 = 32.4;

    fn is_free((x, y): (f64, f64), reach: f64) -> bool {
        (x - 50.0).hypot(y - 50.0) >= BODY + reach
    }

    #[test]
    fn what_stands_in_a_corner_leaves_the_robot_free() {
        let (away, scale) = BADGE;
        assert!(is_free((50.0 + away, 50.0 - away), 19.0 * scale));
        for place in 0..3 {
            let [x, y, scale] = of_mark(MarkKind::Waypoint, place, (0.0, 0.0));
            // A star reaches 25 units, and its rim 2 more.
            assert!(is_free((x, y), 27.0 * scale), "{place}");
        }
        let [x, y, scale] = of_mark(MarkKind::Goal, 0, (0.0, 0.0));
        // The foot of the pole, with half its width.
        assert!(is_free((x + 66.0 * scale, y + 46.0 * scale), 2.5 * scale));
    }

    #[test]
    fn the_page_has_the_same_corners() {
        let css = include_str!("../../../static/css/board.css");
        let [x, y, scale] = FLAG;
        assert!(css.contains(&format!("translate({x}px, {y}px) scale({scale})")));
        let (x, y) = STARS[0];
        let from = (x - 50.0, y - 42.0);
        let first = format!("translate({}px, {}px) scale({STAR})", from.0, from.1);
        assert!(css.contains(&first));
        for (place, (u, v)) in STARS.into_iter().enumerate().skip(1) {
            let rule = format!(
                ".by-{place} {{ transform: translate({}px, {}px)",
                u - x,
                v - y
            );
            assert!(css.contains(&rule), "{rule}");
        }
    }
}
