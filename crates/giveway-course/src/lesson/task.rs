//! What there is to do in a step: one of seven kinds of task.

use giveway_model::change::Changes;
use giveway_model::{Cost, Objective};
use giveway_solve::change::Method;
use serde::{Deserialize, Serialize};

use super::{Quantity, Statement, Text, Value};

/// A task. As JSON an object whose key `kind` says which it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Task {
    /// Edit the scene until a statement holds.
    Paint(Paint),
    /// Lead robots by hand.
    Lead(Lead),
    /// Say something before it is shown.
    Predict(Predict),
    /// Find every conflict of a faulty plan.
    Spot(Spot),
    /// Pick one of several answers.
    Choose(Choose),
    /// Put robots in an order for prioritised planning.
    Order(Order),
    /// Go on after a change.
    Change(Change),
}

impl Task {
    /// What it asks, in words.
    pub const fn say(&self) -> &Text {
        match self {
            Self::Paint(task) => &task.say,
            Self::Lead(task) => &task.say,
            Self::Predict(task) => &task.say,
            Self::Spot(task) => &task.say,
            Self::Choose(task) => &task.say,
            Self::Order(task) => &task.say,
            Self::Change(task) => &task.say,
        }
    }

    /// The kind, as it is written in files.
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Paint(_) => "paint",
            Self::Lead(_) => "lead",
            Self::Predict(_) => "predict",
            Self::Spot(_) => "spot",
            Self::Choose(_) => "choose",
            Self::Order(_) => "order",
            Self::Change(_) => "change",
        }
    }
}

/// Edit the scene, with the step's tools and edits, until a statement holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Paint {
    /// What it asks, in words.
    pub say: Text,
    /// What must hold.
    pub until: Statement,
}

/// Lead robots by hand; the others go as the step's plan has it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Lead {
    /// What it asks, in words.
    pub say: Text,
    /// Who may be led.
    pub robots: Vec<String>,
    /// What must be reached.
    pub aim: LeadAim,
}

/// What a plan made by hand must reach.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(
    tag = "is",
    rename_all = "kebab-case",
    rename_all_fields = "kebab-case",
    deny_unknown_fields
)]
pub enum LeadAim {
    /// It breaks no rule.
    Legal {},
    /// It also costs no more than this.
    Cost {
        /// The cost.
        cost: Cost,
        /// The most that it may cost.
        at_most: u32,
    },
    /// No plan is better.
    Best {
        /// By which costs, where they are not the scene's own.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        objective: Option<Objective>,
    },
}

/// Say something before it is shown. The truth is the solver's.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Predict {
    /// What it asks, in words.
    pub say: Text,
    /// What is to be said.
    pub what: Quantity,
    /// The values to pick from; where there are none, it is typed, or clicked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub answers: Vec<Guess>,
}

/// A value to pick.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Guess {
    /// The value.
    pub value: Value,
    /// What it would mean, in a few words.
    pub text: Text,
    /// What is said to those who pick it.
    pub reply: Text,
}

/// Find every conflict of the step's plan: where, when and who.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Spot {
    /// What it asks, in words.
    pub say: Text,
}

/// Pick one of several answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Choose {
    /// What it asks, in words.
    pub say: Text,
    /// The answers; at least one of them is right.
    pub answers: Vec<Choice>,
}

/// An answer to pick.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Choice {
    /// The answer.
    pub text: Text,
    /// Whether it is right.
    #[serde(default, skip_serializing_if = "is_false")]
    pub right: bool,
    /// What is said to those who pick it.
    pub reply: Text,
    /// What it claims of the scene or its plan, where it claims something: the
    /// solver must agree just when the answer is right.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub claim: Option<Statement>,
}

/// Put all robots in an order for prioritised planning.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Order {
    /// What it asks, in words.
    pub say: Text,
    /// What the order must do.
    pub find: OrderAim,
}

/// What an order is looked for to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum OrderAim {
    /// Give a plan.
    Works,
    /// Give a plan with the best first cost.
    Best,
    /// Give a plan whose first cost is not the best.
    Worse,
    /// There is none: no order gives a plan, though there is one.
    None,
}

/// Go on with the step's plan after a change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Change {
    /// What it asks, in words.
    pub say: Text,
    /// What changes.
    pub changes: Changes,
    /// The methods to pick from.
    pub methods: Vec<Method>,
    /// A cost that must be reached.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cost: Option<CostLimit>,
    /// How many robots must keep their path and times, at least.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kept: Option<u32>,
}

/// The most that something may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct CostLimit {
    /// The cost.
    pub cost: Cost,
    /// The most.
    pub at_most: u32,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_false(value: &bool) -> bool {
    !*value
}
