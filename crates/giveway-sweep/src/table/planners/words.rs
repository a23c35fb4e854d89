//! The comparison as a table, and its sentences.

use std::fmt::Write as _;
use std::time::Duration;

use giveway_model::words::count;

use super::line::Kind;
use super::{Comparison, Gap, Limits};
use crate::Row;
use crate::table::Sheet;

/// What a gap is, for people who see one.
pub(super) const GAP: &str = "A gap is the cost of a legal plan over what is proved, rounded up.";
pub(super) const FOOT: &str = "An illegal plan or a wrong cost is not counted as solved.";

/// A line for every planner.
pub(in crate::table) fn sheet(comparisons: &[Comparison]) -> Sheet {
    let all = comparisons.iter().flat_map(|comparison| &comparison.lines);
    let lines: Vec<_> = all.collect();
    let kinds = Kind::columns_of(&lines);
    let mut head = vec![
        "cost",
        "planner",
        "about",
        "legal plans",
        "of",
        "half within s",
        "9 of 10 within s",
        "at the best",
        "median gap %",
        "largest gap %",
    ];
    head.extend(kinds.iter().map(|kind| kind.word()));
    let mut sheet = Sheet::new(&head);
    for comparison in comparisons {
        for line in &comparison.lines {
            let seconds = |seconds: Option<f64>| {
                seconds
                    .map(|seconds| format!("{seconds:.2}"))
                    .unwrap_or_default()
            };
            let gap = |gap: Option<Gap>| gap.map(|gap| gap.to_string()).unwrap_or_default();
            let mut cells = vec![
                comparison.cost.to_owned(),
                line.name.clone(),
                line.about.clone().unwrap_or_default(),
                line.solved.to_string(),
                comparison.instances.to_string(),
                seconds(line.half),
                seconds(line.nine_of_ten),
                line.at_best.to_string(),
                gap(line.median),
                gap(line.largest),
            ];
            let failed = |kind| line.failed.get(kind).copied().unwrap_or(0).to_string();
            cells.extend(kinds.iter().map(failed));
            sheet.push(cells);
        }
    }
    sheet
}

/// The table with its sentences, as Markdown.
pub(in crate::table) fn text(comparisons: &[Comparison]) -> String {
    let mut text = sheet(comparisons).markdown();
    for comparison in comparisons {
        let (bold, rest) = claim(comparison);
        let sentences = [
            scope(comparison),
            format!("{bold} {rest}"),
            shared(comparison),
        ];
        text.push('\n');
        for sentence in sentences.iter().chain(&comparison.contradictions) {
            text.push_str(sentence);
            text.push('\n');
        }
        if !comparison.first.is_empty() {
            text.push_str("\nThe first failure of each kind:\n\n");
        }
        for first in &comparison.first {
            let line = format!(
                "- {}: {}, {}: {}\n",
                first.kind, first.planner, first.place, first.how
            );
            text.push_str(&line);
        }
    }
    text
}

/// What was compared: `160 instances: 4 maps, 10 to 80 robots. Sum of costs. 60 s for each.`
pub(super) fn scope(comparison: &Comparison) -> String {
    let mut parts = vec![count(comparison.maps, "map")];
    match comparison.agents {
        Some((least, most)) if least < most => parts.push(format!("{least} to {most} robots")),
        Some((_, most)) => parts.push(count(most, "robot")),
        None => {}
    }
    let instances = count(comparison.instances, "instance");
    let mut cost = comparison.cost.to_owned();
    if let Some(first) = cost.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let mut text = format!("{instances}: {}. {cost}.", parts.join(", "));
    if !comparison.limits.words.is_empty() {
        let limits = comparison.limits.words.join(" and ");
        let _ = write!(text, " {limits} for each.");
    }
    text
}

/// What is proved: what stands in bold, and the rest.
pub(super) fn claim(comparison: &Comparison) -> (String, String) {
    let Comparison {
        instances,
        proved,
        bounded,
        impossible,
        ..
    } = comparison;
    let are = if *proved == 1 { "is" } else { "are" };
    let bold = format!("{proved} of {instances} {are} proved best.");
    let mut rest = vec![GAP.to_owned()];
    match bounded {
        0 => {}
        1 => rest.push(
            "For 1 other only a bound is proved: there the true gap may be smaller.".to_owned(),
        ),
        bounded => rest.push(format!(
            "For {bounded} others only a bound is proved: there the true gap may be smaller."
        )),
    }
    let open = instances - proved - bounded;
    if open > 0 {
        rest.push(format!(
            "Of {open} nothing is proved: their plans have no gap here."
        ));
    }
    if *impossible > 0 {
        let has = if *impossible == 1 { "has" } else { "have" };
        rest.push(format!(
            "{impossible} more {has} no plan, which is proved, and {has} no part in this."
        ));
    }
    (bold, rest.join(" "))
}

/// What medians are of.
pub(super) fn shared(comparison: &Comparison) -> String {
    match comparison.common {
        0 => "No instance was solved by all planners: there are no medians.".to_owned(),
        1 => "Times and medians are of the 1 instance that all planners solved.".to_owned(),
        common => {
            format!("Times and medians are over the {common} instances that all planners solved.")
        }
    }
}

/// How many runs there were, and how long they took in sum.
pub(super) fn runs(comparison: &Comparison) -> String {
    let (runs, seconds) = comparison.runs;
    let minutes = Duration::try_from_secs_f64(seconds)
        .unwrap_or_default()
        .as_secs()
        / 60;
    let took = match (minutes / 60, minutes % 60) {
        (0, 0) => format!("{seconds:.1} s"),
        (0, minutes) => format!("{minutes} min"),
        (hours, minutes) => format!("{hours} h {minutes} min"),
    };
    format!(
        "{}, {took} in sum. All rows: giveway table RESULTS --show rows --to csv",
        count(runs, "run")
    )
}

/// The limits of rows, as their tasks' names have them.
pub(super) fn limits(rows: &[&Row]) -> Limits {
    let mut limits = Limits::default();
    for row in rows {
        for part in row.budget().split(' ') {
            let Some((key, value)) = part.split_once('=') else {
                continue;
            };
            let number = value.parse::<f64>().ok();
            let words = match (key, number) {
                ("seconds", Some(seconds)) => format!("{seconds} s"),
                ("cpu-seconds", Some(seconds)) => format!("{seconds} CPU s"),
                ("bytes", Some(bytes)) if bytes >= 1e9 => format!("{} GB", bytes / 1e9),
                ("bytes", Some(bytes)) => format!("{} MB", bytes / 1e6),
                _ => continue,
            };
            if key.ends_with("seconds") {
                let longest = limits.seconds.into_iter().chain(number).fold(0.0, f64::max);
                limits.seconds = Some(longest);
            }
            if !limits.words.contains(&words) {
                limits.words.push(words);
            }
        }
    }
    limits
}
