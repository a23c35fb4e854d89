//! What is known before a search is over.

use std::rc::Rc;

use giveway_model::{Version, check};
use giveway_solve::trace::SearchTrace;
use giveway_solve::{Ended, Progress, Reach, Reason, SolveAnswer, Stats, Status};

use crate::Solving;

impl Solving {
    /// Takes in what became known.
    pub(in crate::reduce) fn learn(&mut self, event: Progress) {
        match event {
            // It is proved under limits on the other costs, of one point of the front.
            Progress::Bound { .. } if self.request.pareto => {}
            Progress::Bound { cost, at_least } => {
                let bound = self.bounds.entry(cost).or_insert(at_least);
                *bound = at_least.max(*bound);
            }
            // Of a front it is the plan of one point.
            Progress::Plan { costs, plan } if !self.request.pareto => {
                self.best = Some(costs);
                self.plan = Some(Rc::new(plan));
            }
            Progress::Plan { costs, .. } => self.best = Some(costs),
            Progress::Traced { events } => {
                let objective = || self.draft.scene().objective.clone();
                let trace = self
                    .trace
                    .get_or_insert_with(|| Rc::new(SearchTrace::new(objective())));
                let trace = Rc::make_mut(trace);
                for event in events {
                    trace.push(event);
                }
            }
            Progress::Size { .. }
            | Progress::Explained { .. }
            | Progress::Freedom { .. }
            | Progress::Priced { .. }
            | Progress::Delays { .. }
            | Progress::Sized { .. }
            | Progress::Certifying { .. }
            | Progress::Exporting { .. } => {}
        }
    }

    /// What is known where a person stops the search; `None` where that is nothing.
    pub(super) fn stopped(&self) -> Option<SolveAnswer> {
        Some(SolveAnswer {
            ended: Some(Ended::Cancelled),
            reason: Some(Reason::StoppedByPerson),
            ..self.so_far()?
        })
    }

    /// What is known so far; `None` where that is nothing.
    pub(super) fn so_far(&self) -> Option<SolveAnswer> {
        let plan = self.plan.as_deref().filter(|plan| {
            let instance = self.draft.instance();
            instance.is_ok_and(|instance| check::check(instance, plan).violations.is_empty())
        });
        if plan.is_none() && self.bounds.is_empty() {
            return None;
        }
        Some(SolveAnswer {
            giveway: Version,
            status: match plan {
                Some(_) => Status::Feasible,
                None => Status::Unknown,
            },
            costs: self.best.filter(|_| plan.is_some()),
            bounds: self.bounds.clone(),
            reach: Reach::of_bounds_so_far(&self.request),
            ended: None,
            reason: None,
            plan: plan.cloned(),
            stats: Stats::default(),
            trace: self.trace.as_deref().cloned(),
        })
    }
}
