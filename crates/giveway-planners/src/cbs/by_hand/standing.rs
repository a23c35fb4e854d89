//! How far a search by hand is: a plan is proved once no open branch costs less.

use super::{Hand, HandNode};
use crate::cbs::{LowerBound, Proved};

/// How far it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// No branch is a plan yet.
    NotYet {
        /// The least cost of an open branch: no plan costs less.
        bound: LowerBound,
    },
    /// A branch is a plan, and another one that is open costs less.
    Found {
        /// The cost of the plan.
        cost: u32,
        /// The least cost of an open branch.
        least_open: u32,
        /// No plan costs less than this.
        bound: LowerBound,
    },
    /// No open branch costs less than the plan.
    Proved {
        /// The cost of the plan.
        cost: u32,
        /// The claim.
        proved: Proved,
    },
    /// All branches are dead ends: there is no plan up to the horizon.
    Exhausted {
        /// No plan costs less than this.
        bound: LowerBound,
    },
}

impl Hand<'_> {
    /// How far it is.
    pub fn standing(&self) -> Standing {
        let open = self.nodes.iter().filter(|node| node.is_open());
        let open = open.filter_map(|node| node.cost).min();
        let bound = LowerBound::new(self.problem, self.aim, open, self.horizon);
        let plan = self.plan().and_then(|plan| self.nodes.get(plan)?.cost);
        match (plan, open) {
            (Some(cost), Some(least_open)) if least_open < cost => Standing::Found {
                cost,
                least_open,
                bound,
            },
            (Some(cost), _) => Standing::Proved {
                cost,
                proved: Proved::new(self.problem, self.aim, cost, self.horizon),
            },
            (None, Some(_)) => Standing::NotYet { bound },
            (None, None) => Standing::Exhausted { bound },
        }
    }

    /// The cheapest plan so far, the first of these, by the number of its node.
    pub fn plan(&self) -> Option<usize> {
        let nodes = self.nodes.iter().enumerate();
        let plans = nodes.filter_map(|(number, node): (usize, &HandNode)| {
            let cost = node.plan()?;
            Some((cost, number))
        });
        plans.min().map(|(_, number)| number)
    }
}
