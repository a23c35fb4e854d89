//! How far it is to a goal, from everywhere: the table of an agent without a
//! battery, waypoints or a demand.
//!
//! A breadth-first search backwards from the goal. In a crowd of a thousand
//! these tables are most of what is held, so a number takes two bytes where
//! the map is small enough for all distances.

use super::{
    cost_to_go::Metric,
    task::{Bounds, Task},
};
use crate::{
    budget::{Budget, Stop},
    terrain::{Terrain, Vertex},
};

/// Distances to one goal.
pub(super) enum Distances {
    /// In two bytes each.
    Narrow(Vec<u16>),
    /// In four.
    Wide(Vec<u32>),
}

impl Distances {
    /// Whether a task has nothing but a goal that could matter to this metric.
    pub(super) fn suffice(task: &Task, metric: Metric) -> bool {
        metric != Metric::Charges
            && task.reserve.is_none()
            && task.waypoints.is_empty()
            && task.demand.is_none()
            && matches!(task.bounds, Bounds::Free)
    }

    /// Whether no distance is too large for two bytes: a way visits each vertex
    /// once, and a move costs at most 2.
    fn is_narrow(terrain: &Terrain) -> bool {
        terrain.size() < usize::from(u16::MAX) / 2
    }

    /// The memory that they take.
    pub(super) fn bytes(terrain: &Terrain) -> usize {
        let each = if Self::is_narrow(terrain) { 2 } else { 4 };
        terrain.size().saturating_mul(each)
    }

    /// Measures them.
    pub(super) fn new(
        goal: Vertex,
        terrain: &Terrain,
        metric: Metric,
        budget: &dyn Budget,
    ) -> Result<Self, Stop> {
        budget.check()?;
        if Self::is_narrow(terrain) {
            let mut table = vec![u16::MAX; terrain.size()];
            measure(goal, terrain, metric, budget, |v, cost| {
                let entry = &mut table[v as usize];
                let first = *entry == u16::MAX;
                if first {
                    *entry = cost as u16;
                }
                first
            })?;
            return Ok(Self::Narrow(table));
        }
        let mut table = vec![u32::MAX; terrain.size()];
        measure(goal, terrain, metric, budget, |v, cost| {
            let entry = &mut table[v as usize];
            let first = *entry == u32::MAX;
            if first {
                *entry = cost;
            }
            first
        })?;
        Ok(Self::Wide(table))
    }

    /// The distance from a vertex; `None` where the goal cannot be reached.
    pub(super) fn from(&self, v: Vertex) -> Option<u32> {
        match self {
            Self::Narrow(table) => {
                let distance = table[v as usize];
                (distance != u16::MAX).then_some(u32::from(distance))
            }
            Self::Wide(table) => {
                let distance = table[v as usize];
                (distance != u32::MAX).then_some(distance)
            }
        }
    }
}

/// Meets the vertices in the order of their distance. `meet` is true for a
/// vertex that it did not know; one may come again, farther.
fn measure(
    goal: Vertex,
    terrain: &Terrain,
    metric: Metric,
    budget: &dyn Budget,
    mut meet: impl FnMut(Vertex, u32) -> bool,
) -> Result<(), Stop> {
    // Vertices at this distance, and one and two further on.
    let mut layers = [vec![goal], Vec::new(), Vec::new()];
    let mut cost = 0;
    while layers.iter().any(|layer| !layer.is_empty()) {
        budget.tick()?;
        let [now, next, second] = &mut layers;
        for v in now.drain(..) {
            if !meet(v, cost) {
                continue;
            }
            for arc in terrain.arcs(v) {
                match metric.of_move(arc.slow) {
                    1 => next.push(arc.to),
                    _ => second.push(arc.to),
                }
            }
        }
        layers.rotate_left(1);
        cost += 1;
    }
    Ok(())
}
