//! What of an agent changes over time: its place, where it looks, its battery, whether it
//! is there.

use super::keys::{Key, changes};
use crate::{CELL, Charge, Pose, Track};

/// The middle of an agent, in units.
pub(super) fn middle(pose: &Pose) -> (f64, f64) {
    ((pose.at.x + 0.5) * CELL, (pose.at.y + 0.5) * CELL)
}

/// Where an agent is at each time that it is on a cell.
pub(super) fn places(track: &Track) -> Vec<Key<2>> {
    let stops = (0..track.path().len()).filter(|&time| track.path()[time].is_some());
    let key = |time: usize| {
        let pose = track.pose(time as f64)?;
        let (x, y) = middle(&pose);
        Some((time as f64, [x, y]))
    };
    stops.filter_map(key).collect()
}

/// Where an agent looks: it turns at the end of a step.
pub(super) fn turns(track: &Track, steps: u32) -> Vec<Key<1>> {
    let mut keys: Vec<Key<1>> = Vec::new();
    for step in 0..=steps {
        for part in [0.0, 0.7] {
            let time = f64::from(step) + part;
            let heading = track.pose(time).and_then(|pose| pose.heading);
            let Some(mut heading) = heading else { continue };
            if let Some((_, [before])) = keys.last() {
                // The shorter way round.
                heading = before + (heading - before + 540.0).rem_euclid(360.0) - 180.0;
            }
            keys.push((time, [heading]));
        }
    }
    keys
}

/// How full the battery is at each time.
pub(super) fn loads(track: &Track, steps: u32) -> Vec<Key<1>> {
    let share = |time: u32| Some(track.pose(f64::from(time))?.charge?.share);
    let key = |time: u32| Some((f64::from(time), [share(time)?]));
    (0..=steps).filter_map(key).collect()
}

/// When its ring has which colour.
pub(super) fn tones(track: &Track, steps: u32) -> Vec<(f64, &'static str)> {
    let tone = |pose: &Pose| pose.charge.map_or("ok", Charge::class);
    // It changes within a step, while a level goes down.
    let times = (0..=10 * steps).map(|tenth| f64::from(tenth) / 10.0);
    let tones = times.filter_map(|time| Some((time, tone(&track.pose(time)?))));
    changes(tones)
}

/// What is so in each step; it is looked at after a part of the step.
pub(super) fn each_step<T: PartialEq>(
    track: &Track,
    steps: u32,
    part: f64,
    what: impl Fn(&Pose) -> T,
) -> Vec<(f64, T)> {
    let times = (0..=steps).map(f64::from);
    let values = times.filter_map(|time| Some((time, what(&track.pose(time + part)?))));
    changes(values)
}

/// When an agent is not there.
pub(super) fn gone(track: &Track, steps: u32) -> Vec<(f64, bool)> {
    let times = (0..=2 * steps + 2).map(|half| f64::from(half) / 2.0);
    let values = times.filter_map(|time| Some((time, track.pose(time)?.is_gone)));
    changes(values)
}

#[cfg(test)]
mod tests {
    use giveway_model::{AtGoal, Cell};

    use super::*;

    fn track(row: &str) -> Track {
        let cell = |c: char| c.to_digit(10).map(|x| Cell::new(x, 0));
        Track::new(
            row.chars().map(cell).collect(),
            Vec::new(),
            None,
            AtGoal::Vanish,
        )
    }

    #[test]
    fn a_slow_move_has_no_key_in_the_middle() {
        let times: Vec<f64> = places(&track("01-2")).iter().map(|key| key.0).collect();
        assert_eq!(times, [0.0, 1.0, 3.0]);
    }

    #[test]
    fn one_that_vanishes_is_seen_at_its_goal() {
        assert_eq!(gone(&track("01"), 3), [(0.0, false), (1.5, true)]);
        let late = track("01").between(2, None);
        assert_eq!(gone(&late, 3), [(0.0, true), (2.0, false), (3.5, true)]);
    }

    #[test]
    fn it_turns_the_shorter_way() {
        let path = [(1, 1), (0, 1), (0, 0), (1, 0)].map(|cell| Some(Cell::from(cell)));
        let track = Track::new(path.to_vec(), Vec::new(), None, AtGoal::Stay);
        let headings: Vec<f64> = turns(&track, 3).iter().map(|(_, [to])| *to).collect();
        // Left, up, right.
        assert!((headings[0].abs() - 180.0).abs() < 1e-9);
        assert!(
            headings
                .windows(2)
                .all(|pair| (pair[1] - pair[0]).abs() <= 90.0 + 1e-9)
        );
    }
}
