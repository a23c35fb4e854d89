//! The answer about all best plans: what they share, and what is free to choose.
//!
//! A best plan is one with the least costs, compared in the order of the objective.
//! Each part tells item by item what is proved and what is open.

mod backbone;
mod critical;
mod known;
mod slack;
mod ways;

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Costs, Objective, Plan, Version, message::read_map};
use serde::{Deserialize, Serialize};

pub use backbone::{Shared, Visit, same_steps};
pub use critical::{Closed, CriticalCell, Need};
pub use known::{Known, PlanCount};
pub use slack::{Hold, Later, Slack};
pub use ways::{Farthest, Plans, Step, Ways};

use super::FreedomPart;
use crate::{Reach, Reason, Stats, Status};

/// Which plan an answer is about.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum About {
    /// The plan that was handed in.
    Given,
    /// None was handed in: the one that was found.
    Found,
    /// The one that was handed in is not a best plan: a better one that was found.
    Better,
}

/// The answer to a freedom request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct FreedomAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The proved status of the plan. The parts are about all best plans, so they are there only where it is
    /// `optimal`.
    pub status: Status,
    /// The costs by which plans are compared, the most important first.
    pub objective: Objective,
    /// Which plan the answer is about.
    pub about: About,
    /// The costs of the plan.
    pub costs: Option<Costs>,
    /// The plan.
    pub plan: Option<Plan>,
    /// The entries of each agent's path up to its arrival.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[borsh(deserialize_with = "read_optional_map")]
    pub backbone: Option<BTreeMap<String, Vec<Visit>>>,
    /// How many best plans there are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plans: Option<Plans>,
    /// Another best plan, as different from this one as can be.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub farthest: Option<Farthest>,
    /// How late each agent could be.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[borsh(deserialize_with = "read_optional_map")]
    pub slack: Option<BTreeMap<String, Slack>>,
    /// The cost of closing each free cell, in the order of the rows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub critical: Option<Vec<CriticalCell>>,
    /// The parts that are not finished: still to come, in an answer that is told on
    /// the way; in the end, those for which the budget did not suffice. Of a part
    /// under way there is what is known, and what is open in it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pending: Vec<FreedomPart>,
    /// How far what is said of all best plans reaches. Of closed cells each says so itself.
    #[serde(flatten)]
    pub reach: Reach,
    /// Why something is open; nothing in an answer that was read from JSON.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub reason: Option<Reason>,
    /// How much work it took.
    pub stats: Stats,
}

impl FreedomAnswer {
    /// Whether nothing that was asked for is open.
    pub fn is_settled(&self) -> bool {
        let settled = |known: Known| known != Known::Open;
        let visits = self.backbone.iter().flat_map(BTreeMap::values).flatten();
        let visits_settled = visits.into_iter().all(|visit| {
            let charge = visit.charge;
            settled(visit.always)
                && settled(visit.only)
                && charge.is_none_or(|it| settled(it.always) && settled(it.only))
        });
        let plans = self.plans.as_ref().is_none_or(|plans| {
            !matches!(plans.number, PlanCount::AtLeast(_))
                && plans.ways.values().all(|ways| settled(ways.all))
        });
        let farthest = match &self.farthest {
            Some(Farthest::Unknown) => false,
            Some(Farthest::Found { most, .. }) => settled(*most),
            Some(Farthest::Only) | None => true,
        };
        let slacks = self.slack.iter().flat_map(BTreeMap::values);
        let slack = slacks
            .into_iter()
            .all(|slack| matches!(slack.arrival, Later::Exactly(_)));
        let cells = self.critical.iter().flatten();
        let critical = cells.into_iter().all(|cell| !cell.closed.is_open());
        let decided = matches!(self.status, Status::Optimal | Status::Impossible);
        decided
            && self.pending.is_empty()
            && visits_settled
            && plans
            && farthest
            && slack
            && critical
    }
}

/// Reads a map that may be missing.
fn read_optional_map<K, V, R>(reader: &mut R) -> borsh::io::Result<Option<BTreeMap<K, V>>>
where
    K: BorshDeserialize + Ord,
    V: BorshDeserialize,
    R: borsh::io::Read,
{
    if bool::deserialize_reader(reader)? {
        read_map(reader).map(Some)
    } else {
        Ok(None)
    }
}
