//! The answer of `check` as text.

use std::fmt::Write as _;

use anstyle::AnsiColor;
use giveway_model::words::{count, values};
use giveway_model::{Cost, Instance, Plan, change::History};
use giveway_solve::CheckAnswer;

use super::{drawings, paint, title};
use crate::output::{map, plain, table, words};

/// So many violations are told one by one; the rest is counted.
const TOLD: usize = 100;

/// The verdict, every violation, and the plan with its battery levels.
pub(crate) fn check(
    instance: &Instance,
    plan: &Plan,
    answer: &CheckAnswer,
    columns: usize,
) -> String {
    [
        title(instance),
        verdict(answer),
        drawings(instance, Some(plan), columns),
    ]
    .join("\n")
}

/// The same where the world changes while the plan runs; the map is the last.
pub(crate) fn check_over_time(
    instance: &Instance,
    history: &History,
    plan: &Plan,
    answer: &CheckAnswer,
    columns: usize,
) -> String {
    let last = map::draw_over_time(instance, history, columns);
    let table = table::draw_over_time(history, plan, columns);
    [title(instance), verdict(answer), last, table].join("\n")
}

fn verdict(answer: &CheckAnswer) -> String {
    let costs = answer.costs.map(|costs| values(&Cost::USUAL, &costs));
    if answer.valid {
        let word = paint(AnsiColor::Green.on_default().bold(), "Valid");
        return format!("{word}: {}.\n", costs.unwrap_or_default());
    }
    let word = paint(AnsiColor::Red.on_default().bold(), "Not valid");
    let number = count(answer.violations.len(), "violation");
    let mut text = format!("{word}: {number}.\n");
    for violation in answer.violations.iter().take(TOLD) {
        let _ = writeln!(
            text,
            "  {}: {}",
            violation.rule.name(),
            words::sentence(&violation.message)
        );
    }
    if answer.violations.len() > TOLD {
        let _ = writeln!(
            text,
            "  and {} more; --format json shows them all",
            answer.violations.len() - TOLD
        );
    }
    if let Some(costs) = costs {
        let _ = writeln!(text, "Costs of the plan: {}.", plain::text(&costs));
    }
    text
}
