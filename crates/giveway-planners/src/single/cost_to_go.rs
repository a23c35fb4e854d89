//! The cost to go of one agent alone, from every vertex: exact tables.
//!
//! A backward search from the goal over (vertex, waypoints visited) with labels
//! *(cost, need)*: with a battery level of at least `need` the task can be
//! ended at `cost`. The labels of a state form a staircase (more cost, less
//! need), so battery levels themselves never have to be listed. It is the
//! label-setting shortest path with one resource of Desrochers and Soumis
//! (1988), run backwards.

use super::{
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
    _held: MemoryUse,
}

enum Table {
    /// Of an agent that has only to reach its goal: one number a vertex.
    Distances(Distances),
    /// Of all others.
    Labels(Labels),
}

/// The labels of all states.
struct Labels {
    /// States from one vertex to the next; none where the mask tells the vertex.
    stride: usize,
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
            let distances = Distances::new(task.ends(terrain), terrain, metric, budget)?;
            let held = budget.hold(distances.bytes());
            let table = Table::Distances(distances);
            return Ok(Self { table, _held: held });
        }
        // Where this overflows, as it can in 32 bits, no memory is enough.
        let vertices = if task.along().is_some() {
            1
        } else {
            terrain.size()
        };
        let states = vertices.checked_mul(task.masks());
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
            least_need: vec![u32::MAX; states],
            buckets: vec![Vec::new()],
            found: Vec::new(),
        };
        search.run(budget)?;
        held.less(states * 4);
        let labels = Labels::collect(stride(task), states, &search.found);
        Ok(Self {
            table: Table::Labels(labels),
            _held: held,
        })
    }

    /// The least cost from a vertex at which the waypoints of `mask` are
    /// visited, with a battery level of `level`; `None` where the task cannot
    /// be ended from there.
    pub fn from(&self, v: Vertex, mask: Mask, level: u32) -> Option<u32> {
        match &self.table {
            Table::Distances(distances) => distances.from(v),
            Table::Labels(labels) => labels.from(v, mask, level),
        }
    }
}

impl Labels {
    fn from(&self, v: Vertex, mask: Mask, level: u32) -> Option<u32> {
        let state = v as usize * self.stride + mask as usize;
        let (begin, end) = (self.begins[state] as usize, self.begins[state + 1] as usize);
        let labels = &self.entries[begin..end];
        let enough = labels.iter().find(|label| label.need <= level);
        enough.map(|label| label.cost)
    }

    /// Sorts the labels by state, each state's by cost; where two have one
    /// cost, only the later, with less need, is kept.
    fn collect(stride: usize, states: usize, found: &[(u32, Label)]) -> Self {
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
            begins,
            entries: labels,
        }
    }
}

/// States from one vertex to the next.
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
    /// The least need of a label settled so far, by state.
    least_need: Vec<u32>,
    /// Labels to expand, by cost.
    buckets: Vec<Vec<(Vertex, Mask, u32)>>,
    found: Vec<(u32, Label)>,
}

impl BackwardSearch<'_> {
    fn run(&mut self, budget: &dyn Budget) -> Result<(), Stop> {
        for end in self.task.ends(self.terrain) {
            if self.task.may_stand(end, self.task.all(), None) {
                self.push(end, self.task.all(), 0, 0);
            }
        }
        let mut cost = 0;
        while cost < self.buckets.len() {
            // First in, first out: among labels of one cost those with less
            // need come first, or nearly so, and few are settled twice.
            let mut next = 0;
            while let Some(&(v, mask, need)) = self.buckets[cost].get(next) {
                next += 1;
                budget.tick()?;
                let state = self.state(v, mask);
                if need < self.least_need[state] {
                    self.least_need[state] = need;
                    let cost = cost as u32;
                    self.found.push((state as u32, Label { cost, need }));
                    self.expand(v, mask, cost, need);
                }
            }
            self.buckets[cost] = Vec::new();
            cost += 1;
        }
        Ok(())
    }

    /// Pushes the states from which one move leads to (v, mask).
    fn expand(&mut self, v: Vertex, mask: Mask, cost: u32, need: u32) {
        let terrain = self.terrain;
        if let Some(path) = self.task.along() {
            let before = mask.checked_sub(1);
            let u = before.and_then(|before| path.get(before as usize));
            let arc = terrain.arcs(v).iter().find(|arc| Some(&arc.to) == u);
            if let (Some(before), Some(arc)) = (before, arc) {
                let cost = cost + self.metric.of_move(arc.slow);
                self.step_back(arc.to, before, cost, need, 1 + u32::from(arc.slow));
            }
            return;
        }
        let bit = self.task.bit(v);
        for arc in terrain.arcs(v) {
            let u = arc.to;
            let forth = arc.id ^ 1;
            if !self.task.may_cross(forth, None) {
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
                    self.step_back(u, before, cost, need, steps);
                }
                if new == bits {
                    break;
                }
                new = new.wrapping_sub(bits) & bits;
            }
        }
    }

    fn step_back(&mut self, u: Vertex, mask: Mask, cost: u32, need: u32, steps: u32) {
        let Some(reserve) = self.task.reserve else {
            self.push(u, mask, cost, 0);
            return;
        };
        if need + steps <= reserve.full {
            self.push(u, mask, cost, need + steps);
        }
        // A charge fills the battery for the next time step already.
        if self.task.may_charge(self.terrain, u, None) && need + steps <= reserve.full + 1 {
            self.push(u, mask, cost + self.metric.of_charge(), 0);
        }
    }

    fn push(&mut self, v: Vertex, mask: Mask, cost: u32, need: u32) {
        // Settled labels cost no more than this one, so less need must show.
        if need >= self.least_need[self.state(v, mask)] {
            return;
        }
        let bucket = cost as usize;
        if self.buckets.len() <= bucket {
            self.buckets.resize(bucket + 1, Vec::new());
        }
        self.buckets[bucket].push((v, mask, need));
    }

    fn state(&self, v: Vertex, mask: Mask) -> usize {
        v as usize * stride(self.task) + mask as usize
    }
}
