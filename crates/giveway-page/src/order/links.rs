//! All links of the plan as a table.

use giveway_model::{Cell, sorting, tr};
use giveway_order::{Link, Order, words};

use super::crossing::index;
use crate::State;
use crate::words::at;

/// At most so many rows are shown; the file has all of them.
const MOST_ROWS: usize = 300;

/// All links of the plan, by time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Links {
    /// How many there are, and what they say.
    pub lead: String,
    /// The rows, by time.
    pub rows: Vec<LinkRow>,
    /// How many more there are, where not all are shown.
    pub more: Option<String>,
}

/// Who is in a cell after whom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkRow {
    /// Who leaves: its index and its name.
    pub first: (Option<usize>, String),
    /// Who comes.
    pub second: (Option<usize>, String),
    /// Where.
    pub cell: Cell,
    /// The same in words.
    pub at: String,
    /// When the first one begins to leave.
    pub leaves: u32,
    /// When the second one begins to come.
    pub comes: u32,
    /// How many steps later the first one may leave before the second one has to wait.
    pub slack: u32,
    /// Whether the second one follows in the same step.
    pub is_tight: bool,
}

/// All links, where they are shown.
pub(super) fn links(state: &State, order: &Order) -> Option<Links> {
    if !state.view.order.is_whole {
        return None;
    }
    let mut links: Vec<&Link> = order.links.iter().collect();
    sorting::sort_by_key(&mut links, |link| (link.second.time, link.first.time));
    let more = links.len().saturating_sub(MOST_ROWS);
    let row = |link: &Link| LinkRow {
        first: (index(state, &link.first.agent), link.first.agent.clone()),
        second: (index(state, &link.second.agent), link.second.agent.clone()),
        cell: link.cell,
        at: at(link.cell),
        leaves: link.first.time,
        comes: link.second.time,
        slack: link.slack,
        is_tight: link.slack == 0 && link.gap == 0,
    };
    Some(Links {
        lead: words::links(order),
        rows: links.into_iter().take(MOST_ROWS).map(row).collect(),
        more: (more > 0).then(|| {
            tr!("{n} more link is in the file." | "{n} more links are in the file." % more as u32)
        }),
    })
}
