//! The answer of `verify` as text.

use std::fmt::Write as _;

use anstyle::AnsiColor;
use giveway_proof::bundle::Method;
use giveway_proof::{Checked, Report};

use super::paint;
use crate::output::{plain, words};

/// The verdict, and what each claim rests on.
pub(crate) fn verify(report: &Report) -> String {
    let (colour, word) = match (report.accepted, report.stopped) {
        (true, _) => (AnsiColor::Green, "Accepted"),
        (false, false) => (AnsiColor::Red, "Rejected"),
        (false, true) => (AnsiColor::Yellow, "Unknown"),
    };
    let word = paint(colour.on_default().bold(), word);
    let mut text = match &report.reason {
        Some(reason) => format!("{word}: {}\n", plain::text(reason)),
        None => format!("{word}: every file is as it was written.\n"),
    };
    for claim in &report.claims {
        let _ = match claim {
            Checked::Proof {
                text: claim,
                variables,
                clauses,
                steps,
                ..
            } => writeln!(
                text,
                "  proof          {} ({}, {}, {} checked)",
                plain::text(claim),
                words::count(*variables as u64, "variable"),
                words::count(*clauses as u64, "clause"),
                words::count(*steps as u64, "step"),
            ),
            Checked::Search {
                text: claim,
                method,
                ..
            } => writeln!(
                text,
                "  search         {} ({})",
                plain::text(claim),
                match method {
                    Method::Alone => "each agent alone, searched again",
                    Method::Joint => "all states of all agents, searched again",
                }
            ),
            Checked::None {
                text: claim, why, ..
            } => writeln!(
                text,
                "  not certified  {} {}",
                plain::text(claim),
                plain::text(why)
            ),
        };
    }
    if let Some(conclusion) = &report.conclusion {
        let _ = writeln!(text, "{}", plain::text(conclusion));
    }
    let _ = writeln!(text, "{}", report.certified.words());
    text
}
