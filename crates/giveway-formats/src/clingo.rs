//! The output of clingo: the facts of the last answer, between lines that are none.
//!
//! ```text
//! clingo version 5.7.1
//! Reading from m.lp ...
//! Solving...
//! Answer: 1                              of several answers the last is the best
//! init(..) init(..) occurs(..)           facts without full stops
//! Optimization: 7
//! OPTIMUM FOUND | SATISFIABLE | UNSATISFIABLE | UNKNOWN
//! Models : 1
//! ```

use super::{Held, asprilo};
use giveway_model::{Fault, tr, tr_later};

/// How such a text may begin.
const BEGINNINGS: [&str; 12] = [
    "clingo version",
    "clasp version",
    "telingo version",
    "gringo version",
    "Reading from",
    "Grounding",
    "Solving",
    "Answer:",
    "SATISFIABLE",
    "UNSATISFIABLE",
    "UNKNOWN",
    "OPTIMUM FOUND",
];

/// The line that ends the search.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Found,
    Unsatisfiable,
    Unknown,
}

fn end(line: &str) -> Option<End> {
    match line.trim() {
        "SATISFIABLE" | "OPTIMUM FOUND" => Some(End::Found),
        "UNSATISFIABLE" => Some(End::Unsatisfiable),
        "UNKNOWN" => Some(End::Unknown),
        _ => None,
    }
}

/// Whether a line announces an answer; newer versions write its time behind it.
fn is_answer(line: &str) -> bool {
    let number = line
        .trim_start()
        .strip_prefix("Answer:")
        .map(str::trim_start);
    number.is_some_and(|number| number.starts_with(|c: char| c.is_ascii_digit()))
}

/// Whether a text begins as clingo's output does, and has an answer or an end.
pub(super) fn sniff(text: &str) -> bool {
    let start = text.trim_start();
    // Warnings about the program come before all else.
    let is_warned =
        start.contains(": info: ") || start.contains(": warning: ") || start.starts_with("*** ");
    (is_warned || BEGINNINGS.iter().any(|begin| start.starts_with(begin)))
        && text.lines().any(|line| {
            is_answer(line) || end(line).is_some() || line.starts_with("clingo version")
        })
}

/// Reads the facts of the last answer.
pub(super) fn read(text: &str) -> Result<Held, Fault> {
    asprilo::read(&facts(text)?)
}

/// The text with blanks instead of all but the facts of the last answer, so that each
/// byte keeps its place.
fn facts(text: &str) -> Result<String, Fault> {
    let all: Vec<&str> = text.split_inclusive('\n').collect();
    let Some(last) = all.iter().rposition(|line| is_answer(line)) else {
        return Err(unanswered(&all));
    };
    let is_fact = |line: &&str| {
        line.trim_start()
            .starts_with(|c: char| c.is_ascii_lowercase())
    };
    let below = all.iter().skip(last + 1).copied();
    let own: Vec<&str> = below
        .take_while(|line| line.trim().is_empty() || is_fact(line))
        .collect();
    if !own.iter().any(is_fact) {
        let found = tr_later!("an answer of clingo without facts");
        let expected = tr_later!("facts init(..) or occurs(..): let the program show them");
        return Err(Fault::at("", found, expected).in_text(last + 1, 1));
    }
    let facts = last + 1..last + 1 + own.len();
    let mut kept = String::with_capacity(text.len());
    for (i, line) in all.into_iter().enumerate() {
        if facts.contains(&i) {
            kept.push_str(line);
        } else {
            let blank = |byte| if byte == b'\n' { '\n' } else { ' ' };
            kept.extend(line.bytes().map(blank));
        }
    }
    Ok(kept)
}

/// Why there is no answer.
fn unanswered(all: &[&str]) -> Fault {
    let mut ends = all.iter().enumerate().rev();
    let ended = ends.find_map(|(i, line)| Some((i + 1, end(line)?)));
    let found = match ended.map(|(_, end)| end) {
        Some(End::Unsatisfiable) => tr!("UNSATISFIABLE: clingo found that there is no answer"),
        Some(End::Unknown) => tr!("UNKNOWN: clingo stopped before it found an answer"),
        Some(End::Found) => {
            tr!("an output of clingo that does not show its answer (option -q)")
        }
        None => tr!("an output of clingo that ends before its first answer"),
    };
    let line = ended.map_or(all.len().max(1), |(line, _)| line);
    let expected = tr!("an answer with facts init(..) or occurs(..)");
    Fault::at("", found, expected).in_text(line, 1)
}
