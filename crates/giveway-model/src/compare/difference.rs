//! The difference of one agent from one plan to another.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::Cell;

/// An agent's entries and charges in a plan, from some time on.
type Part<'a> = (&'a [Option<Cell>], &'a [u32]);

/// The difference of an agent. The one definition, for plans compared and for plans that go on after a
/// change.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Difference {
    /// The same cells and charges at the same times.
    Same,
    /// The same sequence of cells at other times, or other charges on the way.
    Retimed,
    /// Other cells.
    Rerouted,
}

impl Difference {
    /// Compares an agent's part in two plans.
    pub fn between(old: Part<'_>, new: Part<'_>) -> Self {
        if old == new {
            Self::Same
        } else if cells(old.0).eq(cells(new.0)) {
            Self::Retimed
        } else {
            Self::Rerouted
        }
    }
}

/// The cells of a path, each once for each stay.
fn cells(path: &[Option<Cell>]) -> impl Iterator<Item = Cell> {
    let mut last = None;
    let there = path.iter().copied().flatten();
    there.filter(move |&cell| last.replace(cell) != Some(cell))
}

/// The first time at which an agent is not at the same place in two plans, or
/// charges in one of them only.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Divergence {
    /// The time.
    pub time: u32,
    /// Where it is in each; `null` in transit, where it is gone, and without a path.
    pub cells: [Option<Cell>; 2],
}

/// Where an agent's parts in two plans differ first; `None` where they do not.
/// `stays` tells whether it stays at its goal.
pub fn divergence(one: Part<'_>, other: Part<'_>, stays: bool) -> Option<Divergence> {
    let at = |(path, _): Part<'_>, time: usize| match path.get(time) {
        Some(cell) => *cell,
        None if stays => path.last().copied().flatten(),
        None => None,
    };
    let longest = one.0.len().max(other.0.len());
    let moved = (0..longest).find(|&time| {
        let is_over = |part: Part<'_>| !stays && time >= part.0.len();
        at(one, time) != at(other, time) || is_over(one) != is_over(other)
    });
    let charged = one
        .1
        .iter()
        .chain(other.1)
        .copied()
        .filter(|time| one.1.contains(time) != other.1.contains(time));
    let charged = charged.min().map(|time| time as usize);
    let time = moved.into_iter().chain(charged).min()?;
    Some(Divergence {
        time: time as u32,
        cells: [at(one, time), at(other, time)],
    })
}
