//! The robots that a fleet consists of: the same words always give the same ones.

use std::collections::BTreeSet;

use giveway_model::{Agent, Cell, Grid};

use super::Fleet;
use crate::Draft;
use crate::draw::straight;
use crate::edit::fresh_names;
use crate::problems::Parts;

impl Fleet {
    /// The robots, as many as there are free starts and goals for; until it is known where they
    /// go, without goals.
    pub(crate) fn agents(&self, draft: &Draft) -> Vec<Agent> {
        let grid = draft.grid();
        let there = draft.agents();
        let is_start = |cell: &Cell| there.iter().any(|agent| agent.start == *cell);
        let is_goal = |cell: &Cell| there.iter().any(|agent| agent.goal == Some(*cell));
        let row = |(from, to): (Cell, Cell), is_taken: &dyn Fn(&Cell) -> bool| -> Vec<Cell> {
            let free = straight(from, to).filter(|&cell| grid.is_vertex(cell));
            free.filter(|cell| !is_taken(cell)).collect()
        };
        // A cell from which one starts and where one that comes back ends is used for both.
        let is_used = |cell: &Cell| is_start(cell) || (self.back && is_goal(cell));
        let is_reached = |cell: &Cell| is_goal(cell) || (self.back && is_start(cell));
        let starts = row(self.starts, &is_used);
        let Some(goals) = self.goals else {
            let starts = self.chosen(&starts, usize::MAX);
            return self.named(
                starts.into_iter().map(|start| (start, None)).collect(),
                draft,
            );
        };
        let goals = row(goals, &is_reached);
        let count = self
            .chosen(&starts, usize::MAX)
            .len()
            .min(self.chosen(&goals, usize::MAX).len());
        let (starts, goals) = (self.chosen(&starts, count), self.chosen(&goals, count));
        let pairs = || starts.iter().copied().zip(goals.iter().copied());
        let mut ways: Vec<(Cell, Option<Cell>)> =
            pairs().map(|(from, to)| (from, Some(to))).collect();
        if self.back {
            ways.extend(pairs().map(|(from, to)| (to, Some(from))));
        }
        // Where both rows lie over each other, a cell has room for one start and one goal.
        let (mut starts, mut goals) = (BTreeSet::new(), BTreeSet::new());
        ways.retain(|&(start, goal)| {
            let is_free =
                !starts.contains(&start) && goal.is_none_or(|goal| !goals.contains(&goal));
            if is_free {
                starts.insert(start);
                goals.extend(goal);
            }
            is_free
        });
        self.named(ways, draft)
    }

    /// Of free cells in a row those that are taken: one every few, or so many evenly.
    fn chosen(&self, cells: &[Cell], most: usize) -> Vec<Cell> {
        let Some(count) = self.count else {
            let every = cells.iter().step_by(self.every.max(1) as usize);
            return every.take(most).copied().collect();
        };
        let count = (count as usize).min(cells.len()).min(most);
        let last = cells.len().saturating_sub(1);
        let place = |index: usize| match count {
            1 => 0,
            count => index * last / (count - 1),
        };
        (0..count)
            .filter_map(|index| cells.get(place(index)).copied())
            .collect()
    }

    /// The robots by their ways, with names, waypoints and battery.
    fn named(&self, ways: Vec<(Cell, Option<Cell>)>, draft: &Draft) -> Vec<Agent> {
        let room = crate::MAX_AGENTS.saturating_sub(draft.agents().len());
        let names = fresh_names(draft.scene(), ways.len().min(room));
        let mut waypoints = Waypoints::of(draft.grid(), &ways, self.draw);
        let agent = |(name, (start, goal)): (String, (Cell, Option<Cell>))| Agent {
            waypoints: goal.map_or_else(Vec::new, |_| waypoints.draw(start, self.waypoints)),
            name,
            start,
            goal,
            battery: self.battery,
            heading: None,
        };
        names.into_iter().zip(ways).map(agent).collect()
    }
}

/// Cells for waypoints, in the order of a draw.
struct Waypoints {
    parts: Parts,
    cells: Vec<Cell>,
    next: usize,
}

impl Waypoints {
    /// Cells beside obstacles that are neither start nor goal, shuffled; any free cells where
    /// there is no obstacle.
    fn of(grid: &Grid, ways: &[(Cell, Option<Cell>)], draw: u32) -> Self {
        let taken: BTreeSet<Cell> = ways
            .iter()
            .flat_map(|&(start, goal)| [Some(start), goal])
            .flatten()
            .collect();
        let free = grid.cells().map(|(cell, _)| cell);
        let free: Vec<Cell> = free
            .filter(|&cell| grid.is_vertex(cell) && !taken.contains(&cell))
            .collect();
        let is_obstacle = |x: Option<u32>, y: Option<u32>| {
            let cell = x.zip(y).map(|(x, y)| Cell::new(x, y));
            cell.is_some_and(|cell| grid.ground(cell).is_some() && !grid.is_vertex(cell))
        };
        let is_beside = |&Cell { x, y }: &Cell| {
            is_obstacle(x.checked_sub(1), Some(y))
                || is_obstacle(x.checked_add(1), Some(y))
                || is_obstacle(Some(x), y.checked_sub(1))
                || is_obstacle(Some(x), y.checked_add(1))
        };
        let beside: Vec<Cell> = free.iter().copied().filter(is_beside).collect();
        let mut cells = if beside.is_empty() { free } else { beside };
        fastrand::Rng::with_seed(draw.into()).shuffle(&mut cells);
        Self {
            parts: Parts::of(grid),
            cells,
            next: 0,
        }
    }

    /// The next cells that a robot can come to from its start.
    fn draw(&mut self, start: Cell, count: u32) -> Vec<Cell> {
        let part = self.parts.number(start);
        let mut drawn = Vec::new();
        for _ in 0..self.cells.len() {
            if drawn.len() == count as usize {
                break;
            }
            let cell = self.cells.get(self.next % self.cells.len()).copied();
            self.next += 1;
            drawn.extend(cell.filter(|&cell| self.parts.number(cell) == part));
        }
        drawn
    }
}
