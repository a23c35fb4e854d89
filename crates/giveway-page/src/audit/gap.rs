//! How far a plan is from the best one, by what is proved of all plans.

use std::collections::BTreeMap;

use giveway_model::{Assumption, Cost, Costs, Objective};
use giveway_solve::Status;

use super::Audit;
use crate::Solving;

/// What our own search knows, while it runs and after.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Known {
    /// The proved lower bound of each cost.
    pub(crate) bounds: BTreeMap<Cost, u32>,
    /// What our best plan costs.
    pub(crate) best: Option<Costs>,
    /// Whether there is a proof that our plan is the best.
    pub(crate) is_optimal: bool,
    /// Whether there is a proof that there is no plan.
    pub(crate) is_impossible: bool,
    /// Whether the scene leaves out what may change all of that: then nothing is known.
    is_open: bool,
}

impl Known {
    /// What is known of the scene of an audit, with what a search has found so far.
    pub(crate) fn of(audit: &Audit, run: Option<&Solving>) -> Self {
        let mut known = Self::default();
        let assumptions = &audit.plan.answer.draft.scene().assumptions;
        let has = |kind: fn(&Assumption) -> bool| assumptions.iter().any(kind);
        let is_chosen = has(|one| matches!(one, Assumption::GoalsChosen));
        known.is_open = has(|one| matches!(one, Assumption::UnknownKey { .. }))
            || (is_chosen && !audit.plan.is_legal());
        if known.is_open {
            return known;
        }
        if let Some(ours) = &audit.ours {
            known.bounds.clone_from(&ours.solved.bounds);
            known.best = ours.solved.costs.filter(|_| ours.plan().is_some());
            known.is_optimal = ours.solved.status == Status::Optimal;
            known.is_impossible = ours.solved.status == Status::Impossible;
        }
        if let Some(run) = run {
            let mut bounds = run.bounds.clone();
            if has(|one| matches!(one, Assumption::RuleLeftOut { .. })) {
                // A later cost's bound speaks of plans that reach those before it, and which of
                // these keep the rule is not known.
                let first = audit.objective().costs().first();
                bounds.retain(|cost, _| Some(cost) == first);
            }
            known.raise(&bounds);
            // What is found on the way was not judged with rules that are left out.
            let is_relaxed = has(|one| match one {
                Assumption::RuleLeftOut { .. } => true,
                Assumption::MovingObstacle { .. }
                | Assumption::GoalsChosen
                | Assumption::UnknownKey { .. } => false,
            });
            if !is_relaxed {
                known.best = run.best.or(known.best);
            }
        }
        known
    }

    /// Takes in bounds of a search that runs.
    pub(crate) fn raise(&mut self, bounds: &BTreeMap<Cost, u32>) {
        if self.is_open {
            return;
        }
        for (&cost, &bound) in bounds {
            let known = self.bounds.entry(cost).or_insert(bound);
            *known = bound.max(*known);
        }
    }
}

/// Where a plan stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Gap {
    /// Nothing is proved yet.
    Unknown,
    /// Each cost is as low as it can be: proved.
    None,
    /// A cost is above what is proved: its value, the bound, and whether a plan
    /// reaches the bound.
    Above {
        /// Which cost.
        cost: Cost,
        /// What the plan costs.
        value: u32,
        /// What every plan costs at least.
        bound: u32,
        /// Whether some plan costs no more than that.
        is_reached: bool,
    },
}

impl Gap {
    /// Where costs stand: by the first cost of the objective that is above its bound.
    pub(crate) fn of(objective: &Objective, costs: &Costs, known: &Known) -> Self {
        for &cost in objective.costs() {
            let value = costs.get(cost);
            let Some(&bound) = known.bounds.get(&cost) else {
                return Self::Unknown;
            };
            if value != bound {
                let best = known.best.map(|best| best.get(cost));
                return Self::Above {
                    cost,
                    value,
                    bound,
                    is_reached: best == Some(bound),
                };
            }
        }
        Self::None
    }
}
