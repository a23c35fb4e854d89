//! A lane as SVG path data, in pixels from its left end.

use std::fmt::Write as _;
use std::ops::Range;

use super::{Axis, Lane, Step, Way, whole};

/// The heights within a lane, in pixels from its top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The height of the lane.
    pub height: f64,
    /// The top of the bars.
    pub bar: f64,
    /// The height of the bars.
    pub thick: f64,
    /// The top of the battery's line.
    pub level: f64,
    /// The height of the battery's line.
    pub tall: f64,
}

/// Lanes are lower from this many agents on.
const DENSE_FROM: usize = 4;

impl Row {
    /// Room for a few agents.
    pub const WIDE: Self = Self {
        height: 52.0,
        bar: 8.0,
        thick: 14.0,
        level: 27.0,
        tall: 20.0,
    };
    /// Room for many.
    pub const DENSE: Self = Self {
        height: 36.0,
        bar: 6.0,
        thick: 12.0,
        level: 21.0,
        tall: 11.0,
    };

    /// Half of a lane that shows two plans; batteries have no room there.
    pub const HALF: Self = Self {
        height: 26.0,
        bar: 7.0,
        thick: 12.0,
        level: 26.0,
        tall: 0.0,
    };

    /// Where nobody has a battery.
    pub const BARE: Self = Self {
        height: 32.0,
        bar: 10.0,
        thick: 12.0,
        level: 22.0,
        tall: 0.0,
    };

    /// Of so many agents, so many of them with a battery.
    pub const fn of(agents: usize, batteries: usize) -> Self {
        match (agents, batteries) {
            (_, 0) => Self::BARE,
            (..DENSE_FROM, _) => Self::WIDE,
            _ => Self::DENSE,
        }
    }

    /// The class of its lanes in the style sheet.
    pub fn class(&self) -> Option<&'static str> {
        match self {
            row if *row == Self::BARE => Some("bare"),
            row if *row == Self::DENSE => Some("dense"),
            row if *row == Self::HALF => Some("two"),
            _ => None,
        }
    }

    /// The middle of the bars.
    pub const fn middle(&self) -> f64 {
        self.bar + self.thick / 2.0
    }
}

/// What is drawn of a lane; an empty path draws nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shapes {
    /// The moves, filled.
    pub moves: String,
    /// The slow moves, filled pale and outlined.
    pub slow: String,
    /// The stripes on them, stroked.
    pub stripes: String,
    /// The waits, outlined.
    pub waits: String,
    /// The pause on each wait, stroked.
    pub pauses: String,
    /// The line after the arrival, stroked.
    pub after: String,
    /// Below the battery's level, filled pale.
    pub area: String,
    /// The battery's level, stroked.
    pub level: String,
    /// The middles of the charges.
    pub charges: Vec<f64>,
    /// The radius of a charge.
    pub charge_radius: f64,
    /// Where the flag of the arrival stands, if that is drawn.
    pub flag: Option<f64>,
    /// Where the arrow of a late entry points to, if there is one.
    pub entry: Option<f64>,
}

impl Shapes {
    /// The shapes of a lane at the columns that are drawn.
    pub fn of(lane: &Lane, axis: Axis, row: Row, seen: &Range<u32>) -> Self {
        let mut shapes = Self::default();
        let drawn = |step: &&Step| step.ends >= seen.start && step.begins < seen.end;
        for step in lane.steps.iter().filter(drawn) {
            shapes.add(step, axis, row);
        }
        let is_seen = |time: &u32| seen.contains(time);
        let x = |time: u32| axis.x(f64::from(time));
        shapes.charges = lane
            .charges
            .iter()
            .copied()
            .filter(is_seen)
            .map(x)
            .collect();
        shapes.charge_radius = (axis.column * 0.6).clamp(7.0, row.thick * 0.8);
        let arrives = lane.arrives && is_seen(&lane.arrival);
        shapes.flag = arrives.then(|| x(lane.arrival));
        let late = lane.begins > 0 && is_seen(&lane.begins);
        shapes.entry = late.then(|| x(lane.begins));
        shapes.add_after(lane, axis, row);
        shapes.add_level(lane, axis, row, seen);
        shapes
    }

