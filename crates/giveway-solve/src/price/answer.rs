//! The prices of rules, in the shape in which they are written as JSON.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Constraint, Cost, Costs, Objective, Plan, Version, message::read_map};
use serde::{Deserialize, Serialize};

use crate::{Reach, Reason, Stats, Status, explain::Core};

/// The price of a rule.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Price {
    /// The best plan without it costs the same.
    Free,
    /// The best plan without it costs less.
    Costs,
    /// There is a plan without it, and none with it.
    Decides,
    /// There is no plan with it, and none without it.
    None,
    /// The budget ran out before it was known.
    #[default]
    Unknown,
}

/// A rule of the scene's own, with its price.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct RulePrice {
    /// Its number in the scene, from 0.
    pub index: u32,
    /// The kind of the constraint, as in files.
    pub kind: String,
    /// Its name, where it has one.
    pub name: Option<String>,
    /// The price.
    pub price: Price,
    /// Whether both sides are proved: optimal or impossible.
    pub exact: bool,
    /// The costs of the best plan without it, by cost of the objective.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[borsh(deserialize_with = "read_map")]
    pub without: BTreeMap<Cost, u32>,
    /// The costs with it minus those without it; a later one may be negative.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[borsh(deserialize_with = "read_map")]
    pub difference: BTreeMap<Cost, i64>,
    /// The cost of which `at_least` and `at_most` are, where it is not the first of the
    /// objective: in those before it both sides are proved equal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range_of: Option<Cost>,
    /// The least that it is proved to cost in the first cost of the objective, where the
    /// price is unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_least: Option<i64>,
    /// The most that it is proved to cost in that cost, where the price is unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_most: Option<i64>,
    /// The best plan without it that is known. No file has it: it is that of the scene in
    /// which the rule is off.
    #[serde(skip)]
    pub plan: Option<Plan>,
}

/// The least looser form of a rule that changes something, in one of the ways in which it
/// can ask for less.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct LooserRule {
    /// The rule as it would be.
    pub rule: Constraint,
    /// The costs of the best plan under it, by cost of the objective.
    #[borsh(deserialize_with = "read_map")]
    pub costs: BTreeMap<Cost, u32>,
    /// The costs with the rule as it is minus these; nothing where there is no plan with it.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[borsh(deserialize_with = "read_map")]
    pub difference: BTreeMap<Cost, i64>,
    /// Whether no plan under it is better.
    pub exact: bool,
    /// Whether every tighter form in this way is proved to change nothing.
    pub least: bool,
    /// That plan. No file has it: it is that of the scene with this rule.
    #[serde(skip)]
    pub plan: Option<Plan>,
}

/// How a rule can be loosened: where there is a plan, so that the costs change; where there
/// is none, so that there is one.
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Loosened {
    /// Its number in the scene, from 0.
    pub index: u32,
    /// Whether it has a number or times, so that it can ask for less.
    pub can_loosen: bool,
    /// The least looser form in each way that changes something.
    pub looser: Vec<LooserRule>,
    /// Whether every other way is proved to change nothing.
    pub settled: bool,
}

/// The fewest rules whose switching off leaves a plan, where all together leave none.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct SwitchOff {
    /// All sets of the fewest rules, by their numbers in the scene, ascending; none where
    /// there is no plan without any rule.
    pub switch_off: Vec<Vec<u32>>,
    /// Whether these are all of them for sure, and no set is smaller.
    pub switch_off_settled: bool,
}

/// The answer to a request for prices. On the way it comes with what is known so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct PriceAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The proved status of the scene with all rules that are in force.
    pub status: Status,
    /// The costs by which plans are compared, the most important first.
    pub objective: Objective,
    /// The costs of its plan.
    pub costs: Option<Costs>,
    /// How far the claim of the status reaches.
    #[serde(flatten)]
    pub reach: Reach,
    /// Why there is no plan or no proof; nothing in an answer that was read from JSON.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub reason: Option<Reason>,
    /// The plan that keeps all rules.
    pub plan: Option<Plan>,
    /// The rules in force with their prices, in the order of the scene.
    pub prices: Vec<RulePrice>,
    /// Rules and facts that exclude each other, where there is no plan: with all facts of
    /// the problem in force none of the rules can be left out.
    pub conflict: Option<Core>,
    /// The fewest rules whose switching off leaves a plan.
    #[serde(flatten)]
    pub switch_off: SwitchOff,
    /// How the rule can be loosened that the request names.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loosened: Option<Loosened>,
    /// How many prices are still to come; 0 at the end.
    #[serde(default)]
    pub pending: u32,
    /// All of it in words.
    pub words: String,
    /// How much work it took.
    pub stats: Stats,
}

impl PriceAnswer {
    /// Whether each price is exact.
    pub fn is_settled(&self) -> bool {
        self.pending == 0 && self.prices.iter().all(|price| price.exact)
    }
}
