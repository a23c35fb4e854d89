//! What is proved of an instance, and how far a plan is from it.

use std::fmt;

use giveway_model::Cost;

use crate::{Row, RowStatus};

/// What is known of an instance from all rows of it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Known {
    /// The largest lower bound that is proved for every horizon.
    pub(super) bound: Option<u32>,
    /// Whether a plan of that cost was found by who proves.
    pub(super) is_proved: bool,
    /// Whether it is proved that there is no plan.
    pub(super) is_impossible: bool,
}

impl Known {
    /// Learns from a row. What was proved of plans within a horizon says nothing of others.
    pub(super) fn learn(&mut self, row: &Row, cost: Option<Cost>) {
        if row.within.is_some() {
            return;
        }
        let bound = cost.and_then(|cost| row.bounds.get(&cost).copied());
        self.bound = self.bound.max(bound);
        let is_proof = row.complete && row.planner.proves();
        self.is_proved |= is_proof && row.status == RowStatus::Optimal;
        self.is_impossible |= row.complete && row.status == RowStatus::Impossible;
    }
}

/// How far a cost is above a bound, in tenths of a percent of the bound, rounded up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::table) struct Gap(u64);

impl Gap {
    /// The gap; `None` where the bound is 0 and the cost is not.
    pub(super) fn new(cost: u32, bound: u32) -> Option<Self> {
        let over = u64::from(cost.saturating_sub(bound));
        match bound {
            0 => (over == 0).then_some(Self(0)),
            bound => Some(Self((1000 * over).div_ceil(u64::from(bound)))),
        }
    }

    /// In percent.
    pub(super) fn percent(self) -> f64 {
        self.0 as f64 / 10.0
    }

    /// The one in the middle, the larger of two.
    pub(super) fn median(mut gaps: Vec<Self>) -> Option<Self> {
        gaps.sort_unstable();
        gaps.get(gaps.len() / 2).copied()
    }
}

/// In percent, without its sign.
impl fmt::Display for Gap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            0 => f.write_str("0"),
            tenths => write!(f, "{}.{}", tenths / 10, tenths % 10),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_rounded_up() {
        let told = |cost, bound| Gap::new(cost, bound).map(|gap| gap.to_string());
        assert_eq!(told(100, 100).as_deref(), Some("0"));
        assert_eq!(told(100_001, 100_000).as_deref(), Some("0.1"));
        assert_eq!(told(103, 100).as_deref(), Some("3.0"));
        assert_eq!(told(7, 3).as_deref(), Some("133.4"));
        assert_eq!(told(0, 0).as_deref(), Some("0"));
        assert_eq!(told(1, 0), None);
        let gaps = [1, 4, 2, 3].map(Gap).to_vec();
        assert_eq!(Gap::median(gaps), Some(Gap(3)));
        assert_eq!(Gap::median(Vec::new()), None);
    }
}
