//! The answer of `verify` as text.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use giveway_model::words::count;
use giveway_proof::{Certified, Checked, CheckedLemma, Report};

use super::paint;
use crate::output::plain;

/// Several certificates, each with its name, and how many of them hold.
pub(crate) fn verify_all(reports: &BTreeMap<String, Report>) -> String {
    let mut text = String::new();
    for (name, report) in reports {
        let name = paint(Style::new().bold(), &plain::text(name));
        let _ = writeln!(text, "{name}\n{}", verify(report));
    }
    let held = reports.values().filter(|report| report.accepted).count();
    let all = count(reports.len() as u64, "certificate");
    let _ = writeln!(text, "{held} of {all} accepted.");
    text
}

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
                count(*variables, "variable"),
                count(*clauses, "clause"),
                count(*steps, "step"),
            ),
            Checked::Lemmas {
                text: claim,
                lemmas,
                ..
            } => writeln!(
                text,
                "  lemmas         {}{}",
                plain::text(claim),
                lemmas.iter().map(lemma).collect::<String>()
            ),
            Checked::Search {
                text: claim,
                method,
                ..
            } => writeln!(
                text,
                "  search         {} (a search of {}, repeated)",
                plain::text(claim),
                method.words()
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
    let colour = match report.certified {
        Certified::Proved | Certified::ProvedAndSearched => AnsiColor::Green,
        Certified::NotCertified => AnsiColor::Red,
    };
    let word = paint(colour.on_default().bold(), report.certified.words());
    let _ = if report.accepted {
        writeln!(text, "{word}. {}", report.summary())
    } else {
        writeln!(text, "{word}.")
    };
    text
}

fn lemma(lemma: &CheckedLemma) -> String {
    format!(
        "\n    proof          {} ({}, {}, {} checked)",
        plain::text(&lemma.text),
        count(lemma.variables, "variable"),
        count(lemma.clauses, "clause"),
        count(lemma.steps, "step"),
    )
}
