//! Tables and plots of rows.

mod curves;
mod html;
mod optima;
mod planners;
mod plot;
mod sheet;
mod together;
mod written;

use std::collections::BTreeMap;

pub use curves::{Curve, cactus, success};
pub use optima::optima;
pub use plot::{Axes, plot};
pub use sheet::Sheet;
use together::{budget, has_budgets};
pub use written::{Show, Written, write};

use crate::{Failure, Method, Row, RowStatus};

/// Rows that are counted together.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Group {
    map: String,
    objective: String,
    planner: String,
    budget: Option<String>,
    agents: Option<usize>,
}

fn group(row: &Row, has_budgets: bool) -> Group {
    Group {
        map: row.map.as_ref().unwrap_or(&row.instance).clone(),
        objective: objective(row),
        planner: row.planner.to_string(),
        budget: has_budgets.then(|| budget(row)),
        agents: row.agents,
    }
}

fn objective(row: &Row) -> String {
    let objective = row.objective.as_ref();
    objective.map(ToString::to_string).unwrap_or_default()
}

/// A line for every map, objective, planner and number of agents, and for every budget where
/// there are several: how many tasks ended how, the mean gap of those with a plan and a
/// bound, the median of CPU seconds of the successful.
pub fn summary(rows: &[Row]) -> Sheet {
    let has_budgets = has_budgets(rows);
    let mut groups: BTreeMap<Group, Vec<&Row>> = BTreeMap::new();
    for row in rows {
        groups.entry(group(row, has_budgets)).or_default().push(row);
    }
    let mut sheet = Sheet::new(&[
        "map",
        "objective",
        "planner",
        "agents",
        "tasks",
        "optimal",
        "feasible",
        "impossible",
        "unknown",
        "refused",
        "error",
        "skipped",
        "mean gap %",
        "median CPU s",
    ]);
    let has_failed = rows.iter().any(|row| row.status == RowStatus::Failed);
    let mut failures = Vec::new();
    let budgets: Vec<Option<String>> = groups.keys().map(|group| group.budget.clone()).collect();
    for (group, rows) in groups {
        let mut line = vec![
            group.map,
            group.objective,
            group.planner,
            group
                .agents
                .map_or_else(String::new, |agents| agents.to_string()),
            rows.len().to_string(),
        ];
        for status in [
            RowStatus::Optimal,
            RowStatus::Feasible,
            RowStatus::Impossible,
            RowStatus::Unknown,
            RowStatus::Refused,
            RowStatus::Error,
            RowStatus::Skipped,
        ] {
            line.push(
                rows.iter()
                    .filter(|row| row.status == status)
                    .count()
                    .to_string(),
            );
        }
        let is_failed = |row: &&&Row| row.status == RowStatus::Failed;
        failures.push(rows.iter().filter(is_failed).count().to_string());
        let gaps: Vec<f64> = rows.iter().filter_map(|row| row.gap()).collect();
        let mean = gaps.iter().sum::<f64>() / gaps.len() as f64;
        line.push(if gaps.is_empty() {
            String::new()
        } else {
            format!("{:.2}", 100.0 * mean)
        });
        line.push(median(&rows).map_or_else(String::new, |seconds| format!("{seconds:.2}")));
        sheet.push(line);
    }
    if has_failed {
        sheet.insert(9, "failed", failures.into_iter());
    }
    if has_budgets {
        sheet.insert(
            3,
            "budget",
            budgets.into_iter().map(Option::unwrap_or_default),
        );
    }
    sheet
}

/// The middle CPU seconds of the rows that succeeded; the lower of two in the middle.
fn median(rows: &[&Row]) -> Option<f64> {
    let closed = rows.iter().filter(|row| row.is_success());
    let mut seconds: Vec<f64> = closed.map(|row| row.took.cpu_seconds).collect();
    seconds.sort_by(f64::total_cmp);
    seconds.get(seconds.len().checked_sub(1)? / 2).copied()
}

/// A line for every row, with its budget where there are several, and with what planners of
/// others have besides where there are some.
pub fn all(rows: &[Row]) -> Sheet {
    let mut sheet = Sheet::new(&[
        "instance",
        "map",
        "agents",
        "objective",
        "planner",
        "status",
        "complete",
        "within",
        "first cost",
        "bound",
        "makespan",
        "sum of costs",
        "charges",
        "moves",
        "waits",
        "CPU s",
    ]);
    for row in rows {
        let number = |value: Option<u32>| value.map_or_else(String::new, |value| value.to_string());
        let first = row
            .objective
            .as_ref()
            .and_then(|objective| objective.costs().first());
        let cost = |cost| row.costs.as_ref().map(|costs| costs.get(cost));
        let mut line = vec![
            row.instance.clone(),
            row.map.clone().unwrap_or_default(),
            row.agents
                .map_or_else(String::new, |agents| agents.to_string()),
            objective(row),
            row.planner.to_string(),
            row.status.word().to_owned(),
            row.complete.to_string(),
            number(row.within),
            number(first.and_then(|&first| cost(first))),
            number(first.and_then(|first| row.bounds.get(first).copied())),
        ];
        line.extend(
            giveway_model::Cost::USUAL
                .iter()
                .map(|&kind| number(cost(kind))),
        );
        line.push(format!("{:.2}", row.took.cpu_seconds));
        sheet.push(line);
    }
    if rows
        .iter()
        .any(|row| matches!(row.planner, Method::Command(_)))
    {
        let text = |text: Option<&str>| text.unwrap_or_default().to_owned();
        let failure = |row: &Row| text(row.failure.map(Failure::word));
        let megabytes = |row: &Row| row.took.peak_bytes.map(|bytes| bytes.div_ceil(1_000_000));
        let megabytes = |row| megabytes(row).map_or_else(String::new, |peak| peak.to_string());
        sheet.insert(
            15,
            "reason",
            rows.iter().map(|row| text(row.reason.as_deref())),
        );
        sheet.insert(15, "peak MB", rows.iter().map(megabytes));
        sheet.insert(6, "failure", rows.iter().map(failure));
    }
    if has_budgets(rows) {
        sheet.insert(5, "budget", rows.iter().map(budget));
    }
    sheet
}

#[cfg(test)]
mod tests;
