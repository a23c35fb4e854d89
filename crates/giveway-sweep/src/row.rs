//! How one task ended: one line of JSON.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Objective, Version};
use serde::{Deserialize, Serialize};

use crate::{Method, RowCertificate, Task};

/// How a task ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RowStatus {
    /// A plan, and a proof that no plan is better; of a planner of the textbook: that none
    /// has less of the first cost.
    Optimal,
    /// A plan.
    Feasible,
    /// No plan exists.
    Impossible,
    /// The budget ran out with neither.
    Unknown,
    /// A planner of others did not solve it.
    Failed,
    /// The planner has no method for something in the instance.
    Refused,
    /// The instance cannot be read, or is none.
    Error,
    /// Not tried, since smaller numbers of agents had no optimal answer.
    Skipped,
}

impl RowStatus {
    /// As it stands in files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Optimal => "optimal",
            Self::Feasible => "feasible",
            Self::Impossible => "impossible",
            Self::Unknown => "unknown",
            Self::Failed => "failed",
            Self::Refused => "refused",
            Self::Error => "error",
            Self::Skipped => "skipped",
        }
    }
}

/// Why a planner of others did not solve a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Failure {
    /// It ended with an error, or by a signal.
    Crashed,
    /// It was ended, since its time was over.
    Time,
    /// It held more memory than it may.
    Memory,
    /// Its plan breaks a rule.
    Illegal,
    /// Its plan is legal, and costs something else than it says.
    WrongCost,
    /// It wrote nothing, or says itself that it found no plan.
    Nothing,
    /// What it wrote cannot be read as a plan.
    Unreadable,
}

impl Failure {
    /// All of them, in the order of tables.
    pub const ALL: [Self; 7] = [
        Self::Crashed,
        Self::Time,
        Self::Memory,
        Self::Illegal,
        Self::WrongCost,
        Self::Nothing,
        Self::Unreadable,
    ];

    /// As it stands at the head of a column.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Crashed => "crashed",
            Self::Time => "time",
            Self::Memory => "memory",
            Self::Illegal => "illegal",
            Self::WrongCost => "wrong cost",
            Self::Nothing => "nothing",
            Self::Unreadable => "unreadable",
        }
    }
}

/// What a task took. Nothing else of a row differs from run to run, but where a budget of
/// seconds runs out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Took {
    /// CPU seconds.
    pub cpu_seconds: f64,
    /// Wall seconds.
    pub wall_seconds: f64,
    /// CPU seconds to make its certificate and to check it, which are not among the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate_cpu_seconds: Option<f64>,
    /// The most bytes of memory that a planner of others held at once, where that is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_bytes: Option<u64>,
}

/// One result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The format's version.
    pub giveway: Version,
    /// The name of its task, which no other task has.
    pub task: String,
    /// The path of the instance.
    pub instance: String,
    /// The name of the map, where the instance is a scenario.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map: Option<String>,
    /// How many agents took part; `null` where the instance cannot be read.
    pub agents: Option<usize>,
    /// What was minimised.
    pub objective: Option<Objective>,
    /// Who planned.
    pub planner: Method,
    /// How it ended.
    pub status: RowStatus,
    /// Whether the claim holds whatever the horizon.
    pub complete: bool,
    /// The makespan up to which it was proved otherwise.
    pub within: Option<u32>,
    /// All five costs of the plan.
    pub costs: Option<Costs>,
    /// The proved lower bounds.
    pub bounds: BTreeMap<Cost, u32>,
    /// Why a planner of others failed; the reason tells how.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
    /// A few words about a planner of others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// Why there is no plan or no proof, as a sentence.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Its certificate, where one was wanted and there is an answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<RowCertificate>,
    /// What it took.
    pub took: Took,
}

impl Row {
    /// A row that says no more than how it ended.
    pub(crate) fn bare(task: &Task, status: RowStatus, reason: Option<String>) -> Self {
        Self {
            giveway: Version,
            task: task.name(),
            instance: task.instance.clone(),
            map: None,
            agents: task.agents,
            objective: task.objective.clone(),
            planner: task.planner.clone(),
            status,
            complete: false,
            within: None,
            costs: None,
            bounds: BTreeMap::new(),
            failure: None,
            about: task.command.as_ref().and_then(|spec| spec.about.clone()),
            reason,
            certificate: None,
            took: Took::default(),
        }
    }

    /// What was not tried.
    pub fn skipped(task: &Task) -> Self {
        Self::bare(task, RowStatus::Skipped, None)
    }

    /// What could not be read, with why.
    pub fn error(task: &Task, reason: String) -> Self {
        Self::bare(task, RowStatus::Error, Some(reason))
    }

    /// Whether the planner did what it promises: a proof that a plan is best or that there
    /// is none, or, of one that proves nothing, a plan.
    pub const fn is_success(&self) -> bool {
        match self.status {
            RowStatus::Optimal | RowStatus::Impossible => true,
            RowStatus::Feasible => !self.planner.proves(),
            _ => false,
        }
    }

    /// Whether another row says the same, whatever it took.
    pub fn says(&self, other: &Self) -> bool {
        let took = other.took;
        *other
            == Self {
                took,
                ..self.clone()
            }
    }

    /// Its budget, in the words of its task's name.
    pub(crate) fn budget(&self) -> String {
        let rest = self.task.strip_prefix(&self.instance).unwrap_or_default();
        let is_budget = |part: &&str| {
            let key = part.split('=').next().unwrap_or_default();
            !["", "planner", "objective", "agents"].contains(&key)
        };
        rest.split(' ')
            .filter(is_budget)
            .collect::<Vec<_>>()
            .join(" ")
    }

    /// How far the first cost is above its bound, in the bound: 0.01 is one percent.
    /// `None` without a plan, or without a bound above 0.
    pub fn gap(&self) -> Option<f64> {
        let (costs, objective) = (self.costs.as_ref()?, self.objective.as_ref()?);
        let first = *objective.costs().first()?;
        let bound = *self.bounds.get(&first)?;
        let value = costs.get(first);
        (bound > 0).then(|| f64::from(value.saturating_sub(bound)) / f64::from(bound))
    }
}
