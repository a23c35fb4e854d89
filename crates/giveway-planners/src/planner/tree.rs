//! Conflict-based search behind the one door.

use super::{Asked, Best, Halt, Inability, Outcome, Report, Trace};
use crate::{
    budget::Budget,
    cbs::{CbsCost, Ended, search},
};

/// Plans by a constraint tree.
pub(super) fn cbs(asked: &Asked, mut best: Best, budget: &dyn Budget) -> Report {
    let aim = match CbsCost::of(asked.objective) {
        Ok(aim) => aim,
        Err(cost) => return Report::refused(Inability::Cost(cost)),
    };
    let horizon = asked.horizon();
    let searched = search(asked.problem, aim, horizon, asked.traced, budget);
    let stopped = |halt, bound| Outcome::Stopped {
        halt,
        walks: None,
        bound: Some(bound),
    };
    let outcome = match searched.ended {
        Ended::Best { walks, proved } => {
            best.offer(&walks);
            Outcome::Best { walks, proved }
        }
        Ended::Horizon { bound } => stopped(Halt::Horizon(horizon), bound),
        Ended::Stopped { stop, bound } => stopped(Halt::Budget(stop), bound),
    };
    Report {
        outcome,
        steps: searched.taken,
        trace: searched.tree.map(Trace::Cbs),
    }
}
