//! The cost to go of one agent alone, from every vertex: exact tables.
//!
//! A backward search from the goal over (vertex, waypoints visited) with labels
//! *(cost, need)*: with a battery level of at least `need` the task can be
//! ended at `cost`. The labels of a state form a staircase (more cost, less
//! need), so battery levels themselves never have to be listed. It is the
//! label-setting shortest path with one resource of Desrochers and Soumis
//! (1988), run backwards.

use giveway_model::constraint::Heading;

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

struct BackwardSearch<'a> {
    task: &'a Task,
    terrain: &'a Terrain,
    metric: Metric,
    /// The directions that states tell apart.
    headings: usize,
    /// The least need of a label settled so far, by state.
    least_need: Vec<u32>,
    /// Labels to expand, by cost.
    buckets: Vec<Vec<(Spot, u32)>>,
    found: Vec<(u32, Label)>,
}

/// A vertex, the direction of the move by which it was entered, and a mask.
type Spot = (Vertex, usize, Mask);

impl BackwardSearch<'_> {
    fn run(&mut self, budget: &dyn Budget) -> Result<(), Stop> {
        for end in self.task.ends(self.terrain) {
            if self.task.may_stand(end, self.task.all(), None) {
                for heading in 0..self.headings {
                    self.push((end, heading, self.task.all()), 0, 0);
                }
            }
        }
        let mut cost = 0;
        while cost < self.buckets.len() {
            // First in, first out: among labels of one cost those with less
            // need come first, or nearly so, and few are settled twice.
            let mut next = 0;
            while let Some(&(spot, need)) = self.buckets[cost].get(next) {
                next += 1;
                budget.tick()?;
                let state = self.state(spot);
                if need < self.least_need[state] {
                    self.least_need[state] = need;
                    let cost = cost as u32;
                    self.found.push((state as u32, Label { cost, need }));
                    self.expand(spot, cost, need);
                }
            }
            self.buckets[cost] = Vec::new();
            cost += 1;
        }
        Ok(())
    }

    /// Pushes the states from which one move leads to a spot.
    fn expand(&mut self, (v, heading, mask): Spot, cost: u32, need: u32) {
        let terrain = self.terrain;
        if let Some(path) = self.task.along() {
            let before = mask.checked_sub(1);
            let u = before.and_then(|before| path.get(before as usize));
            let arc = terrain.arcs(v).iter().find(|arc| Some(&arc.to) == u);
            if let (Some(before), Some(arc)) = (before, arc)
                && self.task.may_cross(arc.id ^ 1, None)
                && self.task.may_stand(arc.to, before, None)
            {
                let cost = cost + self.metric.of_move(arc.slow);
                let before = (arc.to, heading, before);
                self.step_back(before, cost, need, 1 + u32::from(arc.slow));
            }
            return;
        }
        let bit = self.task.bit(v);
        for arc in terrain.arcs(v) {
            let u = arc.to;
            let forth = arc.id ^ 1;
            if !self.task.may_cross(forth, None) || !self.is_entered_by(forth, heading) {
                continue;
            }
            let cost = cost + self.metric.of_move(arc.slow);
            let steps = 1 + u32::from(arc.slow);
            let crossed = self.task.crossed(forth, None);
            if mask & crossed != crossed {
                continue; // whoever came that way has crossed the arc
            }
            // Each set of the bits may be new with this move.
            let bits = bit | crossed;
            let mut new: Mask = 0;
            loop {
                let before = mask & !new;
                // Being at u has visited u's own waypoint.
                let visited = before & self.task.bit(u) == self.task.bit(u);
                if visited && self.task.may_stand(u, before, None) {
                    for facing in 0..self.headings {
                        let cost = cost + self.turning(facing, heading);
                        self.step_back((u, facing, before), cost, need, steps);
                    }
                }
                if new == bits {
                    break;
                }
                new = new.wrapping_sub(bits) & bits;
            }
        }
    }

    /// Whether a move over an arc has a direction; any where states tell none apart.
    fn is_entered_by(&self, arc: u32, heading: usize) -> bool {
        self.headings == 1 || self.terrain.heading(arc).map(|it| it as usize) == Some(heading)
    }

    /// The steps of a turn from one direction to another.
    fn turning(&self, facing: usize, heading: usize) -> u32 {
        let direction = |number: usize| Heading::ALL.get(number);
        let turns = self.task.conditions.turns().filter(|_| self.headings > 1);
        let quarter = turns.map_or(0, |turns| turns.quarter);
        let both = direction(facing).zip(direction(heading));
        quarter.saturating_mul(both.map_or(0, |(from, to)| from.quarters_to(*to)))
    }

    fn step_back(&mut self, spot: Spot, cost: u32, need: u32, steps: u32) {
        let Some(reserve) = self.task.reserve else {
            self.push(spot, cost, 0);
            return;
        };
        if need + steps <= reserve.full {
            self.push(spot, cost, need + steps);
        }
        // A charge fills the battery for the next time step already.
        if self.task.may_charge(self.terrain, spot.0, None) && need + steps <= reserve.full + 1 {
            self.push(spot, cost + self.metric.of_charge(), 0);
        }
    }

    fn push(&mut self, spot: Spot, cost: u32, need: u32) {
        // Settled labels cost no more than this one, so less need must show.
        if need >= self.least_need[self.state(spot)] {
            return;
        }
        let bucket = cost as usize;
        if self.buckets.len() <= bucket {
            self.buckets.resize(bucket + 1, Vec::new());
        }
        self.buckets[bucket].push((spot, need));
    }

    fn state(&self, (v, heading, mask): Spot) -> usize {
        (v as usize * self.headings + heading) * stride(self.task) + mask as usize
    }
}
