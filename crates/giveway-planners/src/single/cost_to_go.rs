//! The cost to go of one agent alone, from every vertex: exact tables.
//!
//! A backward search from the goal over (vertex, waypoints visited) with labels
//! *(cost, need)*: with a battery level of at least `need` the task can be
//! ended at `cost`. The labels of a state form a staircase (more cost, less
//! need), so battery levels themselves never have to be listed. It is the
//! label-setting shortest path with one resource of Desrochers and Soumis
//! (1988), run backwards.

mod backward;

use super::{
    Automaton,
    distances::Distances,
    task::{Mask, Task},
};
use crate::{
    budget::MemoryUse,
    budget::{Budget, Stop},
    terrain::{Terrain, Vertex},
};
use backward::BackwardSearch;

/// The cost that a table counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// Time steps up to the arrival.
    Time,
    /// Charges.
    Charges,
    /// Cell-to-cell moves.
    Moves,
}

impl Metric {
    pub(super) const fn of_move(self, slow: bool) -> u32 {
        match self {
            Self::Time => 1 + slow as u32,
            Self::Charges => 0,
            Self::Moves => 1,
        }
    }

    const fn of_charge(self) -> u32 {
        matches!(self, Self::Charges) as u32
    }
}

#[derive(Clone, Copy, Debug)]
struct Label {
    cost: u32,
    need: u32,
}

/// The table of one agent and metric.
pub struct CostToGo {
    table: Table,
    /// What the time of an agent depends on beside the table; of other metrics empty.
    counted: Automaton,
    _held: MemoryUse,
}

enum Table {
    /// Of an agent that has only to reach its goal, where nothing is counted: one number a vertex.
    Distances(Distances),
    /// Of all others.
    Labels(Labels),
}

/// The labels of all states.
struct Labels {
    /// States from one vertex and direction to the next; none where the mask tells the vertex.
    stride: usize,
    /// The directions that states tell apart.
    headings: usize,
    /// Where the labels of each state begin; one more entry than states.
    begins: Vec<u32>,
    entries: Vec<Label>,
}

impl CostToGo {
    /// Computes the table.
    ///
    /// # Errors
    /// When the budget is spent.
    pub fn new(
        task: &Task,
        terrain: &Terrain,
        metric: Metric,
        budget: &dyn Budget,
    ) -> Result<Self, Stop> {
        if Distances::suffice(task, metric) {
            let distances = Distances::new(task, terrain, metric, budget)?;
            let held = budget.hold(distances.bytes());
            return Ok(Self {
                table: Table::Distances(distances),
                counted: Automaton::default(),
                _held: held,
            });
        }
        // Where this overflows, as it can in 32 bits, no memory is enough.
        let vertices = if task.along().is_some() {
            1
        } else {
            terrain.size()
        };
        let headings = headings(task, metric);
        let states = vertices.checked_mul(headings);
        let states = states.and_then(|states| states.checked_mul(task.masks()));
        let bytes = states.and_then(|states| states.checked_mul(16));
        let (Some(states), Some(bytes)) = (states, bytes) else {
            return Err(Stop::Memory);
        };
        let mut held = budget.hold(bytes);
        budget.check()?;
        let mut search = BackwardSearch {
            task,
            terrain,
            metric,
            headings,
            least_need: vec![u32::MAX; states],
            buckets: vec![Vec::new()],
            found: Vec::new(),
        };
        search.run(budget)?;
        held.less(states * 4);
        let labels = Labels::collect((stride(task), headings), states, &search.found);
        let counters = match metric {
            Metric::Time => task.conditions.counters.clone(),
            Metric::Charges | Metric::Moves => Vec::new(),
        };
        Ok(Self {
            table: Table::Labels(labels),
            counted: Automaton {
                counters,
                ..Automaton::default()
            },
            _held: held,
        })
    }

    /// The least cost from a vertex at which the waypoints of `mask` are
    /// visited, with a battery level of `level`; `None` where the task cannot
    /// be ended from there.
    pub fn from(&self, v: Vertex, mask: Mask, level: u32) -> Option<u32> {
        let labels = match &self.table {
            Table::Distances(distances) => return distances.from(v),
            Table::Labels(labels) => labels,
        };
        let facing = self.counted.facing(mask).filter(|_| labels.headings > 1);
        let Some((heading, stood)) = facing else {
            let cost = labels.from((v, NO_HEADING), mask, level)?;
            return Some(cost + self.counted.still_to_stand(mask));
        };
        let any = labels.from((v, NO_HEADING), mask, level)?;
        let Some(heading) = heading else {
            return Some(any);
        };
        // Each step for which it has stood may be one of the turn.
        let turned = labels.from((v, heading as usize), mask, level)?;
        Some(turned.saturating_sub(stood).max(any))
    }
}

/// The direction of an agent that faces nowhere yet: the last one, or the only one where
/// states tell none apart.
const NO_HEADING: usize = 4;

/// The number of directions that states tell apart.
fn headings(task: &Task, metric: Metric) -> usize {
    let turns =
        metric == Metric::Time && task.along().is_none() && task.conditions.turns().is_some();
    if turns { NO_HEADING + 1 } else { 1 }
}

impl Labels {
    fn from(&self, (v, heading): (Vertex, usize), mask: Mask, level: u32) -> Option<u32> {
        let heading = heading.min(self.headings - 1);
        let state =
            (v as usize * self.headings + heading) * self.stride + Task::set_of(mask) as usize;
        let (begin, end) = (self.begins[state] as usize, self.begins[state + 1] as usize);
        let labels = &self.entries[begin..end];
        let enough = labels.iter().find(|label| label.need <= level);
        enough.map(|label| label.cost)
    }

    /// Sorts the labels by state, each state's by cost; where two have one
    /// cost, only the later, with less need, is kept.
    fn collect((stride, headings): (usize, usize), states: usize, found: &[(u32, Label)]) -> Self {
        let mut begins = vec![0u32; states + 1];
        for (state, _) in found {
            begins[*state as usize + 1] += 1;
        }
        for i in 0..states {
            begins[i + 1] += begins[i];
        }
        let mut labels = vec![Label { cost: 0, need: 0 }; found.len()];
        let mut next = begins.clone();
        for (state, label) in found {
            let place = &mut next[*state as usize];
            labels[*place as usize] = *label;
            *place += 1;
        }
        // Of labels with one cost the last has the least need: give it to all.
        for state in 0..states {
            let range = begins[state] as usize..begins[state + 1] as usize;
            for i in range.rev().skip(1) {
                if labels[i].cost == labels[i + 1].cost {
                    labels[i].need = labels[i + 1].need;
                }
            }
        }
        Self {
            stride,
            headings,
            begins,
            entries: labels,
        }
    }
}

/// States from one vertex and direction to the next.
fn stride(task: &Task) -> usize {
    match task.along() {
        Some(_) => 0,
        None => task.masks(),
    }
}
