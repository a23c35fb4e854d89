//! One agent in time: where it is, where it looks, how full its battery is.

use giveway_model::{AtGoal, Cell};

use super::whole;
use crate::{Point, position};

/// The part of a step in which an agent turns to its next move, at its end: at
/// a whole time it already looks where it goes next.
const TURN: f64 = 0.3;

/// What an agent does from time 0 on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track {
    path: Vec<Option<Cell>>,
    charges: Vec<u32>,
    /// Levels by time, and the capacity.
    battery: Option<(Vec<i64>, u32)>,
    /// By time, in degrees from the right, clockwise; empty for one that never
    /// moves.
    headings: Vec<f64>,
    vanishes: bool,
    /// When it joins.
    from: u32,
    /// From when on it is gone, where it is removed.
    until: Option<u32>,
}

/// An agent at a time that need not be whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where, in cells.
    pub at: Point,
    /// Where it looks, in degrees from the right, clockwise; `None` without a
    /// move to make.
    pub heading: Option<f64>,
    /// Its battery; `None` without one.
    pub charge: Option<Charge>,
    /// What it does, where that is not to be seen from its motion.
    pub badge: Option<Badge>,
    /// Both ends of the slow move that it is on.
    pub transit: Option<(Cell, Cell)>,
    /// Whether it left the map.
    pub is_gone: bool,
}

impl Pose {
    /// Whether another plan has the agent at another place at this time.
    pub fn is_elsewhere(&self, other: &Self) -> bool {
        // Less is not to be seen.
        const APART: f64 = 0.01;
        let is_apart = |a: f64, b: f64| (a - b).abs() > APART;
        is_apart(self.at.x, other.at.x)
            || is_apart(self.at.y, other.at.y)
            || self.is_gone != other.is_gone
    }
}

/// How full a battery is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charge {
    /// The share of the capacity, 0 to 1.
    pub share: f64,
}

impl Charge {
    /// How that is to be taken: `ok`, `mid` from 40 % down, `low` from 20 %.
    pub fn class(self) -> &'static str {
        match self.share {
            ..=0.2 => "low",
            ..=0.4 => "mid",
            _ => "ok",
        }
    }
}

/// What an agent does without moving.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Badge {
    /// It charges.
    Charges,
    /// It waits.
    Waits,
}

impl Track {
    /// The track of a path from time 0, with charges at some times, levels and
    /// capacity of a battery, and what becomes of an agent at its goal.
    pub fn new(
        path: Vec<Option<Cell>>,
        charges: Vec<u32>,
        battery: Option<(Vec<i64>, u32)>,
        at_goal: AtGoal,
    ) -> Self {
        let headings = headings(&path);
        Self {
            path,
            charges,
            battery,
            headings,
            vanishes: at_goal == AtGoal::Vanish,
            from: 0,
            until: None,
        }
    }

    /// The same of an agent that joins at a time, where its path begins, and is
    /// gone from another on.
    #[must_use]
    pub fn between(mut self, from: u32, until: Option<u32>) -> Self {
        self.until = until;
        self.from = from;
        let late = from as usize;
        let first = self.path.first().copied().flatten();
        if late > 0 && first.is_some() {
            // Before it joins it is nowhere; its path then stands still.
            self.path.splice(0..0, std::iter::repeat_n(first, late));
            if let Some((levels, _)) = &mut self.battery
                && let Some(&level) = levels.first()
            {
                levels.splice(0..0, std::iter::repeat_n(level, late));
            }
            self.headings = headings(&self.path);
        }
        self
    }

    /// The cells by time.
    pub fn path(&self) -> &[Option<Cell>] {
        &self.path
    }

    /// The arrival, in steps.
    pub fn arrival(&self) -> u32 {
        self.path.len().saturating_sub(1) as u32
    }

    /// The agent at a time; `None` without a path.
    pub fn pose(&self, time: f64) -> Option<Pose> {
        let step = whole(time) as usize;
        // The part of the path around the time, so that long plans cost no more.
        let first = (0..=step.min(self.path.len().checked_sub(1)?))
            .rev()
            .find(|&t| self.path[t].is_some())?;
        let near = &self.path[first..self.path.len().min(step + 3)];
        let at = position(near, time - first as f64)?;
        let has_left = self.vanishes && time > f64::from(self.arrival());
        let is_removed = self.until.is_some_and(|until| time >= f64::from(until));
        let is_early = time < f64::from(self.from);
        Some(Pose {
            at,
            heading: self.heading(time),
            charge: self.charge(time),
            badge: self.badge(step),
            transit: self.transit(step, time),
            is_gone: has_left || is_removed || is_early,
        })
    }

