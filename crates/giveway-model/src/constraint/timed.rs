//! A constraint while a plan runs: since when it is there, and until when.

use super::Constraint;
use crate::condition::Times;

/// A constraint over time.
///
/// It is judged from the time at which a change added it, and before the time at which one
/// removed it: a violation of another time is none. What must be done at some time
/// (`sequence`, `visit`) is judged at the arrival, or when the constraint was added, whichever
/// is later. Where a change removed the constraint, what was not done yet is no violation,
/// nor is an arrival that was too early: an agent that is still there could have gone on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TimedConstraint {
    /// The constraint.
    pub constraint: Constraint,
    /// The time at which a change added it; `None` for one of the scene.
    pub since: Option<u32>,
    /// The time from which on it is gone, where a change removed it.
    pub until: Option<u32>,
}

impl TimedConstraint {
    /// A constraint of the scene.
    pub const fn of_scene(constraint: Constraint) -> Self {
        Self {
            constraint,
            since: None,
            until: None,
        }
    }

    /// Whether it is there at a time, in force or not.
    pub fn is_there(&self, time: u32) -> bool {
        self.span().is_some_and(|span| span.contains(time))
    }

    /// The times at which it is there; `None` where there is none.
    pub fn span(&self) -> Option<Times> {
        let last = match self.until {
            Some(until) => Some(until.checked_sub(1)?),
            None => None,
        };
        let span = Times {
            from: self.since,
            to: last,
        };
        (span.first() <= span.last()).then_some(span)
    }
}
