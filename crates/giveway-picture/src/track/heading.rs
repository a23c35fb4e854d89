//! Where an agent looks: at its next move, and it turns shortly before that begins.

use giveway_model::Cell;

use super::Track;
use crate::whole;

/// The part of a step in which an agent turns to its next move, at its end: at
/// a whole time it already looks where it goes next.
const TURN: f64 = 0.3;

impl Track {
    /// In degrees from the right, clockwise; `None` for one that has no move to make any
    /// more.
    pub(super) fn heading(&self, time: f64) -> Option<f64> {
        if time >= f64::from(self.last_stop()) {
            return None;
        }
        let last = self.headings.len().checked_sub(1)?;
        let step = (whole(time) as usize).min(last);
        let (now, then) = (self.headings[step], self.headings[(step + 1).min(last)]);
        let share = ((time - step as f64 - (1.0 - TURN)) / TURN).clamp(0.0, 1.0);
        // The shorter way round.
        let turn = (then - now + 540.0).rem_euclid(360.0) - 180.0;
        Some(now + turn * share)
    }
}

/// The time from which on a path stays on its last cell.
pub(super) fn last_stop(path: &[Option<Cell>]) -> u32 {
    let resting = path.iter().rev().take_while(|&at| Some(at) == path.last());
    path.len().saturating_sub(resting.count()) as u32
}

/// Where it looks at each time: at the next move, after the last at that.
pub(super) fn headings(path: &[Option<Cell>]) -> Vec<f64> {
    let mut headings = vec![None; path.len()];
    let stops = path.iter().enumerate();
    let stops: Vec<(usize, Cell)> = stops.filter_map(|(t, c)| c.map(|c| (t, c))).collect();
    for pair in stops.windows(2) {
        if pair[0].1 != pair[1].1 {
            headings[pair[0].0..pair[1].0].fill(Some(direction(pair[0].1, pair[1].1)));
        }
    }
    let mut next = None;
    for heading in headings.iter_mut().rev() {
        next = heading.or(next);
        *heading = next;
    }
    let mut before = None;
    for heading in &mut headings {
        before = heading.or(before);
        *heading = before;
    }
    headings.into_iter().flatten().collect()
}

fn direction(from: Cell, to: Cell) -> f64 {
    let by = |to: u32, from: u32| f64::from(to.cast_signed()) - f64::from(from.cast_signed());
    let (dx, dy) = (by(to.x, from.x), by(to.y, from.y));
    dy.atan2(dx).to_degrees()
}

#[cfg(test)]
mod tests {
    use giveway_model::AtGoal;

    use super::*;
    use crate::track::tests::track;

    #[test]
    fn it_turns_to_its_next_move_before_it_begins() {
        let track = track("0121");
        let heading = |time| track.pose(time).unwrap().heading.unwrap();
        assert_eq!(
            (heading(0.0), heading(1.6), heading(2.0)),
            (0.0, 0.0, 180.0)
        );
        let turning = heading(1.85);
        assert!((turning.abs() - 90.0).abs() < 1e-6, "{turning}");
    }

    #[test]
    fn one_that_has_arrived_looks_nowhere() {
        let heading = |row: &str, time| track(row).pose(time).unwrap().heading;
        assert_eq!(heading("0121", 2.9), Some(180.0));
        assert_eq!(heading("0121", 3.0), None);
        assert_eq!(heading("0121", 9.0), None);
        // It waits at the end; before, it only stays for a while.
        assert_eq!(heading("011222", 2.0), Some(0.0));
        assert_eq!(heading("011222", 3.0), None);
        let turning = track("012").turning(vec![0.0, 0.0, 90.0]);
        assert_eq!(turning.pose(2.0).unwrap().heading, None);
    }

    #[test]
    fn it_turns_the_shorter_way() {
        let up_left = [(1, 1), (1, 0), (0, 0), (0, 1)].map(|(x, y)| Some(Cell::new(x, y)));
        let track = Track::new(up_left.to_vec(), Vec::new(), None, AtGoal::Stay);
        let heading = |time| track.pose(time).unwrap().heading.unwrap();
        assert_eq!((heading(0.0), heading(1.0)), (-90.0, 180.0));
        assert!((heading(0.85) - -135.0).abs() < 1e-6);
        assert!((heading(1.85) - 135.0).abs() < 1e-6);
    }

    #[test]
    fn one_that_never_moves_looks_nowhere() {
        assert_eq!(track("33").pose(0.5).unwrap().heading, None);
        assert_eq!(track("").pose(0.0), None);
    }
}
