//! Any plan at all, or the proof that there is none within the horizon.

use super::stage::Search;
use crate::{encode::collisions::AgentId, meter::Stop, sat::Outcome};

/// Looks for any plan; where there is none within the horizon, the agents that
/// cannot all arrive within it.
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
