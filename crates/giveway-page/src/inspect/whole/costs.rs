//! The costs of a plan, with what is proved of them.

use giveway_model::Cost;

use crate::words::title;

/// A cost of the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CostFacts {
    /// The cost.
    pub cost: Cost,
    /// Its name.
    pub title: &'static str,
    /// What the plan has; `None` without a plan.
    pub value: Option<u32>,
    /// The proved lower bound.
    pub at_least: Option<u32>,
    /// Whether it is one of those to be minimised.
    pub is_minimised: bool,
}

impl CostFacts {
    /// Whether it is proved that no plan has less.
    pub fn is_proved(&self) -> bool {
        self.value.is_some() && self.value == self.at_least
    }
}

/// The costs of which something is known, those of the objective first.
pub(super) fn costs(
    objective: &[Cost],
    known: impl Fn(Cost) -> (Option<u32>, Option<u32>),
) -> Vec<CostFacts> {
    let others = Cost::USUAL
        .into_iter()
        .filter(|cost| !objective.contains(cost));
    let all = objective.iter().copied().chain(others);
    let facts = all.map(|cost| {
        let (value, at_least) = known(cost);
        CostFacts {
            cost,
            title: title(cost),
            value,
            at_least,
            is_minimised: objective.contains(&cost),
        }
    });
    facts
        .filter(|facts| facts.value.is_some() || facts.at_least.is_some())
        .collect()
}
