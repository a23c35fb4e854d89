//! Cells that matter: what closing them would come to.

use giveway_model::{Cell, tr};
use giveway_solve::freedom::{Closed, FreedomAnswer};
use giveway_solve::price::words::amount;

use crate::freedom::cells::matters;
use crate::freedom::words::{outcome, reach, worse};
use crate::words::at;

/// Cells that matter.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// A line for each thing that closing a cell comes to, the worst first.
    pub rows: Vec<CellRow>,
    /// What else there is to know.
    pub remark: Option<String>,
}

/// A cell to close for a look.
#[derive(Clone, Debug, PartialEq)]
pub struct CellRow {
    /// The cell.
    pub cell: Cell,
    /// `Close (5, 2): makespan 10, not 8`.
    pub title: String,
    /// `and 4 more cells that cost 2 steps of the makespan`, and how far that is proved; may be empty.
    pub detail: String,
}

/// How bad it is that cells are closed: the least is the worst.
type Rank = (bool, usize, i64);
/// Cells of one rank.
type Group<'a> = Vec<(Cell, &'a Closed)>;

pub(super) fn cells(told: &FreedomAnswer, is_counting: bool) -> Option<Cells> {
    let all = told.critical.as_ref()?;
    let mut groups: Vec<(Rank, Group<'_>)> = Vec::new();
    for it in all.iter().filter(|it| matters(&it.closed)) {
        // No plan is the worst; then more of the first cost; then more of a later one.
        let rank = match worse(&told.objective, &it.closed) {
            None => (false, 0, 0),
            Some((place, _, delta)) => (true, place, -delta),
        };
        match groups.iter_mut().find(|(other, _)| *other == rank) {
            Some((_, cells)) => cells.push((it.cell, &it.closed)),
            None => groups.push((rank, vec![(it.cell, &it.closed)])),
        }
    }
    groups.sort_by_key(|(rank, _)| *rank);
    let row = |(_, cells): &(Rank, Group<'_>)| {
        let &(cell, closed) = cells.first()?;
        let parts = [more(told, closed, cells.len() - 1), reach(closed)];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        Some(CellRow {
            cell,
            title: tr!(
                "Close {cell}: {outcome}",
                cell = at(cell),
                outcome = outcome(told, closed)?
            ),
            detail: parts.join(". "),
        })
    };
    let rows: Vec<CellRow> = groups.iter().filter_map(row).collect();
    let open = all.iter().filter(|it| it.closed.is_open()).count();
    let remark = match open {
        0 if rows.is_empty() => {
            Some(tr!("Any other cell could be closed, and a plan would be as good.").to_owned())
        }
        0 => None,
        // The status tells how many are to go.
        _ if is_counting => None,
        open => Some(tr!("{n} cell is open: nobody knows what closing it costs."
            | "{n} cells are open: nobody knows what closing them costs." % open)),
    };
    Some(Cells { rows, remark })
}

/// `and 4 more cells that cost 2 steps of the makespan`.
fn more(told: &FreedomAnswer, closed: &Closed, others: usize) -> Option<String> {
    if others == 0 {
        return None;
    }

    Some(match worse(&told.objective, closed) {
        None => tr!(
            "closing leaves no plan" => "and {n} more cell that leaves none"
                | "and {n} more cells that leave none" % others
        ),
        Some((_, cost, delta)) => tr!(
            "and {n} more cell that costs {price}"
                | "and {n} more cells that cost {price}" % others,
            price = amount(cost, delta)
        ),
    })
}