    /// Frames around the steps of a lane that are not so in another plan.
    pub fn frames(lane: &Lane, other: &Lane, axis: Axis, row: Row, seen: &Range<u32>) -> String {
        const BEYOND: f64 = 2.5;
        let mut frames = String::new();
        let drawn = |step: &&Step| step.ends >= seen.start && step.begins < seen.end;
        for step in lane.steps.iter().filter(drawn) {
            if other.differs_from(step) {
                let left = axis.x(f64::from(step.begins)) + 1.0 - BEYOND;
                let width = axis.x(f64::from(step.ends)) - 1.0 + BEYOND - left;
                let (top, tall) = (row.bar - 4.0, row.thick + 8.0);
                rounded(&mut frames, left, top, width, tall, 5.0);
            }
        }
        frames
    }

    fn add(&mut self, step: &Step, axis: Axis, row: Row) {
        // A pixel at each end parts a bar from the next.
        let left = axis.x(f64::from(step.begins)) + 1.0;
        let width = (axis.x(f64::from(step.ends)) - 1.0 - left).max(1.0);
        let (top, tall) = (row.bar, row.thick);
        match step.way {
            Way::Move => rounded(&mut self.moves, left, top, width, tall, 4.0),
            Way::Slow => {
                rounded(
                    &mut self.slow,
                    left + 0.75,
                    top + 0.75,
                    width - 1.5,
                    tall - 1.5,
                    3.25,
                );
                stripes(&mut self.stripes, left, top, width, tall);
            }
            Way::Wait => {
                rounded(
                    &mut self.waits,
                    left + 0.75,
                    top + 0.75,
                    width - 1.5,
                    tall - 1.5,
                    3.25,
                );
                let (middle, apart) = (left + width / 2.0, (width / 5.0).clamp(1.5, 3.0));
                for x in [middle - apart, middle + apart] {
                    let _ = write!(self.pauses, "M{} {}v6", px(x), px(row.middle() - 3.0));
                }
            }
        }
    }

    fn add_after(&mut self, lane: &Lane, axis: Axis, row: Row) {
        // The flag needs some room before the line begins.
        let from = axis.x(f64::from(lane.arrival)) + 14.0;
        let to = axis.x(f64::from(axis.times - 1));
        if lane.stays && from < to {
            let _ = write!(self.after, "M{} {}H{}", px(from), px(row.middle()), px(to));
        }
    }

    fn add_level(&mut self, lane: &Lane, axis: Axis, row: Row, seen: &Range<u32>) {
        let Some(capacity) = lane.capacity.filter(|_| row.tall > 0.0) else {
            return;
        };
        let capacity = f64::from(capacity.max(1));
        let bottom = row.level + row.tall;
        // One more on each side, for the line goes on there.
        let times = seen.start.saturating_sub(1)..seen.end.saturating_add(1);
        let levels = (lane.begins..).zip(&lane.levels);
        let drawn = levels.filter(|(time, _)| times.contains(time));
        let (mut first, mut last) = (None, 0.0);
        for (time, &level) in drawn {
            let x = axis.x(f64::from(time));
            let y = bottom - row.tall * (f64::from(level) / capacity).min(1.0);
            let letter = if first.is_none() { 'M' } else { 'L' };
            let _ = write!(self.level, "{letter}{} {}", px(x), px(y));
            first.get_or_insert(x);
            last = x;
        }
        if let Some(first) = first {
            let (first, last, bottom) = (px(first), px(last), px(bottom));
            self.area = format!("{}L{last} {bottom}L{first} {bottom}Z", self.level);
        }
    }
}