    /// The cell that it is on at a whole time; in transit both.
    pub fn cells_at(&self, time: u32) -> Vec<Cell> {
        let Some(pose) = self.pose(f64::from(time)).filter(|pose| !pose.is_gone) else {
            return Vec::new();
        };
        match pose.transit {
            Some((from, to)) => vec![from, to],
            None => vec![Cell::new(whole(pose.at.x), whole(pose.at.y))],
        }
    }

    /// Whether it waits anywhere before its arrival.
    pub fn has_waits(&self) -> bool {
        (self.from as usize..self.path.len()).any(|step| self.badge(step) == Some(Badge::Waits))
    }

    fn heading(&self, time: f64) -> Option<f64> {
        let last = self.headings.len().checked_sub(1)?;
        let step = (whole(time) as usize).min(last);
        let (now, then) = (self.headings[step], self.headings[(step + 1).min(last)]);
        let share = ((time - step as f64 - (1.0 - TURN)) / TURN).clamp(0.0, 1.0);
        // The shorter way round.
        let turn = (then - now + 540.0).rem_euclid(360.0) - 180.0;
        Some(now + turn * share)
    }

    fn charge(&self, time: f64) -> Option<Charge> {
        let (levels, capacity) = self.battery.as_ref()?;
        let last = levels.len().checked_sub(1)?;
        let step = (whole(time) as usize).min(last);
        let (now, then) = (levels[step] as f64, levels[(step + 1).min(last)] as f64);
        let level = now + (then - now) * (time - step as f64).clamp(0.0, 1.0);
        let share = level / f64::from((*capacity).max(1));
        Some(Charge {
            share: share.clamp(0.0, 1.0),
        })
    }

    fn badge(&self, step: usize) -> Option<Badge> {
        if self.charges.binary_search(&(step as u32)).is_ok() {
            return Some(Badge::Charges);
        }
        let stays = self.path.get(step).copied().flatten() == *self.path.get(step + 1)?;
        (stays && self.path[step].is_some()).then_some(Badge::Waits)
    }

    fn transit(&self, step: usize, time: f64) -> Option<(Cell, Cell)> {
        let cell = |time: usize| self.path.get(time).copied().flatten();
        let half = match self.path.get(step)? {
            None => step,
            // On its way since a moment: a slow move shows in transit next.
            Some(_) if time > step as f64 && self.path.get(step + 1) == Some(&None) => step + 1,
            Some(_) => return None,
        };
        Some((cell(half.checked_sub(1)?)?, cell(half + 1)?))
    }
}

/// Where it looks at each time: at the next move, after the last at that.
fn headings(path: &[Option<Cell>]) -> Vec<f64> {
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
    let dx = f64::from(to.x) - f64::from(from.x);
    let dy = f64::from(to.y) - f64::from(from.y);
    dy.atan2(dx).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A path in one row, `-` in transit.
    fn path(row: &str) -> Vec<Option<Cell>> {
        let cell = |c: char| c.to_digit(10).map(|x| Cell::new(x, 0));
        row.chars().map(cell).collect()
    }

    fn track(row: &str) -> Track {
        Track::new(path(row), Vec::new(), None, AtGoal::Stay)
    }

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
        assert_eq!(heading(9.0), 180.0);
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

    #[test]
    fn the_ring_goes_down_and_up_evenly() {
        let battery = Some((vec![5, 4, 10], 10));
        let track = Track::new(path("011"), vec![1], battery, AtGoal::Stay);
        let share = |time| track.pose(time).unwrap().charge.unwrap().share;
        assert_eq!((share(0.0), share(0.5), share(1.5)), (0.5, 0.45, 0.7));
        assert_eq!(share(7.0), 1.0);
    }

    #[test]
    fn levels_that_warn() {
        let class = |share| Charge { share }.class();
        assert_eq!(
            [class(0.41), class(0.4), class(0.2), class(0.0)],
            ["ok", "mid", "low", "low"]
        );
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
        assert!(!super::tests::track("01-2").has_waits());
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
}
