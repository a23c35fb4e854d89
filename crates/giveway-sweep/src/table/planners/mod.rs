//! Planners beside the proof: what each came to on the same instances, and how far its
//! plans are from the best.
//!
//! A planner solves an instance by a legal plan of the cost that it says; one that proves,
//! by a proof. A gap is over what is proved for every horizon, rounded up. Times and median
//! gaps are over the instances that all planners solved, so that nobody looks good by
//! failing; only planners that solved none are left out there.

mod first;
mod gap;
mod html;
mod line;
mod looks;
mod plot;
mod scale;
#[cfg(test)]
mod tests;
mod words;

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::words::name;
use giveway_model::{Cost, Objective};

use super::{budget, objective};
use crate::{Method, Row, RowStatus};
pub(super) use first::First;
pub(super) use gap::Gap;
use gap::Known;
pub(super) use html::page;
pub(super) use line::Line;
pub(super) use plot::both;
pub(super) use words::{sheet, text};

/// An instance with so many of its agents.
type Case<'a> = (&'a str, Option<usize>);

/// The planners of one objective.
pub(super) struct Comparison {
    /// The cost that is compared: the first of the objective.
    pub(super) cost: &'static str,
    /// How many instances there are, those without a plan not counted.
    pub(super) instances: usize,
    /// How many more have no plan, which is proved.
    pub(super) impossible: usize,
    /// How many have a best plan that is proved.
    pub(super) proved: usize,
    /// How many others have a bound that is proved.
    pub(super) bounded: usize,
    /// How many all planners solved that solved any.
    pub(super) common: usize,
    /// How many maps there are.
    pub(super) maps: usize,
    /// The least and the largest number of agents.
    pub(super) agents: Option<(usize, usize)>,
    /// The planners, those of this project first.
    pub(super) lines: Vec<Line>,
    /// The first failure of each kind.
    pub(super) first: Vec<First>,
    /// Legal plans that cost less than is proved: sentences.
    pub(super) contradictions: Vec<String>,
    /// The longest limit in seconds, and what is told of limits.
    pub(super) limits: Limits,
    /// How many runs there were, and their wall seconds in sum.
    pub(super) runs: (usize, f64),
}

/// The limits of the rows.
#[derive(Default)]
pub(super) struct Limits {
    pub(super) seconds: Option<f64>,
    pub(super) words: Vec<String>,
}

/// The comparisons of rows, one for each objective.
pub(super) fn comparisons(rows: &[Row]) -> Vec<Comparison> {
    let mut by_objective: BTreeMap<String, Vec<&Row>> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.status != RowStatus::Error) {
        by_objective.entry(objective(row)).or_default().push(row);
    }
    let mut budgets: BTreeMap<&Method, BTreeSet<String>> = BTreeMap::new();
    for row in rows {
        budgets
            .entry(&row.planner)
            .or_default()
            .insert(row.budget());
    }
    budgets.retain(|_, budgets| budgets.len() > 1);
    let several: BTreeSet<&Method> = budgets.into_keys().collect();
    let rows = by_objective.into_values();
    rows.map(|rows| Comparison::new(&rows, &several)).collect()
}

/// The name of a planner, with its budget where it has several.
fn named(row: &Row, several: &BTreeSet<&Method>) -> String {
    let planner = &row.planner;
    if several.contains(planner) {
        format!("{planner}, {}", budget(row))
    } else {
        planner.to_string()
    }
}

/// The order of planners: the search, those of the textbook, those of others.
const fn rank(method: &Method) -> usize {
    match method {
        Method::Search => 0,
        Method::Planner(_) => 1,
        Method::Command(_) => 2,
    }
}

fn case(row: &Row) -> Case<'_> {
    (&row.instance, row.agents)
}

fn first_cost(objective: &Objective) -> Option<Cost> {
    objective.costs().first().copied()
}

