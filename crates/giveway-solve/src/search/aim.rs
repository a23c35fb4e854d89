//! The input and the result of a search.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs};

use super::{
    earlier::EarlierOptima, for_ever::Proved, horizon::Horizon, incumbent::OnBetter,
    latest::LatestArrivals,
};
use crate::{budget::Stop, walk::Walk};

/// Bounds on a plan beside the rules.
#[derive(Clone, Debug)]
pub(crate) struct Bounded {
    /// The makespan beyond which nothing is looked for.
    pub(crate) horizon: Horizon,
    /// The most that a plan may have of some costs.
    pub(crate) limits: BTreeMap<Cost, u32>,
}

impl Bounded {
    /// The latest arrival of any plan that is looked for.
    pub(super) fn latest(&self) -> u32 {
        let limit = self.limits.get(&Cost::Makespan).copied();
        self.horizon.latest().min(limit.unwrap_or(u32::MAX))
    }
}

/// Which plans a search looks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Aim {
    /// The best plan, and the proof that it is.
    Best,
    /// A plan whose costs, in the order of the objective, are no worse than
    /// these.
    AtMost(Vec<u32>),
    /// Any plan.
    Any,
}

impl Aim {
    /// Whether a plan of these costs is all that is looked for.
    pub(super) fn is_met(&self, vector: &[u32]) -> bool {
        match self {
            Self::Best => false,
            Self::AtMost(most) => vector <= most.as_slice(),
            Self::Any => true,
        }
    }

    /// Whether no plan can meet the aim, where `least` are the optima of the first costs.
    pub(super) fn is_missed(&self, least: &[u32]) -> bool {
        match self {
            Self::AtMost(most) => most.get(..least.len()).is_some_and(|most| most < least),
            _ => false,
        }
    }
}

/// The result of a search.
#[derive(Debug)]
pub(crate) struct Verdict {
    /// The best plan, if there is one.
    pub(crate) best: Option<(Vec<Walk>, Costs)>,
    /// The proved lower bounds, of each cost that was reached.
    pub(crate) bounds: BTreeMap<Cost, u32>,
    /// How far the claim reaches; `None` where it is not settled, or nothing is
    /// claimed but that there is a plan.
    pub(crate) reach: Option<Proved>,
    /// Why it is not settled; `None` where it is.
    pub(crate) stop: Option<Stop>,
    /// Agents that cannot all arrive, where there is no plan.
    pub(crate) clash: Vec<usize>,
    /// The latest arrivals that the proof leaves, where the plan is proved to be the best.
    pub(crate) latest: Option<LatestArrivals>,
}

/// The start of a search for the best plan, and its progress reports.
pub(crate) struct Contact<'a> {
    /// The walks of a plan that is known already.
    pub(crate) start: Option<&'a [Walk]>,
    /// The optima of an earlier search with fewer conditions.
    pub(crate) earlier: Option<&'a EarlierOptima>,
    /// Is told of each better plan.
    pub(crate) on_better: &'a OnBetter<'a>,
}
