//! How far it is to a goal, from everywhere: the table of an agent without a
//! battery or waypoints, of which nothing is counted.
//!
//! A breadth-first search backwards from the goal, around what the agent must not do at any
//! time. In a crowd of a thousand
//! these tables are most of what is held, so a number takes two bytes where
//! no distance is too large for them.

use super::{
    cost_to_go::Metric,
    task::{Bounds, Task},
};
use crate::{
    budget::{Budget, Stop},
    terrain::{Terrain, Vertex},
};

/// Distances to the nearest of some vertices, mostly one goal.
pub(super) enum Distances {
    /// In two bytes a vertex.
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
            && task.conditions.only_forbids()
            && matches!(task.bounds, Bounds::Free)
    }

    /// The memory that they take.
    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::Narrow(table) => 2 * table.len(),
            Self::Wide(table) => 4 * table.len(),
        }
    }

    /// Measures them: in two bytes each where the farthest vertex allows it, as it
    /// does on all but the largest mazes.
    pub(super) fn new(
        task: &Task,
        terrain: &Terrain,
        metric: Metric,
        budget: &dyn Budget,
    ) -> Result<Self, Stop> {
        budget.check()?;
        let roads = Roads::of(task, terrain, metric);
        match Self::narrow(&roads, budget)? {
            Some(narrow) => Ok(narrow),
            None => Self::wide(&roads, budget),
        }
    }

    /// In two bytes each; `None` where a distance is too large for them.
    fn narrow(roads: &Roads, budget: &dyn Budget) -> Result<Option<Self>, Stop> {
        let mut table = vec![u16::MAX; roads.terrain.size()];
        let mut fits = true;
        roads.measure(budget, |v, cost| {
            let entry = &mut table[v as usize];
            let first = *entry == u16::MAX;
            match u16::try_from(cost) {
                Ok(cost) if cost < u16::MAX => {
                    if first {
                        *entry = cost;
                    }
                    first
                }
                // The rest stays unknown, and the table is of no use.
                _ => {
                    fits &= !first;
                    false
                }
            }
        })?;
        Ok(fits.then_some(Self::Narrow(table)))
    }

    fn wide(roads: &Roads, budget: &dyn Budget) -> Result<Self, Stop> {
        let mut table = vec![u32::MAX; roads.terrain.size()];
        roads.measure(budget, |v, cost| {
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

/// Where an agent may go at all.
struct Roads<'a> {
    ends: Vec<Vertex>,
    task: &'a Task,
    terrain: &'a Terrain,
    metric: Metric,
    /// Whether all arcs and vertices are free.
    are_free: bool,
}

impl<'a> Roads<'a> {
    fn of(task: &'a Task, terrain: &'a Terrain, metric: Metric) -> Self {
        let mut ends = task.ends(terrain);
        ends.retain(|&end| task.may_stand(end, 0, None));
        Self {
            ends,
            are_free: task.conditions.forbidden.is_empty(),
            task,
            terrain,
            metric,
        }
    }

    /// Meets the vertices in the order of their distance. `meet` is true for a
    /// vertex that it did not know; one may come again, farther.
    fn measure(
        &self,
        budget: &dyn Budget,
        mut meet: impl FnMut(Vertex, u32) -> bool,
    ) -> Result<(), Stop> {
        // Vertices at this distance, and one and two further on.
        let mut layers = [self.ends.clone(), Vec::new(), Vec::new()];
        let mut cost = 0;
        while layers.iter().any(|layer| !layer.is_empty()) {
            let [now, next, second] = &mut layers;
            budget.spend(now.len() as u64)?;
            for v in now.drain(..) {
                if !meet(v, cost) {
                    continue;
                }
                for arc in self.terrain.arcs(v) {
                    if !(self.are_free || self.leads(arc.to, arc.id ^ 1)) {
                        continue;
                    }
                    match self.metric.of_move(arc.slow) {
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

    /// Whether the agent may be at a vertex and cross an arc from there, at some time.
    fn leads(&self, from: Vertex, arc: u32) -> bool {
        self.task.conditions.may_cross(arc, None) && self.task.may_stand(from, 0, None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        budget::Unlimited,
        single::CostToGo,
        tests::{instance, random},
    };

    #[test]
    fn they_are_the_same_in_two_bytes_and_in_four() {
        let budget = Unlimited::default();
        let (mut known, mut unknown) = (0, 0);
        for seed in 0..100 {
            let instance = random(seed, 1);
            let terrain = Terrain::new(instance.grid());
            let agent = &instance.agents()[0];
            let Ok(mut task) = Task::new(agent, instance.rules(), &terrain) else {
                continue;
            };
            for goal in 0..terrain.size() as Vertex {
                task.goal = Some(goal);
                for metric in [Metric::Time, Metric::Moves] {
                    let roads = Roads::of(&task, &terrain, metric);
                    let narrow = Distances::narrow(&roads, &budget).unwrap();
                    let narrow = narrow.unwrap();
                    let wide = Distances::wide(&roads, &budget).unwrap();
                    for v in 0..terrain.size() as Vertex {
                        assert_eq!(narrow.from(v), wide.from(v));
                        known += u32::from(wide.from(v).is_some());
                        unknown += u32::from(wide.from(v).is_none());
                    }
                }
            }
        }
        assert!(
            known > 1_000 && unknown > 50,
            "{known} known, {unknown} not"
        );
    }

    #[test]
    fn only_a_way_that_is_too_long_for_two_bytes_takes_four() {
        let budget = Unlimited::default();
        // To and fro through so many rows of 512 cells, with a wall after each.
        for (rows, each) in [(127, 2), (128, 4)] {
            let free = vec!["."; 512].join(" ");
            let wall = vec!["#"; 511].join(" ");
            let mut lines = Vec::new();
            for row in 0..rows {
                if row > 0 {
                    let gap = [format!(". {wall}"), format!("{wall} .")];
                    lines.push(gap[row % 2].clone());
                }
                lines.push(free.clone());
            }
            lines[0].replace_range(..3, "a A");
            let snake = instance(&lines.join("\n"));
            let terrain = Terrain::new(snake.grid());
            let mut task = Task::new(&snake.agents()[0], snake.rules(), &terrain).unwrap();
            task.goal = Some(task.start);
            let table = Distances::new(&task, &terrain, Metric::Time, &budget).unwrap();
            assert_eq!(table.bytes(), each * terrain.size());
            let all = (0..terrain.size() as Vertex).filter_map(|v| table.from(v));
            assert_eq!(all.max(), Some(rows as u32 * 513 - 2));
        }
    }

    #[test]
    fn a_table_of_a_plain_task_takes_two_bytes_a_cell() {
        let instance = instance("a . . ~ ~ A");
        let terrain = Terrain::new(instance.grid());
        let agent = &instance.agents()[0];
        let task = Task::new(agent, instance.rules(), &terrain).unwrap();
        let budget = Unlimited::default();
        let table = CostToGo::new(&task, &terrain, Metric::Time, &budget).unwrap();
        assert_eq!(budget.held_bytes().get(), 12);
        assert_eq!(table.from(task.start, 0, 0), Some(6));
    }
}
