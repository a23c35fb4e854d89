//! Shelf blocks, which are obstacles that are connected, and aisles of one cell between them.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cell, Grid};

/// An aisle is this long at least: a shorter one is a gap between shelves.
const SHORTEST: usize = 3;

/// The shelf blocks of a floor: the number of the block of each obstacle.
pub(crate) fn shelf_blocks(grid: &Grid) -> BTreeMap<Cell, usize> {
    let mut blocks = BTreeMap::new();
    let obstacles = grid.cells().filter(|(_, ground)| !ground.is_vertex());
    let mut count = 0;
    for (cell, _) in obstacles {
        if blocks.contains_key(&cell) {
            continue;
        }
        let mut next = vec![cell];
        blocks.insert(cell, count);
        while let Some(cell) = next.pop() {
            for beside in around(cell) {
                let is_obstacle = grid.ground(beside).is_some_and(|it| !it.is_vertex());
                if is_obstacle && !blocks.contains_key(&beside) {
                    blocks.insert(beside, count);
                    next.push(beside);
                }
            }
        }
        count += 1;
    }
    blocks
}

/// The cells beside a cell, on the floor or not.
fn around(cell: Cell) -> impl Iterator<Item = Cell> {
    let Cell { x, y } = cell;
    let left = x.checked_sub(1).map(|x| Cell::new(x, y));
    let above = y.checked_sub(1).map(|y| Cell::new(x, y));
    let right = x.checked_add(1).map(|x| Cell::new(x, y));
    let below = y.checked_add(1).map(|y| Cell::new(x, y));
    [left, above, right, below].into_iter().flatten()
}

/// An aisle of one cell between two shelf blocks, or two parts of one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Aisle {
    /// Its cells, in a row or a column.
    pub(crate) cells: Vec<Cell>,
    /// The blocks on both sides.
    pub(crate) blocks: (usize, usize),
}

/// The longest aisle between each two blocks of which `counts` holds, the longest first.
pub(crate) fn aisles(
    grid: &Grid,
    blocks: &BTreeMap<Cell, usize>,
    counts: impl Fn(usize) -> bool,
) -> Vec<Aisle> {
    let free: BTreeSet<Cell> = grid
        .cells()
        .filter_map(|(cell, ground)| ground.is_vertex().then_some(cell))
        .collect();
    let mut longest: BTreeMap<(usize, usize), Vec<Cell>> = BTreeMap::new();
    for turned in [false, true] {
        let mut run: Option<Aisle> = None;
        let mut lines: Vec<Cell> = free.iter().copied().collect();
        giveway_model::sorting::sort_by_key(&mut lines, |cell| {
            if turned {
                (cell.x, cell.y)
            } else {
                (cell.y, cell.x)
            }
        });
        for cell in lines {
            let sides = sides(cell, turned).and_then(|(one, other)| {
                let (one, other) = (*blocks.get(&one)?, *blocks.get(&other)?);
                Some((one.min(other), one.max(other)))
            });
            let sides = sides.filter(|&(one, other)| counts(one) && counts(other));
            let goes_on = |run: &Aisle| {
                let last = run.cells.last();
                Some(run.blocks) == sides && last.is_some_and(|&last| follows(last, cell, turned))
            };
            match &mut run {
                Some(run) if goes_on(run) => run.cells.push(cell),
                ended => {
                    keep(&mut longest, ended.take());
                    *ended = sides.map(|blocks| Aisle {
                        cells: vec![cell],
                        blocks,
                    });
                }
            }
        }
        keep(&mut longest, run);
    }
    let mut aisles: Vec<Aisle> = longest
        .into_iter()
        .map(|(blocks, cells)| Aisle { cells, blocks })
        .collect();
    giveway_model::sorting::sort_by_key(&mut aisles, |aisle| std::cmp::Reverse(aisle.cells.len()));
    aisles
}

/// The cells on both sides of a row, or of a column.
fn sides(cell: Cell, turned: bool) -> Option<(Cell, Cell)> {
    let Cell { x, y } = cell;
    Some(if turned {
        (Cell::new(x.checked_sub(1)?, y), Cell::new(x + 1, y))
    } else {
        (Cell::new(x, y.checked_sub(1)?), Cell::new(x, y + 1))
    })
}

fn follows(last: Cell, cell: Cell, turned: bool) -> bool {
    if turned {
        cell.x == last.x && cell.y == last.y + 1
    } else {
        cell.y == last.y && cell.x == last.x + 1
    }
}

/// Keeps an aisle where it is the longest between its blocks.
fn keep(longest: &mut BTreeMap<(usize, usize), Vec<Cell>>, run: Option<Aisle>) {
    let Some(Aisle { cells, blocks }) = run.filter(|run| run.cells.len() >= SHORTEST) else {
        return;
    };
    let known = longest.entry(blocks).or_default();
    if cells.len() > known.len() {
        *known = cells;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> Grid {
        Grid::from_rows(&["......", ".####.", "......", ".####.", "......", ".#..#."]).unwrap()
    }

    #[test]
    fn connected_obstacles_are_one_block() {
        let blocks = shelf_blocks(&grid());
        let block = |x, y| blocks.get(&Cell::new(x, y)).copied();
        assert_eq!(block(1, 1), block(4, 1));
        assert_ne!(block(1, 1), block(1, 3));
        assert_ne!(block(1, 5), block(4, 5));
        assert_eq!(block(0, 0), None);
        assert_eq!(blocks.len(), 10);
    }

    #[test]
    fn an_aisle_lies_between_two_blocks() {
        let (grid, blocks) = (grid(), shelf_blocks(&grid()));
        let found = aisles(&grid, &blocks, |_| true);
        let cells: Vec<Cell> = (1..=4).map(|x| Cell::new(x, 2)).collect();
        // (Row 4 is one cell long at both ends, which is too short.)
        assert_eq!(
            found,
            [Aisle {
                cells,
                blocks: (0, 1)
            }]
        );
        assert_eq!(aisles(&grid, &blocks, |block| block != 0), []);
    }
}
