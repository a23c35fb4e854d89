//! Facts of a set in groups, as a person thinks of them: a robot, robots among each other, a
//! shelf block, an aisle.

mod parts;
mod tightest;

use std::cmp::Reverse;
use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Costs, Instance, sorting::sort_by_key};
use serde::{Deserialize, Serialize};

use super::{
    answer::{Core, Helps},
    group::Group,
    group_mus::CoreFound,
};
use parts::Parts;

pub(crate) use tightest::tell_tightest;

/// A set of more facts is told in groups.
const FEW_FACTS: usize = 3;
/// So many groups are told at most.
pub const MOST_GROUPS: usize = 7;

/// What a group of facts is about.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum FactGroupKind {
    /// One agent: its task, waypoints, battery, breakdowns, and where it stays.
    Agent,
    /// Several agents, where there would be too many groups with one each.
    Agents,
    /// Agents among each other: they must not collide.
    Collisions,
    /// An aisle of one cell, with the obstacles on both sides.
    Aisle,
    /// A shelf block: obstacles that are connected.
    Shelf,
    /// Several shelf blocks, where there would be too many groups with one each.
    Shelves,
    /// A rule of the scene's own, slow zones, the floor of batteries, or the deadline.
    Rule,
    /// Several of these.
    Rules,
}

/// The one mark of a group of facts: what leaving out facts of it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupMark {
    /// Leaving one of its facts out alone would help.
    Helps,
    /// It is needed among the others: without it there is a plan of what is left.
    Needed,
    /// It may not be needed.
    Open,
}

/// Facts of one set that are told together.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct FactGroup {
    /// What they are about.
    pub kind: FactGroupKind,
    /// The agents that they are about, in the instance's order.
    pub agents: Vec<String>,
    /// The cells of an aisle, or the obstacles of a shelf block among the facts.
    pub cells: Vec<Cell>,
    /// The facts, by their places in the set.
    pub facts: Vec<u32>,
    /// The group as a phrase for people.
    pub text: String,
    /// Whether it is shown that the group is needed in the set: without it there is a plan.
    pub needed: bool,
    /// Whether leaving out one of its facts alone helps.
    pub helps: Helps,
    /// The least costs of the whole instance without one of its facts, as far as was tried.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub price: Option<FactPrice>,
}

impl FactGroup {
    /// What is known of it.
    pub const fn mark(&self) -> GroupMark {
        match self.helps {
            Helps::Yes => GroupMark::Helps,
            Helps::No | Helps::Unknown if self.needed => GroupMark::Needed,
            Helps::No | Helps::Unknown => GroupMark::Open,
        }
    }
}

/// The costs of the whole instance without one fact, with what the question asks for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct FactPrice {
    /// The fact, by its place in the set.
    pub fact: u32,
    /// The costs.
    pub costs: Costs,
    /// Whether it is proved that no plan costs less.
    pub proved: bool,
}

/// Costs without some facts, each alone, and whether they are proved least.
pub(crate) type Prices = BTreeMap<Group, (Costs, bool)>;

/// The facts of a set in groups, the deciding one first; none where there are few facts. `core`
/// has the facts for people.
pub(crate) fn fact_groups(instance: &Instance, found: &CoreFound, core: &Core) -> Vec<FactGroup> {
    if found.groups.len() <= FEW_FACTS || found.groups.len() != core.facts.len() {
        return Vec::new();
    }
    let mut parts = Parts::new(instance, &found.groups);
    parts.merge();
    let parts = parts.parts.iter();
    let mut told: Vec<FactGroup> = parts
        .map(|part| part.group(instance, found, core))
        .collect();
    let objective = instance.objective();
    sort_by_key(&mut told, |group| {
        let price = group.price.as_ref();
        let price = price.map(|price| price.costs.vector(objective));
        let facts = Reverse(group.facts.len());
        (
            group.helps != Helps::Yes,
            price.is_none(),
            price,
            group.kind,
            facts,
        )
    });
    told
}