/// A rectangle with round corners.
fn rounded(path: &mut String, left: f64, top: f64, width: f64, tall: f64, radius: f64) {
    let radius = radius.min(width / 2.0);
    let (across, down) = (px(width - 2.0 * radius), px(tall - 2.0 * radius));
    let (left, top, r) = (px(left + radius), px(top), px(radius));
    let _ = write!(
        path,
        "M{left} {top}h{across}a{r} {r} 0 0 1 {r} {r}v{down}a{r} {r} 0 0 1-{r} {r}h-{across}a{r} {r} 0 0 1-{r}-{r}v-{down}a{r} {r} 0 0 1 {r}-{r}Z"
    );
}

/// Slanted stripes that stay within a rectangle.
fn stripes(path: &mut String, left: f64, top: f64, width: f64, tall: f64) {
    const EVERY: f64 = 8.0;
    let slant = tall * 0.45;
    let count = ((width - slant - 3.0) / EVERY).floor().max(0.0);
    let used = count * EVERY + slant;
    let first = left + (width - used) / 2.0;
    for n in 0..=whole(count) {
        let x = first + f64::from(n) * EVERY;
        let (top, bottom) = (px(top + 1.0), px(top + tall - 1.0));
        let _ = write!(path, "M{} {bottom}L{} {top}", px(x), px(x + slant));
    }
}

/// A hundredth of a pixel is enough.
fn px(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::warehouse;

    fn shapes(seen: &Range<u32>) -> Shapes {
        let lane = Lane::of(&warehouse(), 0).unwrap();
        let axis = Axis {
            times: 19,
            column: 40.0,
        };
        Shapes::of(&lane, axis, Row::WIDE, seen)
    }

    #[test]
    fn a_bar_for_every_move() {
        let all = shapes(&(0..19));
        assert_eq!(all.moves.matches('M').count(), 13);
        assert_eq!(all.slow.matches('M').count(), 2);
        assert_eq!(all.waits, "");
        assert_eq!(all.charges, [380.0]);
        assert_eq!((all.flag, all.entry), (Some(700.0), None));
        assert_eq!(all.after, "M714 15H740");
        // Half a column after 0, full; then lower and lower.
        assert!(
            all.level.starts_with("M20 27L60 29L100 31"),
            "{}",
            all.level
        );
    }

    #[test]
    fn half_a_lane_has_frames_and_no_battery() {
        let lane = Lane::of(&warehouse(), 0).unwrap();
        let mut other = lane.clone();
        other.steps[1].to = giveway_model::Cell::new(1, 1);
        let axis = Axis {
            times: 19,
            column: 40.0,
        };
        let frames = |seen| Shapes::frames(&lane, &other, axis, Row::HALF, &seen);
        assert_eq!(frames(0..19).matches('M').count(), 1);
        assert!(frames(0..19).starts_with("M63.5 3h"), "{}", frames(0..19));
        assert_eq!(frames(8..19), "");
        assert_eq!(Shapes::of(&lane, axis, Row::HALF, &(0..19)).level, "");
    }

    #[test]
    fn what_is_not_seen_is_not_drawn() {
        let some = shapes(&(0..3));
        assert_eq!(some.moves.matches('M').count(), 2);
        assert_eq!(some.slow.matches('M').count(), 1);
        assert_eq!((some.charges.len(), some.flag), (0, None));
        assert_eq!(some.level.matches(['M', 'L']).count(), 4);
    }

    #[test]
    fn a_wait_has_a_pause() {
        let step = |way, begins, ends| Step {
            way,
            begins,
            ends,
            from: giveway_model::Cell::new(0, 0),
            to: giveway_model::Cell::new(0, 0),
        };
        let axis = Axis {
            times: 9,
            column: 14.0,
        };
        let mut shapes = Shapes::default();
        shapes.add(&step(Way::Wait, 0, 1), axis, Row::DENSE);
        assert_eq!(shapes.pauses.matches('M').count(), 2);
        assert!(shapes.waits.starts_with("M12 6.75h4"), "{}", shapes.waits);
    }
}
