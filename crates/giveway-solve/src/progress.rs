//! Progress of a request.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cost, Costs, Plan};
use serde::Serialize;

use crate::{
    delays::DelaysAnswer,
    explain::ExplainAnswer,
    freedom::FreedomAnswer,
    price::PriceAnswer,
    sizing::{SizingFloor, SizingPoint},
    trace::TraceEvent,
};

/// An event on the way to an answer.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
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
    /// A better plan was found, and the judge passed it. A front that ends the
    /// work early keeps it, and may hand it in again as
    /// [`SolveRequest::start`](crate::SolveRequest::start).
    ///
    /// Told of the search for the best plan alone: not of plans that a question
    /// contrasts with it. Of a Pareto front it is better than those before it
    /// within its own limits; of a change it is the whole plan from time 0 by
    /// the method that is under way.
    Plan {
        /// Its costs.
        costs: Costs,
        /// The plan.
        plan: Plan,
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
    /// Steps of the search, where its trace is asked for: all of them, in order, some
    /// at once.
    Traced {
        /// The events.
        events: Vec<TraceEvent>,
    },
    /// More became known of all best plans.
    Freedom {
        /// The answer as far as it is known; `pending` names what is to come.
        answer: Box<FreedomAnswer>,
    },
    /// The price of one more rule became known.
    Priced {
        /// The answer as far as it is known; `pending` counts what is to come.
        answer: Box<PriceAnswer>,
    },
    /// The ledger of a plan is there.
    Delays {
        /// The answer without the proof of how many steps every plan loses.
        answer: Box<DelaysAnswer>,
    },
    /// The plan of one more number of robots is there.
    Sized {
        /// The floor that it is of.
        floor: SizingFloor,
        /// The plan, and what is known of it.
        point: Box<SizingPoint>,
        /// How many plans are still to come.
        pending: u32,
    },
    /// A certificate is begun.
    Exporting {
        /// How many were made before it.
        done: u32,
        /// How many there are.
        of: u32,
    },
    /// A claim is being proved again, or its proof checked.
    Certifying {
        /// The claim as a sentence.
        claim: String,
        /// Whether it is being checked.
        checking: bool,
    },
}
