//! Improving the best plan while the proof goes on.

use giveway_model::Cost;
use giveway_planners::first::plan_in_order;

use super::Search;
use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    lns::{Effort, Lns},
    local::Timetable,
    search::bound::Bound,
    trace::FoundBy,
    walk::Walk,
};

/// States of single agents that local search may look at, for each clause that the
/// SAT solver derives: so both get their share of the time.
const STATES_PER_CLAUSE: u64 = 60;
/// The states for each agent that it may look at whenever the proof has come a step
/// further, as long as the plan is far from the bound and becomes better.
const STATES_PER_AGENT: u64 = 4000;
/// Improvement is given up after this many turns without a gain.
const TURNS_IN_VAIN: u64 = 2;
/// The most states of one turn in which a plan is brought nearer to what counting shows, and how
/// many turns without a gain end it.
const MOST_APPROACHED: u64 = 200_000;
const APPROACHES_IN_VAIN: u32 = 2;
/// How much longer a state takes where agents have batteries, which safe intervals
/// do not know.
const DEARER: u64 = 8;

/// The large neighbourhood search, and its share of the work.
pub(super) struct Polishing {
    lns: Lns,
    /// Expansions left over from earlier turns.
    left: u64,
    /// Derived clauses for which it has had its share.
    reckoned: u64,
    /// Expansions since the plan last improved.
    in_vain: u64,
    /// Whether its turns gain little by now.
    is_slow: bool,
}

impl Polishing {
    pub(super) fn new() -> Self {
        Self {
            lns: Lns::default(),
            left: 0,
            reckoned: 0,
            in_vain: 0,
            is_slow: false,
        }
    }
}

impl Search<'_, '_, '_> {
    /// Improves the best plan, now and then, by its share of the time.
    pub(crate) fn polish(&mut self, cost: Cost, bound: u32) -> Result<(), Stop> {
        let budget = &self.budget;
        let (derived, given) = (budget.derived(), budget.given());
        let Some(best) = self.incumbent.costs().map(|costs| costs.get(cost)) else {
            return Ok(());
        };
        let thresholds = *budget.thresholds();
        let early = derived < thresholds.polish_after && given < thresholds.polish_after_given;
        if early || best <= bound {
            return Ok(());
        }
        let dear = if Timetable::is_quick(self.problem) {
            1
        } else {
            DEARER
        };
        let is_wide = best > bound.saturating_add(bound / 20);
        let turn = STATES_PER_AGENT * self.problem.agents() as u64 / dear;
        let polishing = &mut self.polishing;
        let news = derived.saturating_sub(polishing.reckoned);
        polishing.reckoned = derived;
        let share = news.saturating_mul(STATES_PER_CLAUSE / dear);
        polishing.left = polishing.left.saturating_add(share);
        let takes_turn = is_wide && !polishing.is_slow;
        if !takes_turn && polishing.left < thresholds.polish_states / dear {
            return Ok(());
        }
        let mut states = std::mem::take(&mut polishing.left);
        if takes_turn {
            states = states.max(turn);
        }
        let Some(walks) = self.incumbent.walks() else {
            return Ok(());
        };
        let mut walks = walks.to_vec();
        let better = self.improve((&mut walks, FoundBy::Lns), cost, bound, states)?;
        let polishing = &mut self.polishing;
        polishing.in_vain = if better {
            0
        } else {
            polishing.in_vain + states
        };
        polishing.is_slow |= polishing.in_vain >= TURNS_IN_VAIN * turn;
        Ok(())
    }

    /// Looks for a plan that meets a bound that counting shows, since the formula proves little of
    /// it: the best plan is improved, and those in which the agents pass the bottleneck in orders
    /// that lose no time there. Where counting shows little, that is left to the proof.
    pub(crate) fn approach(&mut self, bound: Bound, orders: [Vec<AgentId>; 2]) -> Result<(), Stop> {
        let best = self.incumbent.costs().map(|costs| costs.get(bound.cost()));
        if best.is_some_and(|best| !bound.is_counted_for(best)) {
            return Ok(());
        }
        if let Some(walks) = self.incumbent.walks().map(<[_]>::to_vec) {
            self.approach_from((walks, FoundBy::Lns), bound)?;
        }
        let latest = self.deadlines.last_cap();
        for order in orders {
            if bound.met(self).is_some() {
                break;
            }
            let planned = plan_in_order(self.problem, order, latest, &self.budget)?;
            let Some(walks) = planned else { continue };
            self.incumbent
                .offer(self.problem, &walks, FoundBy::Prioritised);
            self.approach_from((walks, FoundBy::Lns), bound)?;
        }
        Ok(())
    }

    /// Improves a plan as long as that brings it nearer to a bound.
    fn approach_from(
        &mut self,
        (mut walks, by): (Vec<Walk>, FoundBy),
        bound: Bound,
    ) -> Result<(), Stop> {
        let (cost, least) = (bound.cost(), bound.at_least());
        let states = STATES_PER_AGENT * self.problem.agents() as u64;
        let mut in_vain = 0;
        while in_vain < APPROACHES_IN_VAIN && bound.met(self).is_none() {
            let states = states.min(MOST_APPROACHED);
            let better = self.improve((&mut walks, by), cost, least, states)?;
            in_vain = if better { 0 } else { in_vain + 1 };
        }
        Ok(())
    }

    /// Whether the best plan has not become better of late, though that was tried.
    pub(crate) fn is_polished(&self) -> bool {
        self.polishing.in_vain >= self.budget.thresholds().polished_after
    }

    /// Improves a plan, which is told to be found by somebody, by so many states, about, as long as its cost is above the
    /// bound, and keeps it if it is the best; whether it became better.
    pub(crate) fn improve(
        &mut self,
        (walks, by): (&mut Vec<Walk>, FoundBy),
        cost: Cost,
        bound: u32,
        states: u64,
    ) -> Result<bool, Stop> {
        let objective = self.incumbent.objective().clone();
        let is_first = objective.costs().first() == Some(&cost);
        let effort = Effort {
            states,
            horizon: self.deadlines.last_cap(),
            enough: if is_first { bound } else { 0 },
        };
        let improved =
            self.polishing
                .lns
                .improve(self.problem, walks, effort, &objective, &self.budget);
        self.incumbent.offer(self.problem, walks, by);
        improved
    }
}
