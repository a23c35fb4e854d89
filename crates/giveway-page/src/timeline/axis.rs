//! The axis of time: ruler, lanes and plan table share its columns.

use std::ops::Range;

use giveway_picture::whole;

/// The least width of a column, in pixels.
pub const MIN_COLUMN: f64 = 5.0;
/// Columns narrower than this have no room for steps one by one, in pixels.
const NARROW: f64 = 14.0;
/// The columns drawn come in bundles, so that scrolling seldom draws anew.
const BUNDLE: u32 = 16;

/// Columns of one width, one for each time from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The number of columns.
    pub times: u32,
    /// The width of a column, in pixels.
    pub column: f64,
}

impl Axis {
    /// The columns of a plan as wide as the room lets them be, and never
    /// narrower than the least: then they need more room than there is.
    pub fn fit(last: u32, room: f64, least: f64) -> Self {
        let times = last + 1;
        // A hair less than fits: no rounding may add a scroll bar.
        let fitting = ((room - 0.5) / f64::from(times) * 100.0).floor() / 100.0;
        Self {
            times,
            column: fitting.max(least),
        }
    }

    /// The width of all columns, in pixels.
    pub fn width(&self) -> f64 {
        f64::from(self.times) * self.column
    }

    /// Whether there is no room for steps one by one: those of one kind are joined.
    pub fn is_narrow(&self) -> bool {
        self.column < NARROW
    }

    /// The middle of the column of a time that need not be whole.
    pub fn x(&self, time: f64) -> f64 {
        (time + 0.5) * self.column
    }

    /// The time whose column is nearest.
    pub fn time_at(&self, x: f64) -> u32 {
        whole(x / self.column).min(self.times - 1)
    }

    /// The columns to draw where those between two places are seen: a bundle
    /// more on each side.
    pub fn seen(&self, left: f64, right: f64) -> Range<u32> {
        let first = self.time_at(left) / BUNDLE * BUNDLE;
        let last = (self.time_at(right) / BUNDLE + 1) * BUNDLE;
        first.saturating_sub(BUNDLE)..(last + BUNDLE).min(self.times)
    }

    /// The times that the ruler names, as many as fit side by side; the first
    /// and the last always.
    pub fn labels(&self) -> Vec<u32> {
        let last = self.times - 1;
        let digits = last.to_string().len() as f64;
        let needed = digits * 7.0 + 12.0;
        let fits = |every: &u32| f64::from(*every) * self.column >= needed;
        let decades = (0..9).flat_map(|n| [1, 2, 5].map(|k| k * 10u32.pow(n)));
        let every = decades.into_iter().find(fits).unwrap_or(last).max(1);
        let near = |time: &u32| f64::from(last - time) * self.column < needed;
        let mut labels: Vec<u32> = (0..=last).step_by(every as usize).collect();
        if labels.last() != Some(&last) {
            if labels.len() > 1 && labels.last().is_some_and(near) {
                labels.pop();
            }
            labels.push(last);
        }
        labels
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_fill_the_room_and_never_more() {
        for room in [280.0, 583.3, 910.0, 1800.7] {
            let axis = Axis::fit(18, room, 14.0);
            assert!(axis.width() < room && axis.width() > room - 1.0, "{room}");
        }
        let long = Axis::fit(999, 900.0, 14.0);
        assert_eq!((long.column, long.width()), (14.0, 14000.0));
    }

    #[test]
    fn a_place_and_its_time() {
        let axis = Axis::fit(18, 950.5, 14.0);
        assert_eq!(axis.column, 50.0);
        assert_eq!(axis.x(9.5), 500.0);
        assert_eq!(axis.time_at(axis.x(7.0)), 7);
        assert_eq!((axis.time_at(-30.0), axis.time_at(9999.0)), (0, 18));
    }

    #[test]
    fn labels_never_touch_and_tell_both_ends() {
        for last in [0, 1, 7, 18, 99, 100, 999, 12345] {
            for room in [200.0, 330.0, 900.0, 2000.0] {
                let axis = Axis::fit(last, room, 14.0);
                let labels = axis.labels();
                assert_eq!((labels[0], labels[labels.len() - 1]), (0, last));
                for pair in labels.windows(2) {
                    let apart = f64::from(pair[1] - pair[0]) * axis.column;
                    let wide = last.to_string().len() as f64 * 7.0;
                    assert!(apart >= wide + 5.0, "{pair:?} of {last} in {room}");
                }
            }
        }
        let phone = Axis::fit(18, 302.0, 14.0);
        assert_eq!(phone.labels(), [0, 2, 4, 6, 8, 10, 12, 14, 16, 18]);
    }

    #[test]
    fn a_plan_of_a_hundred_steps_fits() {
        let axis = Axis::fit(99, 830.0, MIN_COLUMN);
        assert!(axis.width() <= 830.0 && axis.is_narrow());
        assert_eq!(axis.labels()[..3], [0, 5, 10]);
        assert!(Axis::fit(299, 830.0, MIN_COLUMN).width() > 1400.0);
    }

    #[test]
    fn only_columns_near_what_is_seen_are_drawn() {
        let axis = Axis::fit(999, 900.0, 14.0);
        assert_eq!(axis.seen(0.0, 900.0), 0..96);
        assert_eq!(axis.seen(7000.0, 7900.0), 480..592);
        assert_eq!(axis.seen(13_100.0, 14_000.0), 912..1000);
        assert_eq!(Axis::fit(18, 900.0, 14.0).seen(0.0, 900.0), 0..19);
    }
}
