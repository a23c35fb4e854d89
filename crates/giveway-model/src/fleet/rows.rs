//! The cells of a row, and which of them are starts and goals.

use std::collections::BTreeSet;

use super::{Fleet, Way};
use crate::{Agent, Cell, Grid};

impl Fleet {
    /// The starts with their goals: those that go there, and those that come back.
    pub(super) fn ways(&self, grid: &Grid, there: &[Agent]) -> [Vec<Way>; 2] {
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
            let without = starts.into_iter().map(|start| (start, None));
            return [without.collect(), Vec::new()];
        };
        let goals = row(goals, &is_reached);
        let count = self
            .chosen(&starts, usize::MAX)
            .len()
            .min(self.chosen(&goals, usize::MAX).len());
        let (starts, goals) = (self.chosen(&starts, count), self.chosen(&goals, count));
        let pairs = || starts.iter().copied().zip(goals.iter().copied());
        let go: Vec<Way> = pairs().map(|(from, to)| (from, Some(to))).collect();
        let come: Vec<Way> = pairs().map(|(from, to)| (to, Some(from))).collect();
        let mut ways = [go, if self.back { come } else { Vec::new() }];
        // Where both rows lie over each other, a cell has room for one start and one goal.
        let (mut starts, mut goals) = (BTreeSet::new(), BTreeSet::new());
        for ways in &mut ways {
            ways.retain(|&(start, goal)| {
                let is_free =
                    !starts.contains(&start) && goal.is_none_or(|goal| !goals.contains(&goal));
                if is_free {
                    starts.insert(start);
                    goals.extend(goal);
                }
                is_free
            });
        }
        ways
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
}

/// The cells from one to another one, in the one of eight directions that is nearest.
pub fn straight(from: Cell, to: Cell) -> impl Iterator<Item = Cell> {
    let (across, down) = (from.x.abs_diff(to.x), from.y.abs_diff(to.y));
    let (x, y, steps) = if 2 * down < across {
        (true, false, across)
    } else if 2 * across < down {
        (false, true, down)
    } else {
        // Both ends of a diagonal lie on the map.
        (true, true, across.min(down))
    };
    (0..=steps).map(move |step| {
        let go = |from: u32, to: u32, moves: bool| match moves {
            true if to > from => from + step,
            true => from.saturating_sub(step),
            false => from,
        };
        Cell::new(go(from.x, to.x, x), go(from.y, to.y, y))
    })
}
