//! An unsatisfiable core as a claim about agents, which is true by itself.
//!
//! A core says that some limits cannot all be kept: each by one agent, or by several
//! together. It says so of plans of all agents, whatever the others do, and under the
//! [`Scope`] that comes with it.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, message::read_map};
use serde::{Deserialize, Serialize};

/// Limits that no plan keeps all at once, so that the bound rises.
///
/// Two claims. The first is the core itself: all of `limits` and `sums` together
/// cannot be kept. The second, `together`, follows from it and from the cores that
/// it builds on, and needs no other event to be understood.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Core {
    /// The cost that is bounded.
    pub cost: Cost,
    /// Agents that have a limit each. Where `sums` is empty, this is the whole core:
    /// these agents cannot all keep their limits.
    pub limits: Vec<AgentLimit>,
    /// Earlier cores of which no more than so many limits may be broken.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sums: Vec<EarlierCore>,
    /// The sum of all agents that this core and those below it name; `null` for the makespan, which is no
    /// sum.
    pub together: Option<Together>,
    /// Of which plans this is so.
    #[serde(rename = "condition", default, skip_serializing_if = "Scope::is_empty")]
    pub scope: Scope,
    /// The bound before.
    pub from: u32,
    /// The bound from now on.
    pub to: u32,
    /// Its size.
    pub literals: Literals,
    /// Conflicts that it took to find it and to make it smaller; 0 where it was
    /// found together with the one before.
    pub took: u64,
}

/// An agent and the most that it may have of a cost. Of the makespan and the sum of
/// costs this is a time: it arrives by then.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct AgentLimit {
    /// The agent.
    pub agent: String,
    /// The least that it needs alone.
    pub least: u32,
    /// The most that it may have; the same as `least` where it is to be on time.
    pub at_most: u32,
}

/// An earlier core, of which so many limits at the most may be broken.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct EarlierCore {
    /// The number of its event.
    pub event: u64,
    /// How many of its limits may be broken.
    pub at_most: u32,
}

/// The sum that some agents need together beyond the least of each.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Together {
    /// The agents, with the least of each alone.
    pub agents: Vec<AgentLeast>,
    /// How much more than the sum of these they need together at the least: late
    /// steps, charges, moves or waits. One less is not enough.
    pub more: u32,
}

/// The least of a cost that an agent needs alone.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct AgentLeast {
    /// The agent.
    pub agent: String,
    /// The least.
    pub least: u32,
}

/// Of which plans a claim is made; of all where nothing is said.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(default)]
pub struct Scope {
    /// Plans that have these costs: the optima of earlier phases.
    #[borsh(deserialize_with = "read_map")]
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub given: BTreeMap<Cost, u32>,
    /// Plans that have at most this much of the cost that is bounded: those as good
    /// as the best one so far, or better ones. What only worse plans do was excluded
    /// before, and may have had a part in the proof.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_most: Option<u32>,
    /// Plans of at most this makespan: the horizon may have had a part in the proof.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// Plans of all agents: others than those named were in the formula, and that
    /// they have to be somewhere may have had a part in the proof. Where this is
    /// false, the claim holds of the named agents by themselves, too.
    #[serde(skip_serializing_if = "is_false")]
    pub others: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_false(value: &bool) -> bool {
    !*value
}

impl Scope {
    /// Whether the claim is made of all plans, even of the named agents alone.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// The size of a core in literals.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Literals {
    /// As the SAT solver first stated it.
    pub before: u32,
    /// After it was verified and made smaller.
    pub after: u32,
}
