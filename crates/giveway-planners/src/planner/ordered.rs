//! Prioritised planning behind the one door.

use super::{Asked, Best, Halt, Outcome, Report, Trace};
use crate::{
    budget::Budget,
    prioritised::{self, Ended},
};

/// Plans in an order.
pub(super) fn prioritised(asked: &Asked, mut best: Best, budget: &dyn Budget) -> Report {
    let (problem, order) = (asked.problem, &asked.order);
    let planned = prioritised::prioritised(problem, order, asked.horizon(), asked.traced, budget);
    let outcome = match planned.ended {
        Ended::Found(walks) => {
            best.offer(&walks);
            Outcome::Found { walks }
        }
        Ended::NoOrderWorks(stuck) => Outcome::NoOrderWorks {
            tried: planned.tried,
            within: asked.horizon(),
            stuck,
        },
        Ended::Stopped(stop) => Outcome::stopped(Halt::Budget(stop), best),
    };
    Report {
        outcome,
        steps: u64::from(planned.tried),
        trace: planned.attempts.map(Trace::Prioritised),
    }
}
