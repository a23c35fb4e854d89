//! The first failure of each kind, with its instance, so that it can be run again.

use super::line::Kind;
use crate::{Method, Row};

/// A failure of a planner of others.
pub(in crate::table) struct First {
    /// Its kind, as at the head of the column.
    pub(super) kind: &'static str,
    pub(super) planner: String,
    /// The instance: `maze-32-32-2-even-1, 40 robots`.
    pub(super) place: String,
    /// How it failed, a phrase.
    pub(super) how: String,
}

/// The first failure of each kind, the fewest agents first.
pub(super) fn of_each_kind(rows: &[&Row]) -> Vec<First> {
    let is_command = |row: &&&Row| matches!(row.planner, Method::Command(_));
    let failed = rows.iter().filter(is_command);
    let failed = failed.filter_map(|row| Some((Kind::of(row)?, *row)));
    let is_told = |kind: Kind| matches!(kind, Kind::Failed(_) | Kind::Refused);
    let mut failed: Vec<(Kind, &Row)> = failed.filter(|(kind, _)| is_told(*kind)).collect();
    failed.sort_by_key(|(kind, row)| (*kind, row.agents, &row.instance));
    failed.dedup_by_key(|(kind, _)| *kind);
    let first = failed.into_iter().map(|(kind, row)| First {
        kind: kind.word(),
        planner: row.planner.to_string(),
        place: place(row),
        how: row
            .reason
            .clone()
            .unwrap_or_default()
            .trim_end_matches('.')
            .to_owned(),
    });
    first.collect()
}

/// An instance with its number of robots.
pub(super) fn place(row: &Row) -> String {
    let robots = row
        .agents
        .map(|agents| giveway_model::words::count(agents as u64, "robot"));
    match robots {
        Some(robots) => format!("{}, {robots}", row.instance),
        None => row.instance.clone(),
    }
}
