//! A question to the service, and its answer as far as it is known.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{
    Cost, Costs, Objective, Plan, Question, Scene, Version, change::Changes, check::Violation,
    format::from_object, message::read_map,
};
use serde::{Deserialize, Serialize};

use super::{
    AgentDifference, Core, Excess, Here, How, Layer, Near, Repair, SubsetBound, WitnessEntry,
};
use crate::{Limits, ProvedBest, Reach, Stats};

/// Answer a question about a plan, or about there being none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct ExplainRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The plan that is asked about, unchecked; without one the instance is
    /// solved first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// The changes of the world while the plan ran. The question is then about the time from the last of
    /// these changes on, and the past is taken as it is. Times in the question are those of the whole plan.
    /// To ask why there is no way to go on (`unsolvable`), the plan is the one that ran until then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changes: Option<Changes>,
    /// The time that is looked at: later changes do not count, and the plan must
    /// be right without them. All changes count where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<u32>,
    /// The question.
    pub question: Question,
    /// The objective, where it is not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon, in time steps; never less than the plan's makespan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// What the front that asks had proved: that no plan is better than `plan`, by an answer
    /// to the same scene, objective and horizon. It is not proved again. Only programs of the
    /// same build hand it on; no file has it.
    #[serde(skip)]
    pub proved: Option<ProvedBest>,
    /// A plan that an earlier answer about `plan` found: the other plan is no worse than this one
    /// where it is as asked for, which is checked. No file has it.
    #[serde(skip)]
    pub known: Option<Plan>,
    /// The layers of the answer, each with those of `whole`, `reason` and `help` before it; without
    /// any these three.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// The budget for all parts of the answer together.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

/// The result of the comparison with the best contrasting plan.
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
pub enum Verdict {
    /// The best other plan costs the same: it need not be so.
    Needless,
    /// It costs less: the plan was not optimal.
    Improvable,
    /// It costs more.
    Costly,
    /// There is no other plan: none at all, or none within the horizon.
    Necessary,
    /// The budget ran out.
    Unknown,
}

/// A part of an answer.
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
pub enum Part {
    /// What the plan shows.
    Here,
    /// Small variations of the plan.
    Near,
    /// The verdict with an other plan.
    Verdict,
    /// The other plan closest to the one asked about.
    Closest,
    /// The witness: what would happen.
    Witness,
    /// The facts that rule it out.
    Core,
    /// The edits that would help.
    Repairs,
}

/// The answer to a question. On the way it comes with what is known so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct ExplainAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The question.
    pub question: Question,
    /// The time from which it is answered, where the world changed before: no
    /// other plan differs before it. It is the time of the last change, or the
    /// first later one at which no agent is half way along a slow move. All times, costs and plans are those of the whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub since: Option<u32>,
    /// The plan asked about, where the request had none; `null` where there is
    /// none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// What the plan shows, where that layer is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub here: Option<Here>,
    /// Small variations of the plan, where that layer is asked for; until there is a verdict,
    /// `alternative` is the cheapest of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub near: Option<Near>,
    /// The verdict. Of `unsolvable` it is `necessary` where there is indeed no
    /// plan; of `plan` it is `needless` where the plan is optimal, `improvable`
    /// where it is not.
    pub verdict: Verdict,
    /// The costs of the other plan.
    pub costs: Option<Costs>,
    /// The difference of the other plan to the plan asked about, for each cost of the objective.
    /// On a large floor a verdict may stand while `closest` is still to come: then they only fall.
    #[borsh(deserialize_with = "read_map")]
    pub deltas: BTreeMap<Cost, i64>,
    /// Of `costly`: whether the first delta that is not 0 is only an upper bound. Every other plan
    /// costs more than the plan asked about, but one may cost less than the one that is known.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub at_most: bool,
    /// How far the verdict reaches.
    #[serde(flatten)]
    pub reach: Reach,
    /// The other plan.
    pub alternative: Option<Plan>,
    /// Whether it is proved that no other best plan is closer.
    pub closest: bool,
    /// Of `needless`: how the other plan does without it. `free` is there only alone.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub how: Vec<How>,
    /// The agents that the other plan moves differently; who arrives later by most is the first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pays: Vec<AgentDifference>,
    /// The witness: what would happen.
    pub witness: Vec<WitnessEntry>,
    /// The facts that together make it impossible, or so costly.
    pub core: Option<Core>,
    /// What sets of agents alone need, the set that needs most beyond the needs of each first: for
    /// a question about a cost of the whole plan, or where no small set of facts was found.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub alone: Vec<SubsetBound>,
    /// The edits that would help, the best first.
    pub repairs: Vec<Repair>,
    /// How many more repairs help than are told.
    pub further_repairs: u32,
    /// Whether all repairs of one or two edits were tried, each to its end. Pairs
    /// are those of edits of which neither helps alone.
    pub exhaustive: bool,
    /// Of `plan`: whether it breaks no rule.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub valid: Option<bool>,
    /// Of `plan`: the rules that it breaks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub violations: Option<Vec<Violation>>,
    /// Of `plan`: whether it is proved that none is better.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub optimal: Option<bool>,
    /// Of `plan`: what its agents have more of than in a better plan.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub excess: Vec<Excess>,
    /// The parts that are not there yet; none at the end.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pending: Vec<Part>,
    /// All of it in words.
    pub words: String,
    /// How much work it took.
    pub stats: Stats,
}

impl ExplainAnswer {
    /// An answer of which nothing is known yet.
    pub(super) fn empty(question: &Question) -> Self {
        Self {
            giveway: Version,
            question: question.clone(),
            since: None,
            plan: None,
            here: None,
            near: None,
            verdict: Verdict::Unknown,
            costs: None,
            deltas: BTreeMap::new(),
            at_most: false,
            reach: Reach::default(),
            alternative: None,
            closest: false,
            how: Vec::new(),
            pays: Vec::new(),
            witness: Vec::new(),
            core: None,
            alone: Vec::new(),
            repairs: Vec::new(),
            further_repairs: 0,
            exhaustive: false,
            valid: None,
            violations: None,
            optimal: None,
            excess: Vec::new(),
            pending: Vec::new(),
            words: String::new(),
            stats: crate::Stats::default(),
        }
    }
}
