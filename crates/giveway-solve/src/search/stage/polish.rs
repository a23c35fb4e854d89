//! Improving the best plan while the proof goes on.

use giveway_model::Cost;

use super::Search;
use crate::{
    budget::Stop,
    lns::{Effort, Lns},
    single::Task,
    walk::Walk,
};

/// Clauses that the SAT solver derives before the best plan is improved for the
/// first time: what is proved sooner needs no better plan.
const FIRST_POLISH: u64 = 1000;
/// States of single agents that local search may look at, for each clause that the
/// SAT solver derives: so both get their share of the time.
const STATES_PER_CLAUSE: u64 = 200;
/// The same where the plan is more than a twentieth above the bound: there it gains
/// more than the proof does.
const STATES_WHERE_WIDE: u64 = 600;
/// How much longer a state takes where agents have batteries, which safe intervals
/// do not know.
const DEARER: u64 = 8;
/// The least that is worth to begin with.
const LEAST_STATES: u64 = 20_000;
/// States without a better plan, after which none is expected.
const IN_VAIN: u64 = 300_000;

/// The neighbourhood search, and when it goes on.
pub(super) struct Polishing {
    lns: Lns,
    /// States that it may still look at, from earlier times.
    left: u64,
    /// Derived clauses up to which its share is reckoned.
    reckoned: u64,
    /// States that it has looked at since the plan last became better.
    in_vain: u64,
}

impl Polishing {
    pub(super) fn new() -> Self {
        Self {
            lns: Lns::default(),
            left: 0,
            reckoned: 0,
            in_vain: 0,
        }
    }

    /// The same neighbourhood search, in another formula.
    pub(super) fn afresh(self) -> Self {
        self
    }
}

impl Search<'_, '_, '_> {
    /// Improves the best plan, now and then, by its share of the time.
    pub(crate) fn polish(&mut self, cost: Cost, bound: u32) -> Result<(), Stop> {
        let derived = self.allowed.budget.derived();
        if derived < FIRST_POLISH {
            return Ok(());
        }
        let Some(walks) = self.incumbent.walks() else {
            return Ok(());
        };
        let best = self.incumbent.costs().map_or(0, |costs| costs.get(cost));
        let share = if best > bound + bound / 20 {
            STATES_WHERE_WIDE
        } else {
            STATES_PER_CLAUSE
        };
        let plain = self.problem.tasks.iter().all(Task::is_plain);
        let share = if plain { share } else { share / DEARER };
        let polishing = &mut self.polishing;
        let news = derived.saturating_sub(polishing.reckoned);
        polishing.reckoned = derived;
        polishing.left = polishing.left.saturating_add(news.saturating_mul(share));
        if polishing.left < LEAST_STATES {
            return Ok(());
        }
        let states = std::mem::take(&mut polishing.left);
        let walks = walks.to_vec();
        let better = self.improve(walks, cost, bound, states)?;
        let polishing = &mut self.polishing;
        polishing.in_vain = if better {
            0
        } else {
            polishing.in_vain + states
        };
        Ok(())
    }

    /// Whether the best plan has not become better of late, though that was tried.
    pub(crate) const fn is_polished(&self) -> bool {
        self.polishing.in_vain >= IN_VAIN
    }

    /// Improves a plan by so many states, about, as long as its cost is above the
    /// bound, and keeps it if it is the best; whether it became better.
    pub(crate) fn improve(
        &mut self,
        mut walks: Vec<Walk>,
        cost: Cost,
        bound: u32,
        states: u64,
    ) -> Result<bool, Stop> {
        let objective = self.incumbent.objective().clone();
        let is_first = objective.costs().first() == Some(&cost);
        let effort = Effort {
            states,
            horizon: self.allowed.deadlines.last_cap(),
            enough: if is_first { bound } else { 0 },
        };
        let improved = self.polishing.lns.improve(
            self.problem,
            &mut walks,
            effort,
            &objective,
            &self.allowed.budget,
        );
        self.incumbent.offer(self.problem, &walks);
        improved
    }
}
