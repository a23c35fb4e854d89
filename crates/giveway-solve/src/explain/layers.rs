//! The layers of an answer, the quickest first, and what the two quickest of them tell.

use std::collections::BTreeMap;
use std::str::FromStr;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Cost, Costs, Plan, check::Violation, message::read_map, tr};
use serde::{Deserialize, Serialize};

use super::{AgentDifference, Part};

/// A layer of an answer. Each stands as soon as it is there.
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
pub enum Layer {
    /// What the plan shows: who comes through, and what would happen if only this changed.
    Here,
    /// Small variations of the plan, with what each costs and who pays.
    Near,
    /// The verdict, and the closest other plan.
    Whole,
    /// What would happen, and the facts that force it.
    Reason,
    /// The edits that would help.
    Help,
}

impl Layer {
    /// All of them, in their order.
    pub const ALL: [Self; 5] = [
        Self::Here,
        Self::Near,
        Self::Whole,
        Self::Reason,
        Self::Help,
    ];

    /// Its name in requests and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Here => "here",
            Self::Near => "near",
            Self::Whole => "whole",
            Self::Reason => "reason",
            Self::Help => "help",
        }
    }

    /// The parts of an answer about a plan that layers have, in their order; without layers
    /// those of an answer to a request that names none. A layer needs the whole of those before
    /// it, but for `here` and `near`.
    pub(super) fn parts(layers: &[Self]) -> Vec<Part> {
        let is_wanted = |part: &Part| {
            let named = |layer| layers.contains(&layer);
            let (help, reason, whole) =
                (named(Self::Help), named(Self::Reason), named(Self::Whole));
            match part {
                Part::Here => named(Self::Here),
                Part::Near => named(Self::Near),
                Part::Verdict | Part::Closest => layers.is_empty() || whole || reason || help,
                Part::Witness | Part::Core => layers.is_empty() || reason || help,
                Part::Repairs => layers.is_empty() || help,
            }
        };
        let all = [
            Part::Here,
            Part::Near,
            Part::Verdict,
            Part::Closest,
            Part::Witness,
            Part::Core,
            Part::Repairs,
        ];
        all.into_iter().filter(is_wanted).collect()
    }
}

impl FromStr for Layer {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let layer = Self::ALL.into_iter().find(|layer| layer.name() == text);
        layer.ok_or_else(|| tr!("expected here, near, whole, reason or help").to_owned())
    }
}

/// What the plan shows where something is asked about, without any search among plans.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Here {
    /// The agent that would do otherwise.
    pub agent: String,
    /// Of a wait: who uses the agent's further way meanwhile, the first cell of the way first.
    pub passing: Vec<Passing>,
    /// The rules that would be broken if only this changed, all others as in the plan.
    pub violations: Vec<Violation>,
    /// All of it in words.
    pub words: String,
}

/// The most robots that a sentence names.
pub(super) const MOST_NAMED: usize = 3;

impl Here {
    /// Who is let pass, as the sentence names them: those that come through and would be met.
    pub fn let_pass(&self) -> impl Iterator<Item = &String> {
        let is_met = |name: &&String| self.violations.iter().any(|it| it.agents.contains(name));
        let passing = self.passing.iter().map(|it| &it.agent);
        passing.filter(is_met).take(MOST_NAMED)
    }
}

/// An agent that uses a cell of another agent's further way while that one waits.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Passing {
    /// The agent that comes through.
    pub agent: String,
    /// The first cell of the way that it uses.
    pub cell: Cell,
    /// When it is there first during the wait.
    pub time: u32,
}

/// Small variations of the plan that are as asked for. Each passed the judge.
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub struct Near {
    /// The variations, the cheapest first in the order of the objective.
    pub variations: Vec<Variation>,
    /// The costs of the cheapest: the best other plan costs no more. It only falls.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_most: Option<Costs>,
    /// All of it in words.
    pub words: String,
}

/// How a variation differs from the plan.
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
pub enum VariationKind {
    /// The wait is made at an earlier or later place of the way.
    Elsewhere,
    /// The agent takes another way, all others do as in the plan, or only later.
    OtherWay,
    /// The agent goes before another, which waits.
    Swapped,
    /// Several agents move otherwise.
    Others,
}

/// A plan near to the one that is asked about.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Variation {
    /// How it differs.
    pub kind: VariationKind,
    /// Of `swapped`: the agent that waits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other: Option<String>,
    /// Of `elsewhere`: where the agent waits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell: Option<Cell>,
    /// Of `elsewhere`: when the wait begins.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<u32>,
    /// Its costs.
    pub costs: Costs,
    /// The difference to the plan that is asked about, for each cost of the objective.
    #[borsh(deserialize_with = "read_map")]
    pub deltas: BTreeMap<Cost, i64>,
    /// The agents that move differently; who arrives later by most is the first.
    pub pays: Vec<AgentDifference>,
    /// The paths and charges of these agents alone; all others do as in the plan.
    pub plan: Plan,
    /// The variation in words.
    pub text: String,
}
