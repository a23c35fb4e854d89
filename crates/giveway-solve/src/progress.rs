//! What becomes known while a request is served.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Costs};
use serde::{Deserialize, Serialize};

use crate::explain::ExplainAnswer;

/// An event on the way to an answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum Progress {
    /// It is proved that no plan has less of this cost (where it is not the
    /// first of the objective: none that is optimal in those before it).
    Bound {
        /// The cost.
        cost: Cost,
        /// Its proved lower bound.
        at_least: u32,
    },
    /// A better plan was found.
    Plan {
        /// Its costs.
        costs: Costs,
    },
    /// The size of the work so far.
    Size {
        /// SAT variables.
        variables: u64,
        /// Clauses given to the SAT solver.
        clauses: u64,
        /// Conflicts that it met.
        conflicts: u64,
    },
    /// A part of an answer to a question became known.
    Explained {
        /// The answer as far as it is known; `pending` names what is to come.
        answer: Box<ExplainAnswer>,
    },
    /// A claim is being proved again, or its proof checked.
    Certifying {
        /// The claim as a sentence.
        claim: String,
        /// Whether it is being checked.
        checking: bool,
    },
}
