//! Improving the best plan while the proof goes on.

use giveway_model::Cost;

use super::Search;
use crate::{budget::Stop, local::Lns, walk::Walk};

/// Clauses that the SAT solver derives before the best plan is improved for the
/// first time: what is proved sooner needs no better plan.
const FIRST_POLISH: u64 = 1000;
/// Neighbourhoods tried each time.
const POLISH_ROUNDS: usize = 30;

/// The neighbourhood search, and when it goes on.
pub(super) struct Polishing {
    lns: Lns,
    /// Derived clauses from which on the best plan is to be improved again.
    next: u64,
}

impl Polishing {
    pub(super) fn new() -> Self {
        Self {
            lns: Lns::default(),
            next: FIRST_POLISH,
        }
    }

    /// The same neighbourhood search, from the beginning of a proof.
    pub(super) fn afresh(self) -> Self {
        Self {
            lns: self.lns,
            next: FIRST_POLISH,
        }
    }
}

impl Search<'_, '_, '_> {
    /// Improves the best plan, now and then: as the proof gets longer by a
    /// part of it, so that both get their share of the time.
    pub(crate) fn polish(&mut self, cost: Cost, bound: u32) -> Result<(), Stop> {
        let derived = self.allowed.budget.derived();
        if derived < self.polishing.next {
            return Ok(());
        }
        let Some(walks) = self.incumbent.walks() else {
            return Ok(());
        };
        let improved = self.improve(walks.to_vec());
        // Where nothing is gained, or little is left to gain, less often.
        let best = self.incumbent.costs().map_or(0, |costs| costs.get(cost));
        let wide = best > bound + bound / 20;
        let pause = match (improved?, wide) {
            (_, true) => derived / 16,
            (true, false) => derived / 4,
            (false, false) => derived,
        };
        self.polishing.next = derived + pause;
        Ok(())
    }

    /// Improves a plan for some time, and keeps it if it is the best; whether
    /// it became better.
    pub(crate) fn improve(&mut self, mut walks: Vec<Walk>) -> Result<bool, Stop> {
        let latest = self.allowed.deadlines.last_cap();
        let objective = self.incumbent.objective().clone();
        let improved = self.polishing.lns.improve(
            self.problem,
            &mut walks,
            latest,
            &objective,
            POLISH_ROUNDS,
            &self.allowed.budget,
        );
        self.incumbent.offer(self.problem, &walks);
        improved
    }
}
