//! What one planner came to.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Cost;

use super::gap::{Gap, Known};
use super::{Case, case, is_solved};
use crate::{Failure, Method, Row, RowStatus};

/// Why an instance is not solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::table) enum Kind {
    /// The planner failed. One of this project whose budget ran out is counted under time.
    Failed(Failure),
    /// The planner has no method for it, or cannot be given it.
    Refused,
    /// It was not tried, since smaller numbers of agents failed.
    Skipped,
    /// It has no row.
    Missing,
}

impl Kind {
    /// As it stands at the head of a column.
    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Failed(failure) => failure.word(),
            Self::Refused => "refused",
            Self::Skipped => "skipped",
            Self::Missing => "not run",
        }
    }

    /// The kinds that are always told, also where nobody failed so.
    const USUAL: [Self; 5] = [
        Self::Failed(Failure::Crashed),
        Self::Failed(Failure::Time),
        Self::Failed(Failure::Memory),
        Self::Failed(Failure::Illegal),
        Self::Failed(Failure::WrongCost),
    ];

    /// The columns of planners: the usual ones, and those that some planner needs.
    pub(super) fn columns_of(lines: &[&Line]) -> Vec<Self> {
        let failed = Failure::ALL.map(Self::Failed);
        let all = failed
            .into_iter()
            .chain([Self::Refused, Self::Skipped, Self::Missing]);
        let is_told = |kind: &Self| {
            Self::USUAL.contains(kind) || lines.iter().any(|line| line.failed.contains_key(kind))
        };
        all.filter(is_told).collect()
    }

    /// Why a row is not solved.
    pub(super) fn of(row: &Row) -> Option<Self> {
        if is_solved(row) {
            return None;
        }
        Some(match row.status {
            RowStatus::Refused => Self::Refused,
            RowStatus::Skipped => Self::Skipped,
            RowStatus::Error => Self::Missing,
            RowStatus::Failed => Self::Failed(row.failure.unwrap_or(Failure::Crashed)),
            RowStatus::Optimal
            | RowStatus::Feasible
            | RowStatus::Impossible
            | RowStatus::Unknown => Self::Failed(Failure::Time),
        })
    }
}

/// What one planner came to.
pub(in crate::table) struct Line {
    pub(super) name: String,
    /// A few words about it.
    pub(super) about: Option<String>,
    /// Whether it is the search, which the others stand beside.
    pub(super) is_reference: bool,
    pub(super) solved: usize,
    /// How many of its plans cost as much as is proved to be the least.
    pub(super) at_best: usize,
    /// Within so many CPU seconds each it solved half, and nine of ten, of what all solved.
    pub(super) half: Option<f64>,
    pub(super) nine_of_ten: Option<f64>,
    /// The median gap of what all solved.
    pub(super) median: Option<Gap>,
    /// The largest gap of all its plans.
    pub(super) largest: Option<Gap>,
    /// How many instances it did not solve, by why.
    pub(super) failed: BTreeMap<Kind, usize>,
    /// The CPU seconds of what it solved, the least first.
    pub(super) seconds: Vec<f64>,
    /// The median gap of its plans for each number of agents, up to the first number of
    /// which it solved fewer than half.
    pub(super) by_agents: Vec<(usize, Gap)>,
}

impl Line {
    pub(super) fn new(
        name: String,
        rows: &[&Row],
        known: &BTreeMap<Case<'_>, Known>,
        common: &BTreeSet<Case<'_>>,
        cost: Option<Cost>,
    ) -> Self {
        let gap = |row: &Row| {
            let bound = known.get(&case(row))?.bound?;
            Gap::new(row.costs?.get(cost?), bound)
        };
        let solved: Vec<&Row> = rows.iter().copied().filter(|row| is_solved(row)).collect();
        let gaps: Vec<(&Row, Gap)> = solved
            .iter()
            .filter_map(|&row| Some((row, gap(row)?)))
            .collect();
        let is_common = |row: &Row| common.contains(&case(row));
        let seconds = |rows: Vec<&Row>| {
            let mut seconds: Vec<f64> = rows.iter().map(|row| row.took.cpu_seconds).collect();
            seconds.sort_by(f64::total_cmp);
            seconds
        };
        let shared = seconds(
            solved
                .iter()
                .copied()
                .filter(|row| is_common(row))
                .collect(),
        );
        let mut failed: BTreeMap<Kind, usize> = BTreeMap::new();
        for kind in rows.iter().filter_map(|row| Kind::of(row)) {
            *failed.entry(kind).or_default() += 1;
        }
        let run: BTreeSet<Case<'_>> = rows.iter().map(|row| case(row)).collect();
        let missing = known.len() - run.len();
        if missing > 0 {
            *failed.entry(Kind::Missing).or_default() += missing;
        }
        let shared_gaps = gaps.iter().filter(|(row, _)| is_common(row));
        Self {
            name,
            about: rows.iter().find_map(|row| row.about.clone()),
            is_reference: rows.iter().any(|row| row.planner == Method::Search),
            solved: solved.len(),
            at_best: gaps.iter().filter(|(_, gap)| gap.percent() <= 0.0).count(),
            half: within(&shared, 5),
            nine_of_ten: within(&shared, 9),
            median: Gap::median(shared_gaps.map(|(_, gap)| *gap).collect()),
            largest: gaps.iter().map(|(_, gap)| *gap).max(),
            failed,
            seconds: seconds(solved.clone()),
            by_agents: by_agents(&solved, &gaps, known),
        }
    }
}

/// The least of sorted seconds within which so many tenths of them are.
fn within(seconds: &[f64], tenths: usize) -> Option<f64> {
    let count = (seconds.len() * tenths).div_ceil(10);
    seconds.get(count.checked_sub(1)?).copied()
}

fn by_agents(
    solved: &[&Row],
    gaps: &[(&Row, Gap)],
    known: &BTreeMap<Case<'_>, Known>,
) -> Vec<(usize, Gap)> {
    let mut all: BTreeMap<usize, usize> = BTreeMap::new();
    for agents in known.keys().filter_map(|(_, agents)| *agents) {
        *all.entry(agents).or_default() += 1;
    }
    let median = |(agents, count): (usize, usize)| {
        let is_here = |row: &Row| row.agents == Some(agents);
        let solved = solved.iter().filter(|row| is_here(row)).count();
        if 2 * solved < count {
            return None;
        }
        let gaps = gaps.iter().filter(|(row, _)| is_here(row));
        Some((agents, Gap::median(gaps.map(|(_, gap)| *gap).collect())))
    };
    let medians = all.into_iter().map_while(median);
    medians
        .filter_map(|(agents, gap)| Some((agents, gap?)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_two_are_within_the_first() {
        assert_eq!(within(&[], 5), None);
        assert_eq!(within(&[1.0, 2.0], 5), Some(1.0));
        assert_eq!(within(&[1.0, 2.0, 3.0], 5), Some(2.0));
        assert_eq!(within(&[1.0, 2.0, 3.0], 9), Some(3.0));
    }
}
