//! The plans of more and more robots, in the shape in which they are written as JSON.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Costs, Objective, Plan, Version, message::read_map};
use serde::{Deserialize, Serialize};

use crate::{Reach, Reason, Stats, Status};

/// Which of both floors a plan is of.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum SizingFloor {
    /// The floor of the request.
    This,
    /// The one that is compared with it.
    Beside,
}

/// The robot that needs the most steps alone.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct SlowestAlone {
    /// Its name.
    pub agent: String,
    /// The steps that it needs alone.
    pub steps: u32,
}

/// The best plan of so many robots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct SizingPoint {
    /// How many robots there are.
    pub robots: u32,
    /// The proved status.
    pub status: Status,
    /// The costs of the plan; `null` without one.
    pub costs: Option<Costs>,
    /// The proved lower bound of each cost of the objective reached so far.
    #[borsh(deserialize_with = "read_map")]
    pub bounds: BTreeMap<Cost, u32>,
    /// How far the claim reaches.
    #[serde(flatten)]
    pub reach: Reach,
    /// Why there is no plan or no proof; nothing in an answer that was read from JSON.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub reason: Option<Reason>,
    /// The sum of costs if each robot arrived as early as alone; `null` where one cannot.
    pub alone: Option<u32>,
    /// The robot that needs the most steps alone, the first of those that are alike.
    pub slowest: Option<SlowestAlone>,
    /// The plan.
    pub plan: Option<Plan>,
}

impl SizingPoint {
    /// The least sum of costs that is proved for plans that are best in the costs before it:
    /// that of a best plan, its own bound, or that of all robots alone.
    pub fn proved_sum(&self, objective: &Objective) -> Option<u32> {
        let is_asked = objective.costs().contains(&Cost::SumOfCosts);
        let best = self
            .costs
            .filter(|_| self.status == Status::Optimal && is_asked);
        let best = best.map(|costs| costs.sum_of_costs);
        let bound = self.bounds.get(&Cost::SumOfCosts).copied();
        best.or(bound).max(self.alone)
    }

    /// The mean delay of a robot against alone, in steps; and the least that is proved of it.
    pub fn mean_delay(&self, objective: &Objective) -> Option<(f64, f64)> {
        let (sum, alone) = (self.costs?.sum_of_costs, self.alone?);
        let mean = |sum: u32| f64::from(sum.saturating_sub(alone)) / f64::from(self.robots.max(1));
        Some((mean(sum), mean(self.proved_sum(objective)?.min(sum))))
    }

    /// How far the sum of costs may be from the best one: a share of what is proved.
    pub fn open_share(&self, objective: &Objective) -> Option<f64> {
        let (sum, proved) = (self.costs?.sum_of_costs, self.proved_sum(objective)?);
        let open = f64::from(sum.saturating_sub(proved));
        Some(if proved == 0 {
            0.0
        } else {
            open / f64::from(proved)
        })
    }
}

/// The answer to a request for plans of more and more robots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct SizingAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The costs by which plans are compared, the most important first.
    pub objective: Objective,
    /// The plans of the floor, by the number of robots.
    pub points: Vec<SizingPoint>,
    /// Those of the floor that is compared with it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub beside: Vec<SizingPoint>,
    /// How many plans are still to come; 0 at the end, more where the search was stopped.
    #[serde(default)]
    pub pending: u32,
    /// All of it in words.
    pub words: String,
    /// How much work it took.
    pub stats: Stats,
}
