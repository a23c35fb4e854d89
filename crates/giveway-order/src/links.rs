//! Links: in each cell, from one agent to the next.

use std::collections::BTreeMap;

use giveway_model::Cell;
use giveway_model::change::History;
use giveway_model::sorting::sort_by_key;

use crate::events::{Event, Time, Way};
use crate::rules::GapRules;

/// An agent leaves a cell, and another one comes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EventLink {
    pub(crate) cell: Cell,
    /// The event with which the first one leaves.
    pub(crate) leaves: usize,
    /// The event with which the second one comes.
    pub(crate) comes: usize,
    /// The least steps between their begins.
    pub(crate) gap: Time,
}

/// A visit of a cell: when, the agent, and the event with which it comes.
type CellVisit = (u32, usize, usize);

/// The links of all cells, row by row, in each by time. They are entered into the events, too.
pub(crate) fn link(history: &History, ways: &[Way<'_>], events: &mut [Event]) -> Vec<EventLink> {
    let gaps = GapRules::of(history);
    let mut cells: BTreeMap<(u32, u32), Vec<CellVisit>> = BTreeMap::new();
    for (agent, way) in ways.iter().enumerate() {
        for (number, stay) in (way.first..).zip(&way.stays) {
            let key = (stay.cell.y, stay.cell.x);
            let visits = cells.entry(key).or_default();
            visits.push((stay.arrives, agent, number));
        }
    }
    let mut links = Vec::new();
    for ((y, x), mut visits) in cells {
        sort_by_key(&mut visits, |&(time, _, event)| (time, event));
        for (number, &(arrives, agent, comes)) in visits.iter().enumerate() {
            let (Some(second), Some(event)) = (ways.get(agent), events.get_mut(comes)) else {
                continue;
            };
            let moves = Time::from(arrives) - event.planned;
            let earlier = visits.get(..number).unwrap_or(&[]).iter().rev();
            let mut closed_most = 0;
            for (distance, &(_, other, before)) in earlier.enumerate() {
                let Some(first) = ways.get(other) else {
                    continue;
                };
                let leaves = before + 1;
                if leaves >= first.first + first.events() {
                    continue;
                }
                if distance == 0 {
                    event.cell_before = Some(leaves);
                }
                // An agent that comes again follows itself, and waited for those before then.
                if other == agent {
                    break;
                }
                // The cell is closed for so many steps after the first was there, and the move
                // takes some of them.
                let closed = gaps.between(first.name(), second.name());
                let gap = match closed {
                    0 => 0,
                    _ => (closed + 1 - moves).max(0),
                };
                // Beyond the one before it, only a longer gap counts.
                if distance == 0 || gap > closed_most {
                    closed_most = closed_most.max(gap);
                    event.after.push((leaves, gap));
                    links.push(EventLink {
                        cell: Cell::new(x, y),
                        leaves,
                        comes,
                        gap,
                    });
                }
                if gaps.longest() <= closed {
                    break;
                }
            }
        }
    }
    links
}
