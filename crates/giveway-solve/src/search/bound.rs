//! A proved lower bound of a cost, and the optimum that it becomes.

use giveway_model::Cost;

use super::{
    counting::CountedBound, earlier::EarlierOptimum, for_ever::LeastForEver, minima::LoneBound,
    stage::Search,
};
use crate::sat::Core;

/// Counting shows much where it shows one of so many parts.
const PARTS_COUNTED: u64 = 4;

/// No plan with the optima of all costs before it has less of a cost. It begins with what
/// agents need alone; counting at bottlenecks and unsatisfiable cores raise it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    cost: Cost,
    at_least: u32,
    /// What cores show of it, without counting: only above this is what a formula excludes.
    by_cores: u32,
}

/// The least value of a cost: its bound, which a plan meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Optimum {
    cost: Cost,
    least: u32,
}

impl Bound {
    /// The bound from the least that agents need alone.
    pub(super) const fn new(cost: Cost, alone: LoneBound) -> Self {
        Self {
            cost,
            at_least: alone.at_least(),
            by_cores: alone.at_least(),
        }
    }

    /// Takes in what counting shows.
    pub(super) fn take_counted(&mut self, counted: CountedBound) {
        if counted.shows(self.cost, counted.at_least()).is_some() {
            self.at_least = self.at_least.max(counted.at_least());
        }
    }

    /// Takes in the optimum of an earlier search, of which the formula knows nothing.
    pub(super) fn take_earlier(&mut self, earlier: EarlierOptimum) {
        self.at_least = self.at_least.max(earlier.least());
    }

    /// Takes in a bound that was proved in another way.
    pub(super) fn take_known(&mut self, known: LeastForEver) {
        self.by_cores = self.by_cores.max(known.least);
        self.at_least = self.at_least.max(known.least);
    }

    /// The cost.
    pub(super) const fn cost(self) -> Cost {
        self.cost
    }

    /// The least that a plan can have.
    pub(super) const fn at_least(self) -> u32 {
        self.at_least
    }

    /// The least that cores show, without counting.
    pub(super) const fn by_cores(self) -> u32 {
        self.by_cores
    }

    /// Whether counting shows more than cores do.
    pub(super) const fn is_counted(self) -> bool {
        self.at_least > self.by_cores
    }

    /// Whether it is worth looking for a plan that meets the bound: of the makespan always, of
    /// sums where counting shows much of what a plan with so much of the cost has beyond what
    /// cores show.
    pub(super) fn is_counted_for(self, plan: u32) -> bool {
        let counted = u64::from(self.at_least - self.by_cores.min(self.at_least));
        let beyond = u64::from(plan.saturating_sub(self.by_cores));
        let is_much = self.cost == Cost::Makespan || PARTS_COUNTED * counted >= beyond;
        self.is_counted() && is_much
    }

    /// No plan meets the bound, as a core shows.
    pub(super) const fn raise(&mut self, _: &Core) {
        self.at_least += 1;
        self.by_cores = self.at_least;
    }

    /// No plan has less than this much more, as a core shows: each level of what it names
    /// costs so much.
    pub(super) fn raise_by(&mut self, unit: u32, _: &Core) {
        self.by_cores += unit;
        self.at_least = self.at_least.max(self.by_cores);
    }

    /// No plan has less than this, as a core shows.
    pub(super) fn raise_to(&mut self, at_least: u32, _: &Core) {
        self.by_cores = self.by_cores.max(at_least);
        self.at_least = self.at_least.max(at_least);
    }

    /// The optimum, where the best plan meets the bound.
    pub(super) fn met(self, search: &Search) -> Option<Optimum> {
        let is_met = search.incumbent_meets(self.cost, self.at_least);
        is_met.then_some(Optimum {
            cost: self.cost,
            least: self.at_least,
        })
    }
}

impl Optimum {
    /// The cost.
    pub(super) const fn cost(self) -> Cost {
        self.cost
    }

    /// Its value.
    pub(super) const fn least(self) -> u32 {
        self.least
    }
}
