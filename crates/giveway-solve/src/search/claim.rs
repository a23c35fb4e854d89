//! The claim of a lexicographic search: proved so far, and under way.
//!
//! The claim grows cost by cost. While it is *open*, any plan will do; `begin` makes it
//! *proving*, which is the only state in which plans may be excluded for being worse than
//! the best one; `finish` takes the optimum that ends it, and holds it for good.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs};

use super::bound::Optimum;

/// The claim of a search.
#[derive(Default)]
pub(super) struct SearchClaim {
    state: ClaimState,
    /// The optima that hold for good.
    optima: BTreeMap<Cost, u32>,
    /// Costs of which agents outside have their own minima.
    minima_outside: Vec<Cost>,
    /// Counts of which agents that enter have their own minima.
    minima_inside: Vec<Cost>,
}

/// Where a search stands.
#[derive(Default)]
enum ClaimState {
    /// No cost is under way.
    #[default]
    Open,
    /// The least of a cost is under way.
    Proving {
        /// Whether cores are made smaller.
        minimises: bool,
        /// The most that plans may have of it which are not excluded.
        at_most: Option<u32>,
        /// Whether a clause says so by now.
        in_force: bool,
    },
}

impl SearchClaim {
    /// The least of a cost is to be proved.
    pub(super) fn begin(&mut self, cost: Cost, minimises: bool) {
        self.keep_outside(cost);
        self.state = ClaimState::Proving {
            minimises,
            at_most: None,
            in_force: false,
        };
    }

    /// The least of a cost is proved, and every plan from now on has it.
    pub(super) fn finish(&mut self, optimum: Optimum) {
        self.optima.insert(optimum.cost(), optimum.least());
        self.state = ClaimState::Open;
    }

    /// Agents outside have their own minima of a cost.
    pub(super) fn keep_outside(&mut self, cost: Cost) {
        if !self.minima_outside.contains(&cost) {
            self.minima_outside.push(cost);
        }
    }

    /// In every plan with the optimum of a count, proved by cores, the agents
    /// that no core named are at their own minima: so are those that enter
    /// later. (An optimum that is known in another way says nothing of them.)
    pub(super) fn keep_inside(&mut self, cost: Cost) {
        if cost != Cost::SumOfCosts {
            self.minima_inside.push(cost);
        }
    }

    /// From now on plans may be excluded that have more than this of the cost under way.
    pub(super) fn exclude_above(&mut self, most: u32) {
        if let ClaimState::Proving { at_most, .. } = &mut self.state {
            *at_most = Some(most);
        }
    }

    /// A clause excludes plans that are worse than the best one.
    pub(super) fn has_excluded(&mut self) {
        if let ClaimState::Proving { in_force, .. } = &mut self.state {
            *in_force = true;
        }
    }

    /// Whether cores are made smaller.
    pub(super) const fn minimises_cores(&self) -> bool {
        matches!(
            self.state,
            ClaimState::Proving {
                minimises: true,
                ..
            }
        )
    }

    /// The most of the cost under way, where clauses exclude more.
    pub(super) const fn excluded_above(&self) -> Option<u32> {
        match self.state {
            ClaimState::Proving {
                at_most,
                in_force: true,
                ..
            } => at_most,
            ClaimState::Proving { .. } | ClaimState::Open => None,
        }
    }

    /// The optima that hold for good.
    pub(super) const fn optima(&self) -> &BTreeMap<Cost, u32> {
        &self.optima
    }

    /// Whether a plan of these costs has all optima.
    pub(super) fn is_met_by(&self, costs: &Costs) -> bool {
        let mut optima = self.optima.iter();
        optima.all(|(&cost, &least)| costs.get(cost) == least)
    }

    /// Costs of which agents outside have their own minima.
    pub(super) fn minima_outside(&self) -> Vec<Cost> {
        self.minima_outside.clone()
    }

    /// Counts of which agents that enter have their own minima.
    pub(super) fn minima_inside(&self) -> Vec<Cost> {
        self.minima_inside.clone()
    }
}
