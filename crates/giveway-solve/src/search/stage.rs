//! The shared parts of the stages of a lexicographic search.
//!
//! A stage minimises one cost of the objective around one [`Team`]. When it is
//! done, what it proved is made to hold for good, and the next stage goes on in
//! the same formula: a lexicographic optimum is an optimum of the last cost
//! among the optima of all before it.

mod caps;
mod enter;
mod limits;
mod polish;
mod tell;

use std::rc::Rc;

use giveway_model::{Cost, sorting};

use super::{
    aim::Bounded,
    bound::{Bound, Optimum},
    claim::SearchClaim,
    deadlines::{Deadlines, Keeping},
    horizon::Horizon,
    incumbent::Incumbent,
    team::Team,
};
use crate::{
    budget::Budget, encode::limit::SumLimit, problem::Problem, progress::Progress, sat::Lit,
    walk::Walk,
};

use polish::Polishing;

/// How a stage ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// With the least value of its cost.
    Least(Optimum),
    /// No plan keeps within the horizon and the limits.
    None,
}

/// The problem and the bounds of a search.
#[derive(Clone, Copy)]
pub(crate) struct Subject<'p, 'a> {
    pub(crate) problem: &'p Problem,
    /// Walks of all agents, each at its own optimum.
    pub(crate) walks: &'a [Walk],
    /// The bounds on plans.
    pub(crate) bounded: &'a Bounded,
}

/// A lexicographic search under way.
pub(crate) struct Search<'p, 'h, 'b> {
    pub(crate) problem: &'p Problem,
    /// The agents and their formula.
    pub(crate) team: Team<'p, 'h>,
    /// The best plan so far, and the order in which costs compare.
    pub(crate) incumbent: &'p mut Incumbent<'b>,
    pub(super) budget: Rc<Budget<'h>>,
    /// The latest arrivals that are still of interest.
    pub(super) deadlines: Deadlines,
    /// The claim so far.
    pub(super) claim: SearchClaim,
    /// The sums of costs that are limited: of what agents have beyond their minima, and
    /// of agents that enter later all of it.
    sums: Vec<(Cost, SumLimit)>,
    polishing: Polishing,
}

impl<'p, 'h, 'b> Search<'p, 'h, 'b> {
    pub(crate) fn new(
        subject: Subject<'p, '_>,
        keeping: Keeping,
        incumbent: &'p mut Incumbent<'b>,
        budget: Rc<Budget<'h>>,
    ) -> Self {
        let Subject {
            problem,
            walks,
            bounded,
        } = subject;
        let makespan = bounded.limits.get(&Cost::Makespan).copied();
        Self {
            problem,
            team: Team::new(problem, walks.to_vec(), Rc::clone(&budget)),
            incumbent,
            budget,
            deadlines: Deadlines::new(problem, bounded.horizon, makespan, keeping),
            claim: SearchClaim::default(),
            sums: Vec::new(),
            polishing: Polishing::new(),
        }
    }

    /// The same search after its first stage, the makespan, with an empty
    /// formula: the later stages need much smaller MDDs than the proof of
    /// the makespan did.
    pub(super) fn afresh(self, optimum: Optimum, walks: &[Walk]) -> Self {
        let makespan = optimum.least();
        let bounded = Bounded {
            horizon: Horizon::at(makespan),
            limits: sorting::map([(Cost::Makespan, makespan)]),
        };
        let subject = Subject {
            problem: self.problem,
            walks,
            bounded: &bounded,
        };
        let budget = self.budget;
        let mut fresh = Self::new(subject, Keeping::Hard, self.incumbent, budget);
        fresh.polishing = self.polishing;
        fresh.claim.keep_outside(Cost::Makespan);
        fresh.claim.finish(optimum);
        fresh
    }

    /// Whether the best plan has this value of a cost, and the optimum of each
    /// cost before it.
    pub(crate) fn incumbent_meets(&self, cost: Cost, value: u32) -> bool {
        let costs = self.incumbent.costs();
        costs.is_some_and(|costs| costs.get(cost) == value && self.claim.is_met_by(&costs))
    }

    /// The best plan's value of a cost, if it has the optimum of each cost
    /// before it.
    pub(crate) fn best(&self, cost: Cost) -> Option<u32> {
        let best = self.incumbent.costs()?.get(cost);
        self.incumbent_meets(cost, best).then_some(best)
    }

    /// Makes a literal hold that all plans keep but those that are excluded.
    pub(crate) fn harden_for_better(&mut self, lit: Lit) {
        self.claim.has_excluded();
        self.team.harden(lit);
    }

    /// Tells the host a proved bound.
    pub(super) fn report_bound(&self, bound: Bound) {
        self.budget.report(&Progress::Bound {
            cost: bound.cost(),
            at_least: bound.at_least(),
        });
    }
}
