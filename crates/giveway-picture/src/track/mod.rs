//! One agent in time: its path, its battery, where it looks, when it is there.

mod heading;
mod pose;
#[cfg(test)]
mod tests;

use giveway_model::{AtGoal, Cell};

pub use pose::{Badge, Charge, Pose, TurnSide};

use crate::whole;
use heading::{headings, last_stop};

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
    /// Whether it faces somewhere after its last move, too.
    faces_on: bool,
    vanishes: bool,
    /// When it joins.
    from: u32,
    /// From when on it is gone, where it is removed.
    until: Option<u32>,
    /// Its breakdowns: it begins no move from the first time up to, not including, the
    /// second.
    breakdowns: Vec<(u32, u32)>,
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
            faces_on: false,
            vanishes: at_goal == AtGoal::Vanish,
            from: 0,
            until: None,
            breakdowns: Vec::new(),
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

    /// The same of an agent that turns in place: where it looks at each time, in
    /// degrees from the right, clockwise.
    #[must_use]
    pub fn turning(mut self, headings: Vec<f64>) -> Self {
        self.headings = headings;
        self
    }

    /// The same of an agent whose turns take time: where it faces at each time, in degrees from the
    /// right, clockwise. It faces somewhere after its last move and without a plan, too.
    #[must_use]
    pub fn facing(self, headings: Vec<f64>) -> Self {
        Self {
            headings,
            faces_on: true,
            ..self
        }
    }

    /// The same of an agent that breaks down: from the first of each two times up to, not
    /// including, the second.
    #[must_use]
    pub fn breaking_down(mut self, breakdowns: Vec<(u32, u32)>) -> Self {
        self.breakdowns = breakdowns;
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

    /// The time from which on it stays where it is, in steps.
    pub fn last_stop(&self) -> u32 {
        last_stop(&self.path)
    }

    /// Whether it waits anywhere before its arrival, and is not broken down then.
    pub fn has_waits(&self) -> bool {
        (self.from as usize..self.path.len()).any(|step| self.badge(step) == Some(Badge::Waits))
    }

    /// Whether it turns anywhere in a step of its own.
    pub fn has_turns(&self) -> bool {
        let badges = (self.from as usize..self.path.len()).filter_map(|step| self.badge(step));
        badges
            .into_iter()
            .any(|badge| matches!(badge, Badge::Turns(_)))
    }

    /// Whether it stands broken down at any time.
    pub fn has_breakdowns(&self) -> bool {
        let times = self.breakdowns.iter().flat_map(|&(from, to)| from..to);
        times
            .map(|time| self.badge(time as usize))
            .any(|badge| badge == Some(Badge::Broken))
    }
}
