//! The least makespan: from below, one step at a time.
//!
//! Diagrams begin at each agent's own optimum. A core names agents that cannot
//! all keep their deadlines: those below the makespan under trial get twice the
//! delay; a core whose agents all may use the whole time proves that the
//! makespan is larger.

use giveway_model::Cost;

use super::{
    growing::{Growing, Until},
    stage::{End, Search},
};
use crate::budget::Stop;

/// Minimises the makespan.
///
/// # Errors
/// When the budget is spent. `bound` holds what was proved up to then.
pub(crate) fn run(search: &mut Search, bound: &mut u32) -> Result<End, Stop> {
    let mut trial = search.problem.optima.iter().copied().max().unwrap_or(0);
    *bound = trial;
    search.report_bound(Cost::Makespan, trial);
    search.begin(Cost::Makespan);
    search.tell_phase(Cost::Makespan)?;
    search.minimise_cores(false);
    loop {
        if search.incumbent_meets(Cost::Makespan, trial) {
            for agent in 0..search.problem.agents() {
                search.lower_cap(agent, trial);
            }
            return Ok(End::Least(trial));
        }
        match search.solve_growing(Vec::new(), Until::Time(trial))? {
            Growing::Model => {
                let entered = search.settle()?;
                if entered.is_empty() && !search.incumbent_meets(Cost::Makespan, trial) {
                    return Err(Stop::Contradiction);
                }
            }
            Growing::Grown(_) => search.polish(Cost::Makespan, trial)?,
            Growing::Core(core) if core.lits().is_empty() => return Ok(End::None),
            Growing::Core(core) => {
                search.tell_too_late(&core, trial);
                trial += 1;
                *bound = trial;
                search.report_bound(Cost::Makespan, trial);
                search.polish(Cost::Makespan, trial)?;
            }
        }
    }
}
