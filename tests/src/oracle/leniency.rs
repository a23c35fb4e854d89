//! Rules that do not count for some agents, so that one can see what follows from
//! the others alone.

use std::collections::BTreeSet;

/// Rules left out, by the names of agents.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Leniency {
    /// Pairs that may be at one place and pass through each other.
    pub ignoring: BTreeSet<(String, String)>,
    /// Agents that vanish on arrival, whatever the rule for the others.
    pub gone: BTreeSet<String>,
}
