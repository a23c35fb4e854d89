//! What the stages of a lexicographic search share.
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

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, sorting};

use super::{
    aim::Bounded,
    deadlines::{Deadlines, Keeping},
    horizon::Horizon,
    incumbent::Incumbent,
    team::Team,
};
use crate::{
    budget::Budget, encode::limit::SumLimit, problem::Problem, progress::Progress, sat::Lit,
    walk::Walk,
};

pub(super) use limits::{LimitTooLow, asked_below_minimum};
use polish::Polishing;

/// How a stage ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// The least value of its cost.
    Least(u32),
    /// No plan keeps within the horizon and the limits.
    None,
}

/// What a search is about.
#[derive(Clone, Copy)]
pub(crate) struct Subject<'p, 'a> {
    pub(crate) problem: &'p Problem,
    /// Walks of all agents, each at its own optimum.
    pub(crate) walks: &'a [Walk],
    /// What plans must keep to.
    pub(crate) bounded: &'a Bounded,
}

/// A lexicographic search under way.
pub(crate) struct Search<'p, 'h, 'b> {
    pub(crate) problem: &'p Problem,
    /// The agents and their formula.
    pub(crate) team: Team<'p, 'h>,
    /// The best plan so far, and the order in which costs compare.
    pub(crate) incumbent: &'p mut Incumbent<'b>,
    pub(super) allowed: Allowed<'h>,
    stages: Stages,
    polishing: Polishing,
}

/// What the search may use, and what plans may have.
pub(super) struct Allowed<'h> {
    pub(super) budget: Rc<Budget<'h>>,
    /// The latest arrivals that are still of interest.
    pub(super) deadlines: Deadlines,
    /// The sums of costs that are limited.
    sums: BTreeMap<Cost, SumLimit>,
}

/// How far the stages have come.
#[derive(Default)]
struct Stages {
    /// The costs whose optimum holds for good.
    done: BTreeMap<Cost, u32>,
    /// The costs done or under way: outside agents are at their own minima.
    begun: Vec<Cost>,
    /// Counts of which agents that enter have their own minima.
    at_minima: Vec<Cost>,
    /// Whether cores are made smaller.
    minimises: bool,
    /// What was excluded that only worse plans do, in the stage under way.
    worse: Worse,
}

/// Plans that are worse than the best one may be excluded.
#[derive(Clone, Copy, Default)]
struct Worse {
    /// The most that plans may have of the cost under way which are not excluded.
    at_most: Option<u32>,
    /// Whether a clause says so by now.
    in_force: bool,
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
            allowed: Allowed {
                budget,
                deadlines: Deadlines::new(problem, bounded.horizon, makespan, keeping),
                sums: BTreeMap::new(),
            },
            stages: Stages::default(),
            polishing: Polishing::new(),
        }
    }

    /// Marks a cost as under way.
    pub(crate) fn begin(&mut self, cost: Cost) {
        self.stages.worse = Worse::default();
        if !self.stages.begun.contains(&cost) {
            self.stages.begun.push(cost);
        }
    }

    /// The same search after its first stage, the makespan, with an empty
    /// formula: the later stages need much smaller MDDs than the proof of
    /// the makespan did.
    pub(crate) fn afresh(self, makespan: u32, walks: &[Walk]) -> Self {
        let bounded = Bounded {
            horizon: Horizon::at(makespan),
            limits: sorting::map([(Cost::Makespan, makespan)]),
        };
        let subject = Subject {
            problem: self.problem,
            walks,
            bounded: &bounded,
        };
        let budget = self.allowed.budget;
        let mut fresh = Self::new(subject, Keeping::Hard, self.incumbent, budget);
        fresh.stages.minimises = self.stages.minimises;
        fresh.polishing = self.polishing;
        fresh.finish(Cost::Makespan, makespan);
        fresh.begin(Cost::Makespan);
        fresh
    }

    /// Whether cores are made smaller, in the stage under way.
    pub(crate) const fn minimise_cores(&mut self, minimises: bool) {
        self.stages.minimises = minimises;
    }

    /// Whether cores are made smaller.
    pub(crate) const fn minimises_cores(&self) -> bool {
        self.stages.minimises
    }

    /// Marks the optimum of a cost as holding for good.
    pub(crate) fn finish(&mut self, cost: Cost, least: u32) {
        self.stages.done.insert(cost, least);
    }

    /// In every plan with the optimum of a count, proved by cores, the agents
    /// that no core named are at their own minima: so are those that enter
    /// later. (An optimum that is known in another way says nothing of them.)
    pub(crate) fn keep_minima(&mut self, cost: Cost) {
        if cost != Cost::SumOfCosts {
            self.stages.at_minima.push(cost);
        }
    }

    /// Whether the best plan has this value of a cost, and the optimum of each
    /// cost before it.
    pub(crate) fn incumbent_meets(&self, cost: Cost, value: u32) -> bool {
        self.incumbent.costs().is_some_and(|costs| {
            costs.get(cost) == value
                && self
                    .stages
                    .done
                    .iter()
                    .all(|(&c, &least)| costs.get(c) == least)
        })
    }

    /// The best plan's value of a cost, if it has the optimum of each cost
    /// before it.
    pub(crate) fn best(&self, cost: Cost) -> Option<u32> {
        let best = self.incumbent.costs()?.get(cost);
        self.incumbent_meets(cost, best).then_some(best)
    }

    /// From now on plans may be excluded that have more than this of the cost under
    /// way.
    pub(crate) const fn exclude_worse(&mut self, at_most: u32) {
        self.stages.worse.at_most = Some(at_most);
    }

    /// Makes a literal hold that all plans keep but those that are excluded.
    pub(crate) fn harden_for_better(&mut self, lit: Lit) {
        self.stages.worse.in_force = true;
        self.team.harden(lit);
    }

    /// Tells the host a proved bound.
    pub(crate) fn report_bound(&self, cost: Cost, at_least: u32) {
        self.allowed
            .budget
            .report(&Progress::Bound { cost, at_least });
    }
}
