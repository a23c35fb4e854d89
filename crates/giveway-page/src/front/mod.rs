//! A Pareto front: the plans of which none is better in one cost without being
//! worse in another. Each of them is a plan to show.

mod plot;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Objective, Version, tr, words::values};
use giveway_solve::{FrontAnswer, SolveAnswer, SolveRequest, Stats, Status};

use crate::{Answer, Draft};

pub use plot::Plot;

/// The numbers of costs that have a front.
const COSTS: std::ops::RangeInclusive<usize> = 2..=3;

/// The front of a draft, as far as it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Front {
    /// The draft that was solved.
    pub draft: Rc<Draft>,
    /// The plans, in the order of the first cost.
    pub points: Vec<Rc<Answer>>,
    /// What is known of the front as a whole.
    pub status: Status,
    /// The makespan up to which it is whole; `None` for whatever the horizon.
    pub within: Option<u32>,
    costs: Vec<Cost>,
    told: FrontAnswer,
}

/// Whether an objective has a front: one of two or three costs has.
pub fn has_front(objective: &Objective) -> bool {
    COSTS.contains(&objective.costs().len())
}

impl Front {
    /// Takes a front in.
    ///
    /// What is proved of a point is that it is on the front, not that no plan has
    /// less of one cost: so each is taken in as a plan without a claim, which is
    /// all that a link or a question may make of it.
    pub(crate) fn new(draft: Rc<Draft>, request: &Rc<SolveRequest>, front: FrontAnswer) -> Self {
        let objective = request.objective.as_ref();
        let objective = objective.unwrap_or(&request.scene.objective);
        let points = front.front.iter().cloned().map(|point| {
            let plan = SolveAnswer {
                status: Status::Feasible,
                bounds: BTreeMap::new(),
                ..point
            };
            Rc::new(Answer::new(Rc::clone(&draft), Rc::clone(request), plan))
        });
        Self {
            points: points.collect(),
            status: front.status,
            within: front.reach.within(),
            costs: objective.costs().to_vec(),
            told: front,
            draft,
        }
    }

    /// The answer to show first: the plan with the least of the first cost, or
    /// that there is none.
    pub(crate) fn first(&self, request: &Rc<SolveRequest>) -> Rc<Answer> {
        if let Some(first) = self.points.first() {
            return Rc::clone(first);
        }
        let none = SolveAnswer {
            giveway: Version,
            status: self.status,
            costs: None,
            bounds: BTreeMap::new(),
            reach: self.told.reach,
            ended: None,
            reason: None,
            plan: None,
            stats: Stats::default(),
            trace: None,
        };
        Rc::new(Answer::new(
            Rc::clone(&self.draft),
            Rc::clone(request),
            none,
        ))
    }

    /// What was told of it.
    pub(crate) const fn told(&self) -> &FrontAnswer {
        &self.told
    }

    /// Whether it is proved that these are all.
    pub fn is_whole(&self) -> bool {
        self.status == Status::Optimal
    }

    /// The number of a plan among the points, if it is one.
    pub fn place_of(&self, answer: &Rc<Answer>) -> Option<usize> {
        self.points
            .iter()
            .position(|point| Rc::ptr_eq(point, answer))
    }

    /// The costs of a point in words: `makespan 18, sum of costs 35`.
    pub fn name(&self, point: usize) -> String {
        let costs = self.points.get(point).and_then(|point| point.solved.costs);
        costs.map_or_else(String::new, |costs| values(&self.costs, &costs))
    }

    /// What is claimed of it, in a sentence.
    pub fn claim(&self) -> String {
        let plans = tr!("{n} plan" | "{n} plans" % self.points.len());
        giveway_solve::words::front(&plans, self.is_whole(), self.within, self.told.ended)
    }
}
