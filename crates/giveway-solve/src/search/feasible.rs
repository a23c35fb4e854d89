//! Any plan at all, or the proof that there is none.
//!
//! Deadlines stay assumptions here ([`Keeping::Assumed`](super::deadlines::Keeping)),
//! up to the horizon. A core of deadlines that
//! cannot grow any more names agents that cannot all arrive within it; a core
//! without any shows that no deadline would help.

use super::{
    growing::{AssumptionCore, Growing, Until},
    stage::Search,
};
use crate::budget::Stop;

/// Looks for any plan; where there is none, the core of deadlines: the agents that
/// cannot all arrive within the horizon, none named where they cannot at any.
///
/// # Errors
/// When the budget is spent.
pub(crate) fn run(search: &mut Search) -> Result<Option<AssumptionCore>, Stop> {
    loop {
        match search.solve_growing(Vec::new(), Until::EVER)? {
            Growing::Model => {
                if search.settle()?.is_empty() {
                    return Ok(None);
                }
            }
            Growing::Grown(_) => {}
            Growing::Core(core) => return Ok(Some(core)),
        }
    }
}
