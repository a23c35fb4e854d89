//! The least makespan: from below, one step at a time.
//!
//! Diagrams begin at each agent's own optimum. A core names agents that cannot
//! all keep their deadlines: those below the makespan under trial get twice the
//! delay; a core whose agents all may use the whole time proves that the
//! makespan is larger.

use std::collections::BTreeMap;

use giveway_model::Cost;

use super::stage::{End, Search};
use crate::{
    encode::collisions::AgentId,
    meter::Stop,
    sat::{Lit, Outcome},
};

/// Minimises the makespan.
///
/// # Errors
/// When the budget is spent. `bound` holds what was proved up to then.
pub(crate) fn run(search: &mut Search, bound: &mut u32) -> Result<End, Stop> {
    let mut trial = search.problem.optima.iter().copied().max().unwrap_or(0);
    *bound = trial;
    search.report_bound(Cost::Makespan, trial);
    search.begin(Cost::Makespan);
    loop {
        if search.incumbent_meets(Cost::Makespan, trial) {
            for agent in 0..search.problem.agents() {
                search.lower_cap(agent, trial);
            }
            return Ok(End::Least(trial));
        }
        let deadlines = deadlines(search, trial);
        let assumptions: Vec<Lit> = deadlines.keys().copied().collect();
        match search.team.solve(&assumptions)? {
            Outcome::Sat => {
                let entered = search.settle()?;
                if entered.is_empty() && !search.incumbent_meets(Cost::Makespan, trial) {
                    return Err(Stop::Contradiction);
                }
            }
            Outcome::Unsat(core) if core.is_empty() => return Ok(End::None),
            Outcome::Unsat(core) => {
                let mut grown = false;
                for agent in core.iter().filter_map(|lit| deadlines.get(lit)) {
                    grown |= search.grow_further(*agent, trial)?;
                }
                if !grown {
                    trial += 1;
                    *bound = trial;
                    search.report_bound(Cost::Makespan, trial);
                }
            }
        }
    }
}

/// Each inside agent arrives by the makespan under trial, or by what its
/// diagram covers so far.
fn deadlines(search: &mut Search, trial: u32) -> BTreeMap<Lit, AgentId> {
    let mut deadlines = BTreeMap::new();
    for agent in search.team.insiders() {
        let covered = search.team.deadline(agent);
        let latest = covered.min(trial);
        // At its cap the deadline is a clause.
        if latest < search.cap(agent)
            && let Some(by) = search.team.by(agent, latest)
        {
            deadlines.insert(by, agent);
        }
    }
    deadlines
}
