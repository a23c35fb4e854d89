//! How far the battery of an agent lasts: the best level with which it can come
//! to each cell, and the least one with which it can still end from there.

use std::collections::BinaryHeap;

use giveway_model::{Agent, Battery, Cell, Grid};

/// Where a battery lasts.
pub(crate) enum Reach {
    /// Everywhere, or nobody knows.
    Unlimited,
    /// By cell, row by row.
    Levels {
        width: u32,
        /// The best level on arrival; `None` where it never comes.
        best: Vec<Option<u32>>,
        /// The least level from which the goal can be reached, where there is one.
        least: Vec<Option<u32>>,
    },
}

impl Reach {
    /// Whether it comes to a cell at all.
    pub(crate) fn arrives(&self, cell: Cell) -> bool {
        match self {
            Self::Unlimited => true,
            Self::Levels { width, best, .. } => best[index(*width, cell)].is_some(),
        }
    }

    /// Whether it comes to a cell with enough to end its task from there.
    pub(crate) fn goes_on(&self, cell: Cell) -> bool {
        match self {
            Self::Unlimited => true,
            Self::Levels { width, best, least } => {
                let at = index(*width, cell);
                matches!((best[at], least[at]), (Some(best), Some(least)) if best >= least)
            }
        }
    }
}

const fn index(width: u32, cell: Cell) -> usize {
    cell.y as usize * width as usize + cell.x as usize
}

/// Where the battery of an agent lasts, whose cells are all on the map; `steps`
/// are those that may still be taken.
pub(crate) fn reach(grid: &Grid, agent: &Agent, floor: u32, steps: &mut usize) -> Reach {
    let Some(battery) = agent.battery else {
        return Reach::Unlimited;
    };
    let table = Table {
        grid,
        battery,
        floor,
    };
    let best = table.best(agent.start, steps);
    let least = match agent.goal {
        Some(goal) => table.least(goal, steps),
        // It may rest wherever it is.
        None => Some(vec![Some(floor); best.as_ref().map_or(0, Vec::len)]),
    };
    match (best, least) {
        (Some(best), Some(least)) => Reach::Levels {
            width: grid.width(),
            best,
            least,
        },
        _ => Reach::Unlimited,
    }
}

struct Table<'a> {
    grid: &'a Grid,
    battery: Battery,
    floor: u32,
}

impl Table<'_> {
    /// A charge fills the battery within the step that begins there, so that it
    /// is as if the agent left with one more than it can hold.
    const fn charged(&self) -> u32 {
        self.battery.capacity.saturating_add(1)
    }

    fn costs(&self, cell: Cell, next: Cell) -> u32 {
        1 + u32::from(self.grid.is_slow_edge(cell, next))
    }

    fn can_charge(&self, cell: Cell) -> bool {
        self.grid.is_charger(cell) && self.battery.capacity >= self.floor
    }

    /// The best level on arrival at each cell; `None` where it takes too long.
    fn best(&self, start: Cell, steps: &mut usize) -> Option<Vec<Option<u32>>> {
        let first = Some(self.battery.initial).filter(|&level| level >= self.floor);
        let leaves = |cell, level: u32| {
            let charged = if self.can_charge(cell) {
                self.charged()
            } else {
                0
            };
            level.max(charged)
        };
        let arrives = |cell, next, level| {
            let level = leaves(cell, level).checked_sub(self.costs(cell, next));
            level.filter(|&level| level >= self.floor)
        };
        self.spread(start, first, arrives, |level| level, steps)
    }

    /// The least level on arrival from which the goal can be reached, by cell;
    /// `None` where it takes too long.
    fn least(&self, goal: Cell, steps: &mut usize) -> Option<Vec<Option<u32>>> {
        let arrives = |cell, before, need: u32| {
            let need = need.saturating_add(self.costs(cell, before));
            let is_charged = self.can_charge(before) && need <= self.charged();
            Some(if is_charged { self.floor } else { need })
        };
        let order = |need| u32::MAX - need;
        self.spread(goal, Some(self.floor), arrives, order, steps)
    }

    /// From a first cell on to all that can be reached, those of the highest
    /// order first; a cell is taken again when something better is found for it.
    fn spread(
        &self,
        from: Cell,
        first: Option<u32>,
        arrives: impl Fn(Cell, Cell, u32) -> Option<u32>,
        order: impl Fn(u32) -> u32,
        steps: &mut usize,
    ) -> Option<Vec<Option<u32>>> {
        let width = self.grid.width();
        let mut found = vec![None; width as usize * self.grid.height() as usize];
        let mut open = BinaryHeap::new();
        if let Some(first) = first {
            found[index(width, from)] = Some(first);
            open.push((order(first), from));
        }
        while let Some((rank, cell)) = open.pop() {
            let Some(level) = found[index(width, cell)].filter(|&level| order(level) == rank)
            else {
                continue;
            };
            *steps = steps.checked_sub(1)?;
            for next in self.grid.neighbours(cell) {
                let Some(new) = arrives(cell, next, level) else {
                    continue;
                };
                let old = &mut found[index(width, next)];
                if old.is_none_or(|old| order(new) > order(old)) {
                    *old = Some(new);
                    open.push((order(new), next));
                }
            }
        }
        Some(found)
    }
}
