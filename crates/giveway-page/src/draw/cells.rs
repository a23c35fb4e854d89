//! The cells that a shape covers between two cells.

use giveway_model::fleet::straight;
use giveway_model::{Cell, Grid, Ground};

use super::{Drawing, Measure, Shape};

/// What a shape covers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Drawn {
    /// Its cells, each once.
    pub(crate) cells: Vec<Cell>,
    /// How many racks or blocks they are.
    pub(crate) pieces: u32,
}

/// What a shape covers from a cell to another one, both on the map. With [`Shape::Pen`] only the
/// last cell.
pub(crate) fn drawn(shape: Shape, from: Cell, to: Cell, sizes: &Drawing, grid: &Grid) -> Drawn {
    let every = sizes.measure(Measure::Every);
    let plain = |cells| Drawn { cells, pieces: 0 };
    match shape {
        Shape::Pen | Shape::One => plain(vec![to]),
        Shape::Aisle => plain(Area::of(from, to).cells().collect()),
        Shape::Rectangle => plain(spaced(Area::of(from, to), every).collect()),
        Shape::Line | Shape::Row => plain(straight(from, to).step_by(every as usize).collect()),
        Shape::Fill => plain(connected(grid, to)),
        Shape::Racks => racks(Area::of(from, to), sizes),
        Shape::Blocks => blocks(Area::of(from, to), sizes),
    }
}

/// All cells from a corner on, so many columns and rows.
#[derive(Clone, Copy)]
struct Area {
    corner: Cell,
    width: u32,
    height: u32,
}

impl Area {
    /// The cells between two corners, both included.
    fn of(one: Cell, other: Cell) -> Self {
        Self {
            corner: Cell::new(one.x.min(other.x), one.y.min(other.y)),
            width: one.x.abs_diff(other.x) + 1,
            height: one.y.abs_diff(other.y) + 1,
        }
    }

    fn cells(self) -> impl Iterator<Item = Cell> {
        let Self { corner, width, .. } = self;
        (0..self.height)
            .flat_map(move |y| (0..width).map(move |x| Cell::new(corner.x + x, corner.y + y)))
    }
}

/// The cells of an area, one every so many columns and rows. An area of one row or column has
/// them along it.
fn spaced(area: Area, every: u32) -> impl Iterator<Item = Cell> {
    let is_kept = move |cell: &Cell| {
        (cell.x - area.corner.x).is_multiple_of(every)
            && (cell.y - area.corner.y).is_multiple_of(every)
    };
    area.cells().filter(is_kept)
}

/// The cells of the same ground that are connected with a cell by their sides.
fn connected(grid: &Grid, from: Cell) -> Vec<Cell> {
    let Some(ground) = grid.ground(from) else {
        return Vec::new();
    };
    let mut seen = grid.clone();
    // Any other ground marks a cell that was come to.
    let other = match ground {
        Ground::Obstacle => Ground::Free,
        Ground::Free | Ground::Charger | Ground::Slow | Ground::SlowCharger => Ground::Obstacle,
    };
    seen.set_ground(from, other);
    let mut cells = vec![from];
    let mut next = 0;
    while let Some(&cell) = cells.get(next) {
        next += 1;
        let Cell { x, y } = cell;
        let sides = [
            (x.checked_sub(1), Some(y)),
            (x.checked_add(1), Some(y)),
            (Some(x), y.checked_sub(1)),
            (Some(x), y.checked_add(1)),
        ];
        for side in sides {
            let (Some(x), Some(y)) = side else { continue };
            let side = Cell::new(x, y);
            if seen.ground(side) == Some(ground) {
                seen.set_ground(side, other);
                cells.push(side);
            }
        }
    }
    cells
}

/// Racks along the longer side, with aisles between them. What does not fit stays free at the
/// far side.
fn racks(area: Area, sizes: &Drawing) -> Drawn {
    let (depth, aisle) = (
        sizes.measure(Measure::RackDepth),
        sizes.measure(Measure::RackAisle),
    );
    let lies_across = area.width >= area.height;
    let side = if lies_across { area.height } else { area.width };
    let depth = depth.min(side);
    let pieces = (side - depth) / (depth + aisle) + 1;
    let is_in = |place: u32| place / (depth + aisle) < pieces && place % (depth + aisle) < depth;
    let covers = |cell: &Cell| {
        is_in(if lies_across {
            cell.y - area.corner.y
        } else {
            cell.x - area.corner.x
        })
    };
    Drawn {
        cells: area.cells().filter(covers).collect(),
        pieces,
    }
}

/// Blocks in rows and columns, as many as fit.
fn blocks(area: Area, sizes: &Drawing) -> Drawn {
    let gap = sizes.measure(Measure::BlockGap);
    let fit = |side: u32, measure| {
        let length = sizes.measure(measure).min(side);
        (length, (side - length) / (length + gap) + 1)
    };
    let (width, columns) = fit(area.width, Measure::BlockWidth);
    let (height, rows) = fit(area.height, Measure::BlockHeight);
    let is_in = |place: u32, length: u32, count: u32| {
        place / (length + gap) < count && place % (length + gap) < length
    };
    let covers = |cell: &Cell| {
        is_in(cell.x - area.corner.x, width, columns) && is_in(cell.y - area.corner.y, height, rows)
    };
    Drawn {
        cells: area.cells().filter(covers).collect(),
        pieces: columns * rows,
    }
}
