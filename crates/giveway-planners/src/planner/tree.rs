//! Conflict-based search behind the one door, and its tree by hand.

use super::{Asked, Best, Halt, Inability, Outcome, Planner, Report, Trace, ability};
use crate::{
    budget::{Budget, Stop},
    cbs::{
        CbsCost, Ended, LowerBound,
        by_hand::{Hand, Standing},
        search,
    },
};

/// Plans by a constraint tree.
pub(super) fn cbs(asked: &Asked, mut best: Best, budget: &dyn Budget) -> Report {
    let aim = match CbsCost::of(asked.objective) {
        Ok(aim) => aim,
        Err(cost) => return Report::refused(Inability::Cost(cost)),
    };
    let horizon = asked.horizon();
    let searched = search(asked.problem, aim, horizon, asked.traced, budget);
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

/// Begins CBS by hand: the root of its tree.
///
/// # Errors
/// Where CBS cannot do this, or the budget is spent: how the planner ended.
pub fn by_hand<'p>(asked: &Asked<'p>, budget: &dyn Budget) -> Result<Hand<'p>, Outcome> {
    if let Some(lack) = ability::lack(Planner::Cbs, asked.problem) {
        return Err(Outcome::Refused { lack });
    }
    let aim = CbsCost::of(asked.objective).map_err(|cost| Outcome::Refused {
        lack: Inability::Cost(cost),
    })?;
    Hand::new(asked.problem, aim, asked.horizon(), budget).map_err(|stop| Outcome::Stopped {
        halt: Halt::Budget(stop),
        walks: None,
        bound: None,
    })
}

/// A tree by hand ends where the person leaves it.
const UNFINISHED: Halt = Halt::Budget(Stop::Cancelled);

/// How far a tree by hand is, as the end of a planner: a plan is best once it is proved, and
/// the best so far until then.
pub fn so_far(hand: &Hand) -> Outcome {
    let walks = || hand.plan().and_then(|plan| hand.walks(plan));
    match hand.standing() {
        Standing::Proved { proved, .. } => Outcome::Best {
            walks: walks().unwrap_or_default(),
            proved,
        },
        Standing::Found { bound, .. } => Outcome::Stopped {
            halt: UNFINISHED,
            walks: walks(),
            bound: Some(bound),
        },
        Standing::NotYet { bound } => stopped(UNFINISHED, bound),
        Standing::Exhausted { bound } => stopped(Halt::Horizon(hand.horizon()), bound),
    }
}

const fn stopped(halt: Halt, bound: LowerBound) -> Outcome {
    Outcome::Stopped {
        halt,
        walks: None,
        bound: Some(bound),
    }
}
