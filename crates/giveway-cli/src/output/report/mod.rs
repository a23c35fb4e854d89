//! An audit as it is told: what was recognised, the verdict, the numbers; as one page
//! of HTML, as Markdown, and for programs.

mod html;
mod link;
mod markdown;
mod object;
mod svg;
pub(crate) mod words;

use std::path::Path;

use giveway_formats::ForeignPlan;
use giveway_model::Instance;
use giveway_model::compare::{ClaimedBound, ClaimedCost};
use giveway_solve::audit::AuditAnswer;

use crate::failure::Failure;

pub(crate) use link::Link;

/// A plan that was audited, with what is known of it.
pub(crate) struct Audited {
    pub(crate) instance: Instance,
    /// What was noted of the instance.
    pub(crate) notes: Vec<String>,
    pub(crate) plan: ForeignPlan,
    /// What its file claims, beside what it costs.
    pub(crate) claims: Vec<ClaimedCost>,
    /// What its file says that every plan costs, beside what is known here.
    pub(crate) claimed_bounds: Vec<ClaimedBound>,
    pub(crate) answer: AuditAnswer,
    /// By which other rule an illegal plan is legal, a sentence.
    pub(crate) otherwise: Option<String>,
}

/// So many violations are told one by one; the rest is counted.
pub(crate) const TOLD: usize = 100;

/// What a report is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Html,
    Markdown,
    Json,
}

impl Kind {
    /// By the ending of a file's name.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "html" | "htm" => Some(Self::Html),
            "md" | "markdown" => Some(Self::Markdown),
            "json" => Some(Self::Json),
            _ => None,
        }
    }
}

/// The text of a report. `command` makes the same audit again.
pub(crate) fn write(
    kind: Kind,
    audited: &Audited,
    command: &str,
    link: &Link,
) -> Result<String, Failure> {
    match kind {
        Kind::Html => Ok(html::page(audited, command, link)),
        Kind::Markdown => Ok(markdown::text(audited, command, link)),
        Kind::Json => super::json::text(&audited.object().with_link(link.address())),
    }
}
