//! Which rows of the table are shown, and in which order. An edit in the table moves no row: it
//! keeps its place until the table is sorted or filtered anew.

use std::cmp::Ordering;
use std::rc::Rc;

use super::filter::{by_nature, column, fits};
use super::rows::all_rows;
use super::{Column, Row};
use crate::State;

/// The rows that were shown before an edit, in their order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct HeldRows {
    /// Their indices among all rows.
    shown: Rc<[usize]>,
    /// How many rows there were: with another number of them these are not held.
    all: usize,
}

/// Which of all rows are shown, in their order: those of the scene come first, by their index,
/// then those that are given and new.
pub(crate) fn shown(state: &State) -> Vec<usize> {
    let rows = all_rows(state);
    let view = &state.view.robots;
    let held = view.held.as_ref().filter(|held| held.all == rows.len());
    if let Some(held) = held.filter(|_| !has_new_results(state)) {
        return held.shown.to_vec();
    }
    let mut shown: Vec<(usize, &Row)> = rows.iter().enumerate().collect();
    shown.retain(|(_, row)| fits(row, &view.filter));
    if let Some(sort) = view.sort {
        shown.sort_by(|(_, a), (_, b)| order(a, b, sort));
    }
    shown.into_iter().map(|(index, _)| index).collect()
}

/// The rows that are shown, to be held while something is edited.
pub(crate) fn hold(state: &State) -> HeldRows {
    HeldRows {
        shown: shown(state).into(),
        all: all_rows(state).len(),
    }
}

/// Whether rows stand in the order of a column.
pub(super) fn is_sorted(rows: &[Row], sort: (Column, bool)) -> bool {
    rows.is_sorted_by(|a, b| order(a, b, sort).is_le())
}

fn order(a: &Row, b: &Row, (column, is_back): (Column, bool)) -> Ordering {
    let text = |row: &Row| row.text(column).unwrap_or_default().to_owned();
    let order = by_nature(&text(a), &text(b));
    if is_back { order.reverse() } else { order }
}

/// Whether rows that are sorted or filtered by results have new ones.
fn has_new_results(state: &State) -> bool {
    let view = &state.view.robots;
    let sorted = view.sort.map(|(column, _)| column);
    let mut columns = sorted.into_iter().chain(column(&view.filter));
    columns.any(Column::is_result) && state.document.fresh_answer().is_some()
}
