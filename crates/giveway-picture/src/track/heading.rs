//! Where an agent looks: at its next move, and it turns shortly before that begins.

use giveway_model::Cell;

use super::{Track, TurnSide};
use crate::whole;

/// The part of a step in which an agent turns to its next move, at its end: at
/// a whole time it already looks where it goes next.
const TURN: f64 = 0.3;

impl Track {
    /// In degrees from the right, clockwise; `None` for one that has no move to make any
    /// more, unless its turns take time.
    pub(super) fn heading(&self, time: f64) -> Option<f64> {
        if time >= f64::from(self.last_stop()) && !self.faces_on {
            return None;
        }
        let last = self.headings.len().checked_sub(1)?;
        let step = (whole(time) as usize).min(last);
        let (now, then) = (self.headings[step], self.headings[(step + 1).min(last)]);
        let share = if self.faces_on {
            // It turns with the step.
            (time - step as f64).clamp(0.0, 1.0)
        } else {
            ((time - step as f64 - (1.0 - TURN)) / TURN).clamp(0.0, 1.0)
        };
        Some(now + around(now, then) * share)
    }

    /// The side to which an agent whose turns take time turns in a step in which it stays where it
    /// is, and where it will face then, in degrees.
    pub(super) fn turn(&self, step: usize) -> Option<(TurnSide, f64)> {
        let stays = |at: usize| {
            let cells = self.path.get(at).zip(self.path.get(at + 1));
            cells.is_some_and(|(one, other)| one.is_some() && one == other)
        };
        let by = |at: usize| {
            let headings = self.headings.get(at).zip(self.headings.get(at + 1))?;
            Some(around(*headings.0, *headings.1)).filter(|by| by.abs() > 1e-6)
        };
        if !self.faces_on {
            return None;
        }
        let turns = |at: &usize| stays(*at) && by(*at).is_some();
        let first = (0..=step).rev().take_while(turns).last()?;
        let last = (step..self.headings.len()).take_while(turns).last()?;
        let to = self.headings.get(last + 1)?;
        let whole: f64 = (first..=last).filter_map(by).sum();
        let side = if whole.abs() > 135.0 {
            TurnSide::Back
        } else if whole > 0.0 {
            TurnSide::Right
        } else {
            TurnSide::Left
        };
        Some((side, *to))
    }
}

/// From one direction to another by the shorter way round, in degrees.
fn around(from: f64, to: f64) -> f64 {
    (to - from + 540.0).rem_euclid(360.0) - 180.0
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
    fn one_whose_turns_take_time_turns_with_its_steps() {
        let facing = |headings: &[f64]| track("01112").facing(headings.to_vec());
        let right = facing(&[0.0, 0.0, 45.0, 90.0, 90.0]);
        let turn = |step| right.turn(step);
        let to = Some((TurnSide::Right, 90.0));
        assert_eq!([turn(0), turn(1), turn(2), turn(3)], [None, to, to, None]);
        assert_eq!(right.pose(1.5).unwrap().heading, Some(22.5));
        assert_eq!(right.pose(1.0).unwrap().turns_to, Some(90.0));
        let left = facing(&[0.0, 0.0, 0.0, -90.0, -90.0]);
        assert_eq!(left.turn(2), Some((TurnSide::Left, -90.0)));
        assert_eq!(left.turn(1), None, "it waits first");
        let back = facing(&[0.0, 0.0, -90.0, -180.0, -180.0]);
        assert_eq!(back.turn(1), Some((TurnSide::Back, -180.0)));
        // Where turns are free none takes a step.
        assert_eq!(track("0110").turn(1), None);
    }

    #[test]
    fn one_that_never_moves_looks_nowhere() {
        assert_eq!(track("33").pose(0.5).unwrap().heading, None);
        assert_eq!(track("").pose(0.0), None);
    }
}
