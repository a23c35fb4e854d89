//! What is known of the best plans, a line for every row that was tried.

use giveway_proof::Certified;

use super::{Sheet, budget, has_budgets, objective};
use crate::{Row, RowStatus};

/// A line for every row that was tried: the bounds of the first cost, whether they meet, and
/// the certificate. In the order of maps, scenarios, objectives and numbers of agents. The
/// planner and the budget are told where there are several.
pub fn optima(rows: &[Row]) -> Sheet {
    let mut sheet = Sheet::new(&[
        "map",
        "scenario",
        "agents",
        "objective",
        "lower bound",
        "upper bound",
        "status",
        "gap %",
        "CPU s",
        "certificate",
        "certificate bytes",
        "certificate CPU s",
        "manifest SHA-256",
    ]);
    let tried = rows.iter().filter(|row| row.status != RowStatus::Skipped);
    let mut tried: Vec<(&str, &Row)> = tried.map(|row| (scenario(row), row)).collect();
    tried.sort_by_key(|(scenario, row)| (&row.map, *scenario, objective(row), row.agents));
    for (scenario, row) in &tried {
        sheet.push(line(scenario, row));
    }
    let tried = tried.iter().map(|(_, row)| *row);
    let mut planners = rows.iter().map(|row| &row.planner);
    let first = planners.next();
    if has_budgets(rows) {
        sheet.insert(4, "budget", tried.clone().map(budget));
    }
    if planners.any(|planner| Some(planner) != first) {
        sheet.insert(4, "planner", tried.map(|row| row.planner.to_string()));
    }
    sheet
}

/// The name of the instance's file, without folders and ending.
fn scenario(row: &Row) -> &str {
    let name = row.instance.rsplit('/').next().unwrap_or(&row.instance);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

fn line(scenario: &str, row: &Row) -> Vec<String> {
    let text = |value: Option<String>| value.unwrap_or_default();
    let first = row.objective.as_ref();
    let first = first.and_then(|objective| objective.costs().first().copied());
    let lower = first.and_then(|cost| row.bounds.get(&cost));
    let upper = row.costs.zip(first).map(|(costs, cost)| costs.get(cost));
    let certificate = row.certificate.as_ref();
    let made = certificate.filter(|made| made.certified != Certified::NotCertified);
    let word = |certified: Certified| match certified {
        Certified::Proved => "proved",
        Certified::ProvedAndSearched => "searched",
        Certified::NotCertified => "",
    };
    let seconds = row.took.certificate_cpu_seconds;
    vec![
        text(row.map.clone()),
        scenario.to_owned(),
        text(row.agents.map(|agents| agents.to_string())),
        objective(row),
        text(lower.map(ToString::to_string)),
        text(upper.map(|upper| upper.to_string())),
        row.status.word().to_owned(),
        text(row.gap().map(|gap| format!("{:.2}", 100.0 * gap))),
        format!("{:.2}", row.took.cpu_seconds),
        made.map_or("", |made| word(made.certified)).to_owned(),
        text(made.map(|made| made.bytes.to_string())),
        text(seconds.map(|seconds| format!("{seconds:.2}"))),
        text(made.and_then(|made| made.manifest.clone())),
    ]
}
