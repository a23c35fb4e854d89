//! The least makespan: from below, one step at a time.
//!
//! Diagrams begin at each agent's own optimum. A core names agents that cannot
//! all keep their deadlines: those below the makespan under trial get twice the
//! delay; a core whose agents all may use the whole time proves that the
//! makespan is larger.

use giveway_model::Cost;

use super::{
    bound::Bound,
    growing::{Growing, Until},
    stage::{End, Search},
};
use crate::budget::Stop;

/// Minimises the makespan.
///
/// # Errors
/// When the budget is spent. `bound` holds what was proved up to then.
pub(super) fn run(search: &mut Search, bound: &mut Bound) -> Result<End, Stop> {
    search.report_bound(*bound);
    search.claim.begin(Cost::Makespan, false);
    search.tell_phase(Cost::Makespan)?;
    loop {
        let trial = bound.at_least();
        if let Some(optimum) = bound.met(search) {
            for agent in 0..search.problem.agents() {
                search.lower_cap(agent, trial);
            }
            return Ok(End::Least(optimum));
        }
        match search.solve_growing(Vec::new(), Until::Time(trial))? {
            Growing::Model => {
                let entered = search.settle()?;
                if entered.is_empty() && bound.met(search).is_none() {
                    return Err(Stop::Contradiction);
                }
            }
            Growing::Grown(_) => search.polish(Cost::Makespan, trial)?,
            Growing::Core(core) if core.lits().is_empty() => return Ok(End::None),
            Growing::Core(core) => {
                search.tell_too_late(&core, trial);
                bound.raise(core.lits());
                search.report_bound(*bound);
                search.polish(Cost::Makespan, bound.at_least())?;
            }
        }
    }
}
