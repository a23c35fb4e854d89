//! The service's data as the messages write it.
//!
//! In the project's JSON a request says inside what it is, as people would write
//! it. To read that takes code that first keeps the whole object as a tree, for
//! every type in it: a tenth of the worker. Here the kind stands outside.

use giveway_model::{Cost, Costs, Fault};
use giveway_solve::{CheckAnswer, CheckRequest, FrontAnswer, SolveAnswer, SolveRequest};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(remote = "giveway_solve::Request")]
pub(super) enum Request {
    Solve(SolveRequest),
    Check(CheckRequest),
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "giveway_solve::Progress")]
pub(super) enum Progress {
    Bound {
        cost: Cost,
        at_least: u32,
    },
    Plan {
        costs: Costs,
    },
    Size {
        variables: u64,
        clauses: u64,
        conflicts: u64,
    },
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "giveway_solve::Response")]
pub(super) enum Response {
    Solved(SolveAnswer),
    Front(FrontAnswer),
    Checked(CheckAnswer),
    Refused(#[serde(with = "Refusal")] giveway_solve::Refusal),
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "giveway_solve::Refusal")]
pub(super) enum Refusal {
    Scene { faults: Vec<Fault> },
    Request { fault: Fault },
}
