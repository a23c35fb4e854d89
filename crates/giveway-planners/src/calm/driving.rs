//! How much a walk drives and waits: what calm plans have little of.

use std::ops::Add;

use crate::{problem::Problem, single::Place, walk::crossed};

/// How restless a walk is, or several walks together. The fields are in the order of
/// their weight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Driving {
    /// Steps in motion; a slow move takes two.
    pub motion: u32,
    /// Steps of waiting.
    pub waits: u32,
    /// Moves that take back the move before them, with or without a wait in between.
    pub turns: u32,
    /// How early the waits are: the sum of their steps up to a fixed late time.
    pub earliness: u64,
}

/// The time from which the earliness of waits is measured.
const LATE: u32 = 1 << 24;

impl Driving {
    /// The driving of one walk.
    pub fn of(problem: &Problem, walk: &[Place]) -> Self {
        let terrain = &problem.terrain;
        let mut driving = Self::default();
        let mut came_from = None;
        for (time, &place) in walk.iter().enumerate().take(walk.len().saturating_sub(1)) {
            match crossed(terrain, walk, time) {
                None if place == walk[time + 1] => driving = driving.and_wait(time as u32),
                None => driving = driving.and_step(false),
                Some(arc) => {
                    let begins = matches!(place, Place::At(_));
                    driving = driving.and_step(begins && came_from == Some(arc.to));
                    came_from = Some(terrain.ends(arc.id).0);
                }
            }
        }
        driving
    }

    /// The driving of several walks together.
    pub fn of_all(problem: &Problem, walks: &[Vec<Place>]) -> Self {
        let each = walks.iter().map(|walk| Self::of(problem, walk));
        each.fold(Self::default(), Add::add)
    }

    /// With a wait that begins at a time.
    pub(super) const fn and_wait(self, time: u32) -> Self {
        Self {
            waits: self.waits + 1,
            earliness: self.earliness + LATE.saturating_sub(time) as u64,
            ..self
        }
    }

    /// With a step in motion, which may begin a turn back.
    pub(super) const fn and_step(self, turns: bool) -> Self {
        Self {
            motion: self.motion + 1,
            turns: self.turns + turns as u32,
            ..self
        }
    }
}

impl Add for Driving {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            motion: self.motion + other.motion,
            waits: self.waits + other.waits,
            turns: self.turns + other.turns,
            earliness: self.earliness + other.earliness,
        }
    }
}
