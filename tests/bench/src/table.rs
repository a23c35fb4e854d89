//! The tables, in Markdown.

use std::fmt::Write;

use giveway_solve::Status;

use crate::rows::Group;
use crate::run::Outcome;

/// A heading, what the rows have in common, and the table.
pub(crate) fn section(group: &Group, outcomes: &[Outcome]) -> String {
    let costs = group.objective.costs();
    let mut columns = vec!["instance", "status"];
    columns.extend(costs.iter().map(|cost| cost.name()));
    columns.extend(WORK);
    let mut text = format!("## {}\n\n{}\n\n", group.title, summary(outcomes));
    push_row(&mut text, &columns);
    let ruler: Vec<&str> = columns
        .iter()
        .enumerate()
        .map(|(i, _)| if i < 2 { "---" } else { "---:" })
        .collect();
    push_row(&mut text, &ruler);
    for outcome in outcomes {
        let mut cells = vec![outcome.row.name.clone(), outcome.status().to_owned()];
        cells.extend(costs.iter().map(|&cost| outcome.cost(cost)));
        cells.extend(work(outcome));
        push_row(&mut text, &cells);
    }
    text.push('\n');
    text
}

/// The columns that tell what a row took.
const WORK: [&str; 6] = [
    "variables",
    "clauses",
    "conflicts",
    "solver calls",
    "CPU s",
    "peak MB",
];

fn work(outcome: &Outcome) -> [String; 6] {
    let stats = &outcome.answer.stats;
    [
        stats.variables.to_string(),
        stats.clauses.to_string(),
        stats.conflicts.to_string(),
        stats.solver_calls.to_string(),
        format!("{:.3}", outcome.cpu_seconds),
        format!("{:.1}", outcome.peak_bytes as f64 / 1e6),
    ]
}

fn push_row(text: &mut String, cells: &[impl AsRef<str>]) {
    for cell in cells {
        let _ = write!(text, "| {} ", cell.as_ref());
    }
    text.push_str("|\n");
}

/// How many rows are proved, and how long they took.
fn summary(outcomes: &[Outcome]) -> String {
    let is_proved = |outcome: &&Outcome| outcome.answer.status == Status::Optimal;
    let proved = outcomes.iter().filter(is_proved).count();
    let mut seconds: Vec<f64> = outcomes.iter().map(|outcome| outcome.cpu_seconds).collect();
    seconds.sort_by(f64::total_cmp);
    let median = seconds.get(seconds.len() / 2).copied().unwrap_or_default();
    let most = seconds.last().copied().unwrap_or_default();
    let sum: f64 = seconds.iter().sum();
    format!(
        "{proved} of {} proved; CPU seconds: median {median:.3}, most {most:.3}, together {sum:.1}.",
        outcomes.len()
    )
}
