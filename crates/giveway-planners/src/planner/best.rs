//! The best plan so far, told as soon as there is a better one.

use super::Asked;
use crate::walk::{Walk, costs};

/// The best plan so far by the objective, none longer than a person allowed.
pub(super) struct Best<'a, 'p> {
    asked: &'a Asked<'p>,
    on_better: &'a mut dyn FnMut(&[Walk]),
    /// Its costs, and its walks.
    plan: Option<(Vec<u32>, Vec<Walk>)>,
}

impl<'a, 'p> Best<'a, 'p> {
    pub(super) fn new(asked: &'a Asked<'p>, on_better: &'a mut dyn FnMut(&[Walk])) -> Self {
        Self {
            asked,
            on_better,
            plan: None,
        }
    }

    /// Keeps a plan that is better.
    pub(super) fn offer(&mut self, walks: &[Walk]) {
        let costs = costs(self.asked.problem, walks);
        let vector = costs.vector(self.asked.objective);
        let is_better = self.plan.as_ref().is_none_or(|(best, _)| vector < *best);
        if is_better
            && self
                .asked
                .within
                .is_none_or(|within| costs.makespan <= within)
        {
            (self.on_better)(walks);
            self.plan = Some((vector, walks.to_vec()));
        }
    }

    /// The walks of the best plan.
    pub(super) fn walks(self) -> Option<Vec<Walk>> {
        self.plan.map(|(_, walks)| walks)
    }
}
