//! Rules that do not count for some agents, so that one can see what follows from
//! the others alone; and what agents have behind them.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Cell;

/// Rules left out, and what is behind the agents at time 0, by their names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Leniency {
    /// Pairs that may be at one place and pass through each other.
    pub ignoring: BTreeSet<(String, String)>,
    /// Agents that vanish on arrival, whatever the rule for the others.
    pub gone: BTreeSet<String>,
    /// Agents that have broken down, and the times before which they begin no
    /// move: the one rule that an instance does not have by itself.
    pub held: BTreeMap<String, u32>,
    /// Agents that are half way along a slow move at time 0, and the cells that they left.
    pub transit: BTreeMap<String, Cell>,
    /// Wait steps that agents made just before time 0 and that count for a question.
    pub waited: BTreeMap<String, u32>,
}
