//! Two plans of one instance, compared: what each costs, and which agents go
//! another way or at another time.

mod claim;
mod claimed;
mod claimed_bounds;
mod difference;

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::check::{arrivals, costs};
use crate::message::read_map;
use crate::{Cost, Costs, Instance, Plan, Version};

pub use claim::{Claimed, ClaimedBounds};
pub use claimed::{ClaimedCost, Definition, claims};
pub use claimed_bounds::{Bounded, ClaimedBound, claimed_bounds, claimed_loss};
pub use difference::{Difference, Divergence, divergence};

/// Two plans of one instance, side by side.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Comparison {
    /// The format's version.
    pub giveway: Version,
    /// The costs of both; `null` where an agent has no path.
    pub costs: [Option<Costs>; 2],
    /// How much more the second one has of each cost; empty where one of them has
    /// no costs.
    #[borsh(deserialize_with = "read_map")]
    pub deltas: BTreeMap<Cost, i64>,
    /// Every agent, in the order of the instance.
    pub agents: Vec<AgentComparison>,
}

/// The difference of one agent.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct AgentComparison {
    /// Its name.
    pub agent: String,
    /// Whether it goes elsewhere, or at other times.
    pub difference: Difference,
    /// When it arrives in each plan; `null` where it has no path.
    pub arrivals: [Option<u32>; 2],
    /// Where the plans part; `null` where they are the same.
    pub first: Option<Divergence>,
}

impl Comparison {
    /// The agents with this difference.
    pub fn with(&self, difference: Difference) -> impl Iterator<Item = &AgentComparison> {
        let agents = self.agents.iter();
        agents.filter(move |agent| agent.difference == difference)
    }
}

/// Compares two plans. Repeats of a goal at the end of a path count for nothing.
///
/// ```
/// use giveway_model::{compare::{Difference, compare}, format::native};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": [".."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [1, 0] }]
/// }"#).unwrap();
/// let plan = |path| {
///     native::read_plan(&format!(r#"{{ "giveway": 1, "paths": {{ "A1": {path} }} }}"#)).unwrap()
/// };
/// let compared = compare(&instance, &plan("[[0,0],[1,0]]"), &plan("[[0,0],[0,0],[1,0]]"));
/// assert_eq!(compared.agents[0].difference, Difference::Retimed);
/// assert_eq!(compared.agents[0].first.map(|first| first.time), Some(1));
/// ```
pub fn compare(instance: &Instance, one: &Plan, other: &Plan) -> Comparison {
    let plans = [one, other].map(|plan| {
        let mut plan = plan.clone();
        plan.cut_trailing_goals(instance);
        plan
    });
    let both = [&plans[0], &plans[1]];
    let arrivals = both.map(|plan| arrivals(instance, plan));
    let agents = instance.agents().iter().enumerate();
    let agents = agents.map(|(i, agent)| {
        let name = agent.name.as_str();
        let entries = both.map(|plan| (plan.path(name), plan.charges(name)));
        AgentComparison {
            agent: name.to_owned(),
            difference: Difference::between(entries[0], entries[1]),
            arrivals: [0, 1].map(|side: usize| arrivals[side].get(i).copied().flatten()),
            first: divergence(entries[0], entries[1], instance.keeps(agent)),
        }
    });
    let agents = agents.collect();
    let costs = both.map(|plan| costs(instance, plan));
    Comparison {
        giveway: Version,
        deltas: deltas(&costs),
        costs,
        agents,
    }
}

fn deltas(costs: &[Option<Costs>; 2]) -> BTreeMap<Cost, i64> {
    let mut deltas = BTreeMap::new();
    if let [Some(one), Some(other)] = costs {
        for cost in Cost::USUAL {
            deltas.insert(cost, i64::from(other.get(cost)) - i64::from(one.get(cost)));
        }
    }
    deltas
}
