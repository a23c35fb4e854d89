//! A split by hand: what is chosen, what it would make, why it cannot be made.

use crate::{
    budget::Stop,
    cbs::{Constraint, Party},
};

/// What a person splits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The node, by its number.
    pub node: usize,
    /// Which of its conflicts, by time, from 0.
    pub conflict: usize,
    /// The agent of that conflict that both branches name.
    pub party: Party,
}

/// A branch before it is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// Its own constraint.
    pub constraint: Constraint,
    /// The cost of its walks; `None` where some agent has none: a dead end.
    pub cost: Option<u32>,
    /// How many conflicts its walks have.
    pub conflicts: usize,
}

/// Why a node was not split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandError {
    /// There is no open node of this number.
    NotOpen,
    /// It has no such conflict.
    NoConflict {
        /// How many it has.
        of: usize,
    },
    /// There are as many splits as there may be.
    Full,
    /// The budget is spent.
    Stopped(Stop),
}

impl From<Stop> for HandError {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}
