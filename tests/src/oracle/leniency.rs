//! Rules that do not count for some agents, so that one can see what follows from
//! the others alone; and breakdowns.

use std::collections::{BTreeMap, BTreeSet};

/// Rules left out, and breakdowns, by the names of agents.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Leniency {
    /// Pairs that may be at one place and pass through each other.
    pub ignoring: BTreeSet<(String, String)>,
    /// Agents that vanish on arrival, whatever the rule for the others.
    pub gone: BTreeSet<String>,
    /// Agents that have broken down, and the times before which they begin no
    /// move: the one rule that an instance does not have by itself.
    pub held: BTreeMap<String, u32>,
}
