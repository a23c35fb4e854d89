//! Two plans compared, as they are written for programs.

use std::collections::BTreeMap;

use giveway_formats::Format;
use giveway_model::compare::Comparison;
use serde::Serialize;

/// Two plans, and how they compare.
#[derive(Serialize)]
pub(crate) struct Compared {
    #[serde(flatten)]
    pub(crate) comparison: Comparison,
    /// The plans, in the order of the files.
    pub(crate) plans: [ComparedPlan; 2],
}

/// One of them.
#[derive(Serialize)]
pub(crate) struct ComparedPlan {
    pub(crate) file: String,
    pub(crate) format: Format,
    /// The number of rules that it breaks, each time it does.
    pub(crate) violations: usize,
    /// How it was read: what it is about, and how.
    pub(crate) conventions: BTreeMap<String, String>,
}
