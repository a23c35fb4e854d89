//! The response to a request.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_proof::Report;
use serde::Serialize;

use super::Refusal;
use crate::{
    CheckAnswer, ExportAnswer, FrontAnswer, SolveAnswer, audit::AuditAnswer, change::ChangeAnswer,
    delays::DelaysAnswer, explain::ExplainAnswer, freedom::FreedomAnswer, order::OrderAnswer,
    plan::PlanAnswer, price::PriceAnswer, sizing::SizingAnswer, together::TogetherAnswer,
};

/// The response to a request. An error is a response, too.
#[derive(Clone, Debug, PartialEq, Serialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "response", rename_all = "kebab-case")]
#[cfg_attr(
    target_pointer_width = "64",
    expect(
        clippy::large_enum_variant,
        reason = "a request has one response: no list of them is ever held"
    )
)]
pub enum Response {
    /// To [`Request::Solve`](crate::Request::Solve).
    Solved(SolveAnswer),
    /// To [`Request::Solve`](crate::Request::Solve) with `pareto`.
    Front(FrontAnswer),
    /// To [`Request::Check`](crate::Request::Check).
    Checked(CheckAnswer),
    /// To [`Request::Explain`](crate::Request::Explain).
    Explained(Box<ExplainAnswer>),
    /// To [`Request::Certify`](crate::Request::Certify).
    Certified(Box<Report>),
    /// To [`Request::Export`](crate::Request::Export).
    Exported(Box<ExportAnswer>),
    /// To [`Request::Change`](crate::Request::Change).
    Changed(Box<ChangeAnswer>),
    /// To [`Request::Audit`](crate::Request::Audit).
    Audited(Box<AuditAnswer>),
    /// To [`Request::Plan`](crate::Request::Plan).
    Planned(Box<PlanAnswer>),
    /// To [`Request::Together`](crate::Request::Together).
    Together(Box<TogetherAnswer>),
    /// To [`Request::Freedom`](crate::Request::Freedom).
    Freedom(Box<FreedomAnswer>),
    /// To [`Request::Price`](crate::Request::Price).
    Priced(Box<PriceAnswer>),
    /// To [`Request::Delays`](crate::Request::Delays).
    Delays(Box<DelaysAnswer>),
    /// To [`Request::Order`](crate::Request::Order).
    Order(Box<OrderAnswer>),
    /// To [`Request::Sizing`](crate::Request::Sizing).
    Sized(Box<SizingAnswer>),
    /// The request is wrong; nothing was done.
    Refused(Refusal),
}
