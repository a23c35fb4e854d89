//! Statements about a scene or a plan that the solver or the judge decides.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Question};
use giveway_solve::explain::Verdict;
use serde::{Deserialize, Serialize};

/// Something that holds of a scene, or of the plan on the board, or does not.
///
/// As JSON: `{ "is": "cost", "cost": "makespan", "compare": "<=", "value": 9 }`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(
    tag = "is",
    rename_all = "kebab-case",
    rename_all_fields = "kebab-case",
    deny_unknown_fields
)]
pub enum Statement {
    /// There is no plan.
    Impossible {
        /// Whether each robot, were it alone, must still have one.
        #[serde(default)]
        each_alone: bool,
    },
    /// There is a plan.
    Solvable {},
    /// The cost of the best plan compares so with a number. The cost is one of the
    /// scene's objective.
    Cost {
        /// The cost.
        cost: Cost,
        /// How it compares.
        compare: Comparison,
        /// With what.
        value: u32,
    },
    /// The cost of the best plan is more than that of the scene that the step began
    /// with, by exactly so much.
    Raised {
        /// The cost.
        cost: Cost,
        /// By how much.
        by: u32,
    },
    /// A question about the best plan has this answer.
    Verdict {
        /// The question.
        question: Question,
        /// The answer.
        verdict: Verdict,
    },
    /// No plan is best in both costs: the Pareto front has more than one point.
    Apart {
        /// The two costs.
        costs: [Cost; 2],
    },
    /// What a rule of the scene's own costs compares so with a number, in the first cost
    /// of the objective.
    Price {
        /// The rule, by its number in the scene, from 0.
        rule: u32,
        /// How it compares.
        compare: Comparison,
        /// With what.
        value: u32,
    },
    /// The plan on the board breaks no rule.
    Legal {},
    /// The plan on the board breaks a rule of the scene's own, this one.
    Broken {
        /// The rule, by its number in the scene, from 0.
        rule: u32,
    },
    /// The plan on the board breaks no rule, and none is better.
    Best {},
    /// The plan on the board breaks no rule, but another one is better.
    Beaten {},
}

/// How a number compares with another one.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
pub enum Comparison {
    /// It is the same.
    #[serde(rename = "=")]
    Equal,
    /// It is at most that.
    #[serde(rename = "<=")]
    AtMost,
    /// It is at least that.
    #[serde(rename = ">=")]
    AtLeast,
}

impl Comparison {
    /// Whether the first number compares so with the second.
    pub const fn holds(self, first: u32, second: u32) -> bool {
        match self {
            Self::Equal => first == second,
            Self::AtMost => first <= second,
            Self::AtLeast => first >= second,
        }
    }
}
