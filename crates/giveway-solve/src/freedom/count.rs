//! How many best plans there are.

use super::{PlanCount, every::Every, variations::Variations};
use crate::{budget::Budget, budget::Stop, sat::Lit};

/// Calls of the SAT solver that the count may take before other parts have their turn.
const FIRST_CALLS: u32 = 60;

/// How counting goes on.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum CountStep {
    /// It is not finished.
    Open,
    /// There are no others.
    All,
    /// There are more than were to be counted: this many.
    More(u32),
}

impl CountStep {
    /// As it is told, of so many that were found.
    pub(super) fn of(self, found: usize) -> PlanCount {
        match self {
            Self::Open => PlanCount::AtLeast(found as u32),
            Self::All => PlanCount::Exactly(found as u32),
            Self::More(limit) => PlanCount::MoreThan(limit),
        }
    }
}

/// The count, as far as it is known.
pub(super) struct PlanCounter {
    limit: u32,
    counted: CountStep,
    variations: Variations,
    /// Under this literal no plan is one of the first so many that were found.
    blocked: Option<(Lit, usize)>,
}

impl PlanCounter {
    /// Nothing is known yet.
    pub(super) fn new(limit: u32) -> Self {
        Self {
            limit,
            counted: CountStep::Open,
            variations: Variations::default(),
            blocked: None,
        }
    }

    /// Whether all best plans were found.
    pub(super) fn is_exact(&self) -> bool {
        self.counted == CountStep::All
    }

    /// Whether it is finished.
    pub(super) fn is_settled(&self) -> bool {
        self.counted != CountStep::Open
    }

    /// The number of best plans, as far as it is known.
    pub(super) fn told(&self, every: &Every) -> PlanCount {
        self.counted.of(every.found().len())
    }

    /// Counts as long as it takes little.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn begin(&mut self, every: &mut Every, budget: &Budget) -> Result<(), Stop> {
        self.go_on(every, budget, Some(FIRST_CALLS))
    }

    /// Finishes the count.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn settle(&mut self, every: &mut Every, budget: &Budget) -> Result<(), Stop> {
        self.go_on(every, budget, None)
    }

    /// Finds best plans until there are no others, or more than the limit: variations
    /// of those that were found, and where they are all known, plans of the solver.
    fn go_on(
        &mut self,
        every: &mut Every,
        budget: &Budget,
        mut calls: Option<u32>,
    ) -> Result<(), Stop> {
        while !self.is_settled() {
            self.variations.find(every, self.limit, budget)?;
            if every.found().len() as u64 > u64::from(self.limit) {
                self.end(every, CountStep::More(self.limit));
                return Ok(());
            }
            if calls == Some(0) {
                return Ok(());
            }
            calls = calls.map(|left| left - 1);
            let blocked = self.block(every);
            if !every.find(&[blocked])? {
                self.end(every, CountStep::All);
            }
        }
        Ok(())
    }

    /// A literal under which a plan is none of those that were found.
    fn block(&mut self, every: &mut Every) -> Lit {
        let (blocked, done) = self.blocked.unwrap_or_else(|| (every.formula.fresh(), 0));
        let found = every.found().len();
        for number in done..found {
            let marks = every.found().get(number).map(|plan| every.marks(plan));
            let others = marks.into_iter().flatten().map(|lit| !lit);
            every.formula.under(blocked, others);
        }
        self.blocked = Some((blocked, found));
        blocked
    }

    fn end(&mut self, every: &mut Every, counted: CountStep) {
        self.counted = counted;
        if let Some((blocked, _)) = self.blocked.take() {
            every.formula.retire(blocked);
        }
    }
}
