//! What sets of agents alone need: bounds on what all agents need together.

mod needs;
mod tight;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Question};
use serde::{Deserialize, Serialize};

pub(crate) use tight::{forcing_bound, subset_bounds};

use super::Verdict;

/// What some agents alone need: with only these in the scene, no plan costs less. So the plans of
/// all agents cost no less, either. After a change all three costs are of the whole plan, with what
/// was paid before.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct SubsetBound {
    /// The agents, in the instance's order.
    pub agents: Vec<String>,
    /// The cost.
    pub cost: Cost,
    /// What they need where each is alone: the most of one for the makespan, else the sum.
    pub own: u32,
    /// What they need together, proved.
    pub least: u32,
    /// What they have in the plan that is asked about, or in the other plan where that costs more
    /// of this and no more of what matters more.
    pub here: u32,
}

impl SubsetBound {
    /// What they need beyond what each needs alone.
    pub const fn lost(&self) -> u32 {
        self.least.saturating_sub(self.own)
    }

    /// The first of `bounds` if its agents, fewer than all `count`, alone force the makespan of the
    /// plan, where that is what is asked about and proved.
    pub fn forcing<'a>(
        bounds: &'a [SubsetBound],
        question: &Question,
        verdict: Verdict,
        makespan: u32,
        count: usize,
    ) -> Option<&'a SubsetBound> {
        let first = bounds.first()?;
        let is_asked = *question == Question::Makespan && verdict == Verdict::Necessary;
        (is_asked && first.least == makespan && first.agents.len() < count).then_some(first)
    }
}
