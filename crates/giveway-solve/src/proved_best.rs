//! What an earlier answer proved of the plan that a question is about.

use borsh::{BorshDeserialize, BorshSerialize};

use crate::{
    Reach, SolveAnswer,
    search::{LatestArrivals, Proved},
};

/// That no plan is better than the one asked about, as an earlier answer proved.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct ProvedBest {
    /// How far that holds.
    pub reach: Reach,
    pub(crate) latest: Option<LatestArrivals>,
}

impl ProvedBest {
    /// What a search proved of its own plan; it leaves each agent a latest arrival where its
    /// answer has a trace.
    pub fn by_search(answer: &SolveAnswer) -> Self {
        let trace = answer.trace.as_ref();
        Self {
            reach: answer.reach,
            latest: trace.and_then(|trace| trace.latest.clone()),
        }
    }

    /// What a later request may rely on: the proof, and the latest arrivals that it leaves.
    pub(crate) fn handed_on(&self) -> (Option<Proved>, Option<LatestArrivals>) {
        (self.reach.handed_on(), self.latest.clone())
    }

    /// The latest arrival, in time steps, that the proof leaves an agent in any plan that is as
    /// good; `None` where it leaves it any time.
    pub fn latest_arrival(&self, agent: usize) -> Option<u32> {
        let latest = self.latest.as_ref()?.of(agent);
        (latest < u32::MAX).then_some(latest)
    }
}

impl From<Reach> for ProvedBest {
    fn from(reach: Reach) -> Self {
        Self {
            reach,
            latest: None,
        }
    }
}
