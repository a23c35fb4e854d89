//! Any plan at all, or the proof that there is none.
//!
//! Deadlines stay assumptions here, up to the horizon. A core of deadlines that
//! cannot grow any more names agents that cannot all arrive within it; a core
//! without any shows that no deadline would help.

use super::stage::Search;
use crate::{encode::collisions::AgentId, meter::Stop, sat::Outcome};

/// Looks for any plan; where there is none, the agents that cannot all arrive
/// within the horizon, none named where they cannot at any horizon.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn run(search: &mut Search) -> Result<Option<Vec<AgentId>>, Stop> {
    search.hard_caps = false;
    loop {
        let guards = search.guards();
        let assumptions: Vec<_> = guards.keys().copied().collect();
        match search.team.solve(&assumptions)? {
            Outcome::Sat => {
                if search.settle()?.is_empty() {
                    return Ok(None);
                }
            }
            Outcome::Unsat(core) => {
                let agents: Vec<AgentId> = core
                    .iter()
                    .filter_map(|lit| guards.get(lit).copied())
                    .collect();
                let mut grown = false;
                for &agent in &agents {
                    grown |= search.grow_further(agent, u32::MAX)?;
                }
                if !grown {
                    return Ok(Some(agents));
                }
            }
        }
    }
}
