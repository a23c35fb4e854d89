//! The answer of `audit` as text.

use std::fmt::Write as _;

use anstyle::AnsiColor;
use giveway_solve::audit::AuditStatus;

use super::{paint, title};
use crate::output::plain;
use crate::output::report::{Audited, TOLD, words};

/// What was recognised, the verdict, every violation, and the costs.
pub(crate) fn audit(audited: &Audited) -> String {
    let parts = [
        title(&audited.instance),
        recognised(audited),
        verdict(audited),
        costs(audited),
        super::solve::work(&audited.answer.stats),
    ];
    parts.join("\n")
}

fn recognised(audited: &Audited) -> String {
    let mut text = format!("{}\n", words::RECOGNISED);
    for (about, what) in words::recognised(audited) {
        let about = plain::pad_right(&plain::text(&about), 8);
        let _ = writeln!(text, "  {about}{}", plain::text(&what));
    }
    text
}

fn verdict(audited: &Audited) -> String {
    let answer = &audited.answer;
    let colour = match answer.status {
        AuditStatus::Optimal => AnsiColor::Green,
        AuditStatus::Feasible | AuditStatus::Unknown => AnsiColor::Yellow,
        AuditStatus::Illegal => AnsiColor::Red,
    };
    let head = words::verdict(audited);
    let word = paint(colour.on_default().bold(), &plain::text(&head.word));
    let mut text = format!("{word}{}\n", plain::text(&head.rest));
    for violation in answer.violations.iter().take(TOLD) {
        let _ = writeln!(text, "  {}", plain::text(&words::violation(violation)));
    }
    if let Some(more) = words::more(&answer.violations) {
        let _ = writeln!(text, "  {more}");
    }
    for note in &words::more_of(audited) {
        let _ = writeln!(text, "{}", plain::text(note));
    }
    text
}

/// All five costs; a column that has nothing is left out.
fn costs(audited: &Audited) -> String {
    let rows = words::costs(audited);
    let shown = |column: usize| rows.iter().any(|row| row.cells[column].is_some());
    let columns: Vec<usize> = (0..words::COST_HEADINGS.len())
        .filter(|&i| shown(i))
        .collect();
    let mut text = plain::pad_right("cost", 14);
    for &column in &columns {
        let _ = write!(text, "{:>17}", words::COST_HEADINGS[column]);
    }
    text.push('\n');
    for row in &rows {
        text += &plain::pad_right(row.cost, 14);
        for &column in &columns {
            let cell = row.cells[column].map_or("-".to_owned(), |n| n.to_string());
            let _ = write!(text, "{cell:>17}");
        }
        text.push('\n');
    }
    for claim in words::claims(audited) {
        let _ = writeln!(text, "{}", plain::text(&claim));
    }
    text
}
