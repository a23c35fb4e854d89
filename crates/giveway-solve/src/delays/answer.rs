//! The delays of a plan, in the shape in which they are written as JSON.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Cost, Costs, Objective, Plan, Version, message::read_map};
use serde::{Deserialize, Serialize};

use super::Fraction;
use crate::{Reach, Reason, Stats};

/// Whom, or what, an agent lets pass.
#[derive(
    Clone,
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
#[serde(tag = "because", rename_all = "kebab-case")]
pub enum DelayCause {
    /// Another agent.
    Agent {
        /// Its name.
        agent: String,
    },
    /// A rule of the scene's own among agents.
    Rule {
        /// Its number in the scene, from 0; rules that changes added come after those.
        index: u32,
        /// The kind of the constraint, as in files.
        kind: String,
        /// Its name, where it has one.
        name: Option<String>,
        /// The rule in words.
        text: String,
    },
    /// Nobody: the agent could arrive as soon as alone, all others as they are.
    Nobody,
}

/// One of the even parts of a delay.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Share {
    /// Whom the agent lets pass.
    #[serde(flatten)]
    pub cause: DelayCause,
    /// Its part of the delay, in steps.
    pub steps: Fraction,
}

/// What an agent or a rule costs all others together.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct CauseTotal {
    /// The agent or the rule.
    #[serde(flatten)]
    pub cause: DelayCause,
    /// The steps; `null` where the fraction has too large numbers.
    pub steps: Option<Fraction>,
}

/// Steps that are lost at a cell.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct CellLoss {
    /// The cell.
    pub cell: Cell,
    /// The steps.
    pub steps: u32,
}

/// Steps that an agent loses at a place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct AgentLoss {
    /// The agent.
    pub agent: String,
    /// The steps.
    pub steps: u32,
}

/// An agent's row of the ledger.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct AgentDelay {
    /// The agent.
    pub agent: String,
    /// Its arrival in the plan.
    pub arrival: u32,
    /// Its least arrival alone: its waypoints, battery and own rules kept. After a change what
    /// lies in the past is kept, too: breakdowns, and a gap to where others were before.
    pub alone: u32,
    /// Its delay: the arrival less that.
    pub delay: u32,
    /// The even parts of the delay, by whom it lets pass: agents in the order of the scene, then
    /// rules. They add up to the delay. Without a delay there are none.
    pub because: Vec<Share>,
    /// The cells at which it loses steps, in the order of the plan. They add up to the delay.
    pub lost: Vec<CellLoss>,
}

/// A longest run of neighbouring cells of a row or a column at each of which a step is lost.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct LossPlace {
    /// The cells, from left to right or from top to bottom.
    pub cells: Vec<Cell>,
    /// The steps lost at them.
    pub steps: u32,
    /// Who loses them; who loses most is the first.
    pub agents: Vec<AgentLoss>,
}

/// How many steps every plan loses.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct DelayProof {
    /// The costs that stand before the sum of costs in the objective, or all where it does not
    /// stand there, as the plan has them: this is about the plans that have no more of these.
    #[borsh(deserialize_with = "read_map")]
    pub given: BTreeMap<Cost, u32>,
    /// The least that each of these plans is proved to lose, in steps.
    pub at_least: u32,
    /// What the best of these plans that is known loses.
    pub at_most: u32,
    /// How far that proof reaches. Where the makespan is given, it is about all such plans.
    #[serde(flatten)]
    pub reach: Reach,
}

/// The answer to a request for delays. On the way it comes without the proof.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct DelaysAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The costs by which plans are compared, the most important first.
    pub objective: Objective,
    /// The time of the last change of the world, from which on agents are compared with their
    /// ways alone; left out where there was none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub since: Option<u32>,
    /// The costs of the plan; `null` without one.
    pub costs: Option<Costs>,
    /// The sum of costs if each agent arrived as early as alone.
    pub alone: u32,
    /// The delay of all agents: their sum of costs less that.
    pub delay: u32,
    /// A row for each agent: who loses most is the first, others in the order of the scene.
    pub agents: Vec<AgentDelay>,
    /// Who costs others how much: who costs most is the first. They add up to the delay.
    pub because: Vec<CauseTotal>,
    /// The steps lost at each cell, row by row. They add up to the delay.
    pub lost: Vec<CellLoss>,
    /// The three places at which most is lost, the worst first; no cell is in two of them.
    pub places: Vec<LossPlace>,
    /// How many steps every plan loses; `null` where nothing was asked or found.
    pub proof: Option<DelayProof>,
    /// The plan that was found, where none was handed in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// The calm plan by which the delays are split, where it is not the plan itself: each agent
    /// arrives in it at the same time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calm: Option<Plan>,
    /// Why there is no ledger; nothing in an answer that was read from JSON.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub reason: Option<Reason>,
    /// Whether the proof is still to come.
    #[serde(default)]
    pub pending: bool,
    /// All of it in words.
    pub words: String,
    /// How much work it took.
    pub stats: Stats,
}
