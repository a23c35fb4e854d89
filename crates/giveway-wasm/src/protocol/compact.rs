//! The service's data as the messages write it.
//!
//! In the project's JSON a request says inside what it is, as people would write
//! it. To read that takes code that first keeps the whole object as a tree, for
//! every type in it: a tenth of the worker. Here the kind stands outside.

use giveway_model::{Cost, Costs, Fault, check::Violation, question::Misfit};
use giveway_proof::Report;
use giveway_solve::change::{ChangeAnswer, ChangeRequest};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest};
use giveway_solve::{
    CertifyRequest, CheckAnswer, CheckRequest, FrontAnswer, SolveAnswer, SolveRequest,
};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(remote = "giveway_solve::Request")]
pub(super) enum Request {
    Solve(SolveRequest),
    Check(CheckRequest),
    Explain(ExplainRequest),
    Certify(CertifyRequest),
    Change(ChangeRequest),
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
    Explained {
        answer: Box<ExplainAnswer>,
    },
    Certifying {
        claim: String,
        checking: bool,
    },
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "giveway_solve::Response")]
pub(super) enum Response {
    Solved(SolveAnswer),
    Front(FrontAnswer),
    Checked(CheckAnswer),
    Explained(Box<ExplainAnswer>),
    Certified(Box<Report>),
    Changed(Box<ChangeAnswer>),
    Refused(#[serde(with = "Refusal")] giveway_solve::Refusal),
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "giveway_solve::Refusal")]
pub(super) enum Refusal {
    Scene { faults: Vec<Fault> },
    Request { fault: Fault },
    Changes { faults: Vec<Fault> },
    Plan { violations: Vec<Violation> },
    Question { misfit: Misfit },
}
