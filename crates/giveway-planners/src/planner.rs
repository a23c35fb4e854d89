//! The one door to all planners: what is asked, and how it ended.
//!
//! Each planner promises something else. The types keep the promises apart: only
//! conflict-based search can say that a plan is best or prove a bound, none can
//! say that there is no plan, and what a method cannot do it refuses by name.

mod ability;
mod name;
mod report;
#[cfg(test)]
mod tests;

pub use ability::Inability;
pub use name::{Planner, UnknownPlanner};
pub use report::{Halt, Outcome, Report, Trace};

use giveway_model::Objective;

use crate::{
    budget::Budget,
    cbs,
    prioritised::{self, Order, prioritised},
    problem::Problem,
    walk::Walk,
};

/// What a planner is asked.
pub struct Asked<'a> {
    /// The instance.
    pub problem: &'a Problem,
    /// What makes one plan better than another.
    pub objective: &'a Objective,
    /// No walk is longer.
    pub horizon: u32,
    /// The order of prioritised planning.
    pub order: Order,
    /// Whether a trace is wanted.
    pub traced: bool,
}

/// Plans with a planner; `on_better` gets each plan that is better than those
/// before it, the last of them the plan of the report.
pub fn plan(
    planner: Planner,
    asked: &Asked,
    on_better: &mut dyn FnMut(&[Walk]),
    budget: &dyn Budget,
) -> Report {
    let cannot = ability::lacks(planner, asked);
    if !cannot.is_empty() {
        return Report::refused(cannot);
    }
    match planner {
        Planner::Prioritised => by_priority(asked, on_better, budget),
        Planner::Cbs => by_conflicts(asked, on_better, budget),
        Planner::Pibt | Planner::Lacam | Planner::Lns => {
            Report::refused(vec![Inability::NotThereYet])
        }
    }
}

fn by_priority(asked: &Asked, on_better: &mut dyn FnMut(&[Walk]), budget: &dyn Budget) -> Report {
    let (problem, order) = (asked.problem, &asked.order);
    let planned = prioritised(problem, order, asked.horizon, asked.traced, budget);
    let outcome = match planned.ended {
        prioritised::Ended::Found(walks) => {
            on_better(&walks);
            Outcome::Found { walks }
        }
        prioritised::Ended::NoOrderWorks(stuck) => Outcome::NoOrderWorks {
            tried: planned.tried,
            stuck,
        },
        prioritised::Ended::Stopped(stop) => Outcome::Stopped {
            halt: Halt::Budget(stop),
            walks: None,
            bound: None,
        },
    };
    Report {
        outcome,
        steps: u64::from(planned.tried),
        trace: planned.attempts.map(Trace::Prioritised),
    }
}

fn by_conflicts(asked: &Asked, on_better: &mut dyn FnMut(&[Walk]), budget: &dyn Budget) -> Report {
    let aim = match cbs::Aim::of(asked.objective) {
        Ok(aim) => aim,
        Err(cost) => return Report::refused(vec![Inability::Cost(cost)]),
    };
    let searched = cbs::search(asked.problem, aim, asked.horizon, asked.traced, budget);
    let outcome = match searched.ended {
        cbs::Ended::Best { walks, proved } => {
            on_better(&walks);
            Outcome::Best { walks, proved }
        }
        cbs::Ended::Horizon { bound } => Outcome::Stopped {
            halt: Halt::Horizon(asked.horizon),
            walks: None,
            bound: Some(bound),
        },
        cbs::Ended::Stopped { stop, bound } => Outcome::Stopped {
            halt: Halt::Budget(stop),
            walks: None,
            bound: Some(bound),
        },
    };
    Report {
        outcome,
        steps: searched.taken,
        trace: searched.tree.map(Trace::Cbs),
    }
}
