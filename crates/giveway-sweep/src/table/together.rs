//! What rows say only together: what some of them lack, and whether their budgets differ.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Method, Row};

/// The rows with the names of maps and the objectives that some of them lack, since what was
/// skipped was not read: other rows of the same instance have them.
pub(super) fn completed(rows: &[Row]) -> Vec<Row> {
    let mut maps = BTreeMap::new();
    let mut objectives = BTreeMap::new();
    for row in rows {
        if let Some(map) = &row.map {
            maps.insert(&row.instance, map);
        }
        if let Some(objective) = row.objective.as_ref().filter(|_| has_own_objective(row)) {
            objectives.insert(&row.instance, objective);
        }
    }
    let complete = |row: &Row| {
        let map = row
            .map
            .as_ref()
            .or_else(|| maps.get(&row.instance).copied());
        let own = || objectives.get(&row.instance).copied();
        let objective = row.objective.as_ref().or_else(own);
        Row {
            map: map.cloned(),
            objective: objective.cloned(),
            ..row.clone()
        }
    };
    rows.iter().map(complete).collect()
}

/// Whether a row's objective is that of its instance, and not one of the sweep.
fn has_own_objective(row: &Row) -> bool {
    let rest = row.task.strip_prefix(&row.instance).unwrap_or_default();
    !rest.split(' ').any(|part| part.starts_with("objective="))
}

/// Whether rows of one planner have several budgets: these are counted apart.
pub(super) fn has_budgets(rows: &[Row]) -> bool {
    let mut budgets: BTreeMap<Method, BTreeSet<String>> = BTreeMap::new();
    for row in rows {
        let budgets = budgets.entry(row.planner.clone()).or_default();
        budgets.insert(row.budget());
    }
    budgets.values().any(|budgets| budgets.len() > 1)
}

/// A row's budget in words.
pub(super) fn budget(row: &Row) -> String {
    match row.budget() {
        none if none.is_empty() => "no limit".to_owned(),
        budget => budget,
    }
}
