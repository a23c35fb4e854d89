//! Claims that rest on a search: which searches are tried, and whether one shows a claim.

use giveway_model::{Cost, Instance};

use crate::bundle::Method;
use crate::exhaust::{Exhausted, alone_at_least, exhaust_kind};
use crate::queue::counted_at_least;
use crate::{Budget, Claim};

/// More agents than this have too many states together to try.
const FEW_AGENTS: usize = 3;
/// With fewer agents, nothing is counted.
const FEWEST_AT_GATE: usize = 2;

impl Method {
    /// The searches that are worth trying, the smallest first.
    pub(crate) fn try_in_turn(instance: &Instance) -> impl Iterator<Item = Self> {
        let joint = instance.agents().len() <= FEW_AGENTS;
        [Self::Alone, Self::Counting]
            .into_iter()
            .chain(joint.then_some(Self::Joint))
    }

    /// Whether this search shows a claim; `None` where the budget ran out. Of agents
    /// alone it shows that there is no plan, whatever the condition.
    pub(crate) fn shows(
        self,
        instance: &Instance,
        claim: &Claim,
        budget: &Budget<'_>,
    ) -> Option<bool> {
        match self {
            Self::Joint => match exhaust_kind(instance, claim, budget) {
                Exhausted::NoPlan => Some(true),
                Exhausted::Plan(_) => Some(false),
                Exhausted::Stopped => None,
            },
            Self::Counting => counts(instance, claim, FEWEST_AT_GATE, budget),
            Self::Alone if claim.most.is_empty() => {
                // An agent that cannot arrive even alone costs more than anything.
                alone_at_least(instance, Cost::Makespan, u32::MAX, budget)
            }
            Self::Alone => {
                // One limit that the agents break each alone is enough.
                let mut shown = Some(false);
                for (&cost, &most) in &claim.most {
                    // More than the largest number nothing costs.
                    let Some(more) = most.checked_add(1) else {
                        continue;
                    };
                    match alone_at_least(instance, cost, more, budget) {
                        Some(true) => return Some(true),
                        Some(false) => {}
                        None => shown = None,
                    }
                }
                shown
            }
        }
    }
}

/// Whether counting at a bottleneck with at least so many agents shows a claim: it is enough that one
/// limit cannot be kept, whatever else the plans of the claim have to keep.
pub(crate) fn counts(
    instance: &Instance,
    claim: &Claim,
    fewest: usize,
    budget: &Budget<'_>,
) -> Option<bool> {
    let within = claim.most.get(&Cost::Makespan).copied();
    for (&cost, &most) in &claim.most {
        if let Some(more) = most.checked_add(1)
            && counted_at_least(instance, (cost, more), within, fewest, budget)?
        {
            return Some(true);
        }
    }
    Some(false)
}