impl Comparison {
    fn new(rows: &[&Row], several: &BTreeSet<&Method>) -> Self {
        let cost = rows
            .iter()
            .find_map(|row| first_cost(row.objective.as_ref()?));
        let mut known: BTreeMap<Case<'_>, Known> = BTreeMap::new();
        for row in rows {
            known.entry(case(row)).or_default().learn(row, cost);
        }
        let impossible = known.values().filter(|known| known.is_impossible).count();
        known.retain(|_, known| !known.is_impossible);
        let rows: Vec<&Row> = rows
            .iter()
            .copied()
            .filter(|row| known.contains_key(&case(row)))
            .collect();
        let mut planners: BTreeMap<(usize, String), Vec<&Row>> = BTreeMap::new();
        for row in &rows {
            let key = (rank(&row.planner), named(row, several));
            planners.entry(key).or_default().push(row);
        }
        let common = common(planners.values(), &known);
        let lines = planners
            .into_iter()
            .map(|((_, name), rows)| Line::new(name, &rows, &known, &common, cost));
        let agents = || known.keys().filter_map(|(_, agents)| *agents);
        let maps: BTreeSet<&str> = rows
            .iter()
            .map(|row| row.map.as_deref().unwrap_or(&row.instance))
            .collect();
        let tried = || rows.iter().filter(|row| row.status != RowStatus::Skipped);
        Self {
            cost: cost.map_or("cost", name),
            instances: known.len(),
            impossible,
            proved: known.values().filter(|known| known.is_proved).count(),
            bounded: known
                .values()
                .filter(|known| !known.is_proved && known.bound.is_some())
                .count(),
            common: common.len(),
            maps: maps.len(),
            agents: agents().min().zip(agents().max()),
            lines: lines.collect(),
            first: first::of_each_kind(&rows),
            contradictions: contradictions(&rows, &known, cost),
            limits: words::limits(&rows),
            runs: (
                tried().count(),
                tried().map(|row| row.took.wall_seconds).sum(),
            ),
        }
    }
}

/// Whether a planner did on a row what counts for it: a proof for one that proves, a legal
/// plan for the others.
pub(super) const fn is_solved(row: &Row) -> bool {
    match row.status {
        RowStatus::Optimal => !row.planner.proves() || row.complete,
        RowStatus::Feasible => !row.planner.proves(),
        RowStatus::Impossible
        | RowStatus::Unknown
        | RowStatus::Failed
        | RowStatus::Refused
        | RowStatus::Error
        | RowStatus::Skipped => false,
    }
}

/// The instances that all planners solved that solved any.
fn common<'a, 'b: 'a>(
    planners: impl Iterator<Item = &'a Vec<&'b Row>>,
    known: &BTreeMap<Case<'b>, Known>,
) -> BTreeSet<Case<'b>> {
    let mut common: BTreeSet<Case<'b>> = known.keys().copied().collect();
    let mut is_any = false;
    for rows in planners {
        let solved = rows.iter().copied().filter(|row| is_solved(row));
        let solved: BTreeSet<Case<'b>> = solved.map(case).collect();
        if !solved.is_empty() {
            is_any = true;
            common.retain(|case| solved.contains(case));
        }
    }
    if is_any { common } else { BTreeSet::new() }
}

/// The legal plans that cost less than is proved: either is wrong, and nobody should read on
/// without knowing it.
fn contradictions(
    rows: &[&Row],
    known: &BTreeMap<Case<'_>, Known>,
    cost: Option<Cost>,
) -> Vec<String> {
    let mut told = Vec::new();
    for row in rows.iter().filter(|row| is_solved(row)) {
        let bound = known.get(&case(row)).and_then(|known| known.bound);
        let value = row.costs.zip(cost).map(|(costs, cost)| costs.get(cost));
        if let (Some(bound), Some(value)) = (bound, value)
            && value < bound
        {
            told.push(format!(
                "{}: the plan of {} costs {value}, and at least {bound} was proved. One of them is wrong: please report it.",
                first::place(row),
                row.planner
            ));
        }
    }
    told
}
