//! An agent at a time that need not be whole: where it is, what it does, how full its
//! battery is.

use giveway_model::Cell;

use super::Track;
use crate::{Point, position, whole};

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
    /// Where it will face, in degrees, while it turns in a step of its own.
    pub turns_to: Option<f64>,
    /// What it does, where its motion does not show it.
    pub badge: Option<Badge>,
    /// Both ends of the slow move that it is on.
    pub transit: Option<(Cell, Cell)>,
    /// Whether it left the map.
    pub is_gone: bool,
    /// How far it makes way for another one on its cell, in cells to the right, and
    /// how large it is drawn then; nothing where it is alone.
    pub aside: Option<(f64, f64)>,
}

impl Pose {
    /// Whether another plan has the agent at another place at this time.
    pub fn is_elsewhere(&self, other: &Self) -> bool {
        // A smaller distance cannot be seen.
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
    /// The class in the style sheet: `ok`, `mid` from 40 % down, `low` from 20 %.
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
    /// It turns, in a step of its own.
    Turns(TurnSide),
    /// It is broken down.
    Broken,
}

/// The side to which an agent turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TurnSide {
    /// To the left.
    Left,
    /// To the right.
    Right,
    /// Half a turn.
    Back,
}

impl TurnSide {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Left, Self::Right, Self::Back];

    /// The arrow of a turn, around (0, 0).
    pub const fn arrow(self) -> &'static str {
        match self {
            Self::Left => "M6.5 8V1.5A5 5 0 0 0 1.5-3.5H-7M-2.5-8-7-3.5-2.5 1",
            Self::Right => "M-6.5 8V1.5A5 5 0 0 1-1.5-3.5H7M2.5-8 7-3.5 2.5 1",
            Self::Back => "M-5.5 8V-2A5 5 0 0 1 4.5-2V7M.5 3 4.5 7 8.5 3",
        }
    }
}

impl Track {
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
            turns_to: self.turn(step).map(|(_, to)| to),
            charge: self.charge(time),
            badge: self.badge(step),
            transit: self.transit(step, time),
            is_gone: has_left || is_removed || is_early,
            aside: None,
        })
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

    pub(super) fn badge(&self, step: usize) -> Option<Badge> {
        if self.charges.binary_search(&(step as u32)).is_ok() {
            return Some(Badge::Charges);
        }
        let is_broken = self.breakdowns.iter().any(|&(from, to)| {
            let time = step as u32;
            from <= time && time < to
        });
        // At its goal its path has come to an end; in transit it is on no cell.
        let here = self
            .path
            .get(step)
            .or(self.path.last())
            .copied()
            .flatten()?;
        if is_broken {
            return Some(Badge::Broken);
        }
        let waits = Some(here) == *self.path.get(step + 1)?;
        let turns = self.turn(step).map(|(side, _)| Badge::Turns(side));
        waits.then(|| turns.unwrap_or(Badge::Waits))
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

#[cfg(test)]
mod tests {
    use super::Charge;

    #[test]
    fn levels_that_warn() {
        let class = |share| Charge { share }.class();
        assert_eq!(
            [class(0.41), class(0.4), class(0.2), class(0.0)],
            ["ok", "mid", "low", "low"]
        );
    }
}
