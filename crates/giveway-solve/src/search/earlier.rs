//! Optima of an instance with the same conditions or fewer, known before a search.

use super::for_ever::Proved;

/// The optima of the first costs of the same instance, without some or all of its conditions. A
/// condition only takes plans away, so no plan that meets more of them costs less.
#[derive(Clone, Debug)]
pub(crate) struct EarlierOptima(Vec<u32>);

/// One of these optima: no plan with the optima of the costs before it has less, at any horizon.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EarlierOptimum {
    least: u32,
}

impl EarlierOptima {
    /// The costs of a plan in the order of the objective, where it is proved at every horizon that
    /// none is better.
    pub(crate) fn of(costs: Vec<u32>, no_better: Proved) -> Option<Self> {
        no_better.is_complete().then_some(Self(costs))
    }

    /// That of the next cost, where the costs before it have the same optima here.
    pub(super) fn next(&self, optima: &[u32]) -> Option<EarlierOptimum> {
        let (before, rest) = self.0.split_at_checked(optima.len())?;
        let least = *rest.first()?;
        (before == optima).then_some(EarlierOptimum { least })
    }
}

impl EarlierOptimum {
    /// The least that a plan has.
    pub(super) const fn least(self) -> u32 {
        self.least
    }

    /// Whether it shows that no plan has less than this.
    pub(super) fn shows(self, bound: u32) -> Option<Self> {
        (bound <= self.least).then_some(self)
    }
}
