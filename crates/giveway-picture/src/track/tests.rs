//! Poses of short paths in one row.

use giveway_model::{AtGoal, Cell};

use super::{Badge, Track};
use crate::Point;

/// A path in one row, `-` in transit.
fn path(row: &str) -> Vec<Option<Cell>> {
    let cell = |c: char| c.to_digit(10).map(|x| Cell::new(x, 0));
    row.chars().map(cell).collect()
}

pub(super) fn track(row: &str) -> Track {
    Track::new(path(row), Vec::new(), None, AtGoal::Stay)
}

#[test]
fn the_ring_goes_down_and_up_evenly() {
    let battery = Some((vec![5, 4, 10], 10));
    let track = Track::new(path("011"), vec![1], battery, AtGoal::Stay);
    let share = |time| track.pose(time).unwrap().charge.unwrap().share;
    assert_eq!((share(0.0), share(0.5), share(1.5)), (0.5, 0.45, 0.7));
    assert_eq!(share(7.0), 1.0);
}

#[test]
fn charging_and_waiting_show_while_they_last() {
    let track = Track::new(path("01112"), vec![2], None, AtGoal::Stay);
    let badge = |time| track.pose(time).unwrap().badge;
    assert_eq!(
        (badge(0.0), badge(1.0), badge(1.9)),
        (None, Some(Badge::Waits), Some(Badge::Waits))
    );
    assert_eq!(
        (badge(2.0), badge(3.0), badge(4.0)),
        (Some(Badge::Charges), None, None)
    );
    assert!(track.has_waits());
    assert!(!self::track("01-2").has_waits());
}

#[test]
fn a_breakdown_is_no_wait() {
    let track = Track::new(path("0111-22"), Vec::new(), None, AtGoal::Stay);
    let track = track.breaking_down(vec![(1, 2), (4, 9)]);
    let badge = |time| track.pose(time).unwrap().badge;
    assert_eq!(badge(1.5), Some(Badge::Broken));
    assert_eq!(badge(2.0), Some(Badge::Waits));
    assert_eq!(badge(4.0), None, "it ends the slow move that it is on");
    assert_eq!(
        (badge(5.0), badge(8.0)),
        (Some(Badge::Broken), Some(Badge::Broken))
    );
    assert_eq!(badge(9.0), None);
    assert!(track.has_waits() && track.has_breakdowns());
    let only = self::track("0011").breaking_down(vec![(0, 1)]);
    assert!(only.has_breakdowns());
    assert!(!self::track("0011").has_breakdowns());
}

#[test]
fn a_slow_move_is_in_transit_from_cell_to_cell() {
    let track = track("01-2");
    let transit = |time| track.pose(time).unwrap().transit;
    let both = Some((Cell::new(1, 0), Cell::new(2, 0)));
    assert_eq!(
        (transit(0.5), transit(1.0), transit(1.1)),
        (None, None, both)
    );
    assert_eq!(
        (transit(2.0), transit(2.9), transit(3.0)),
        (both, both, None)
    );
    assert_eq!(track.pose(2.0).unwrap().at, Point { x: 1.5, y: 0.0 });
}

#[test]
fn one_that_vanishes_is_gone_after_its_arrival() {
    let track = Track::new(path("01"), Vec::new(), None, AtGoal::Vanish);
    let gone = |time| track.pose(time).unwrap().is_gone;
    assert_eq!((gone(1.0), gone(1.1)), (false, true));
}
