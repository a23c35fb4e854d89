//! What lies on the floor, in tiles: where a cell changes, only the tiles around it
//! are drawn anew.

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::{Cell, Grid};

use super::Detail;
use super::outline::Area;
use super::tile::Tile;
use crate::Draft;

/// The side of a tile, in cells. It is small enough to be drawn anew in every frame
/// of a stroke, and large enough that a map has few of them.
pub const TILE: u32 = 16;

/// How the floor is drawn, by the size of a cell on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloorLook {
    /// Whether cells are large enough for more than their colour.
    pub(super) is_fine: bool,
    /// How far shapes that are cut reach into the next tile, in units: at least a
    /// pixel, and less than two.
    pub(super) overlap: u8,
}

impl FloorLook {
    /// The look for cells of this many pixels.
    pub fn of(cell_px: f64) -> Self {
        // Powers of two, so that zooming seldom changes it.
        let reaches = |&overlap: &u8| f64::from(overlap) * cell_px >= super::CELL;
        let overlaps = [1, 2, 4, 8, 16, 32, 64];
        Self {
            is_fine: Detail::of(cell_px) > Detail::Dots,
            overlap: overlaps.into_iter().find(reaches).unwrap_or(100),
        }
    }

    /// Whether lines part the cells.
    pub const fn has_lines(self) -> bool {
        self.is_fine
    }
}

/// What is drawn of the floor, each over all that stand before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// The tint of the slow zone.
    SlowTint,
    /// Its hatch.
    Slow,
    /// The line around it.
    SlowEdge,
    /// Shelves of obstacles.
    Obstacle,
    /// The lines around them.
    ObstacleEdge,
    /// The plates of chargers.
    Charger,
    /// The bolts on them.
    Bolt,
}

impl Layer {
    /// How many there are.
    pub(super) const COUNT: usize = 7;

    /// Its class in the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::SlowTint => "slow-t",
            Self::Slow => "slow",
            Self::SlowEdge => "slow-edge",
            Self::Obstacle => "obst",
            Self::ObstacleEdge => "obst-edge",
            Self::Charger => "chg",
            Self::Bolt => "bolt",
        }
    }
}

/// The floor of a map.
#[derive(Clone, Debug)]
pub struct Floor {
    draft: Rc<Draft>,
    /// The chargers that a waypoint lies on.
    starred: BTreeSet<Cell>,
    look: FloorLook,
    /// Rows of tiles, from the top.
    bands: Vec<Rc<Band>>,
}

/// A row of tiles, from the left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Band(Vec<Rc<Tile>>);

impl Band {
    /// The `d` of the paths of a layer, by the number of the tile; those without a
    /// shape are left out.
    pub fn shapes(&self, layer: Layer) -> impl Iterator<Item = (usize, &Rc<str>)> {
        let shapes = self.0.iter().map(move |tile| tile.shape(layer));
        shapes.enumerate().filter(|(_, shape)| !shape.is_empty())
    }
}

impl Floor {
    /// The floor of a draft.
    pub fn new(draft: &Rc<Draft>, look: FloorLook) -> Self {
        let (grid, starred) = (draft.grid(), starred(draft));
        let columns = grid.width().div_ceil(TILE);
        let band = |y| {
            let tile = |x| Rc::new(Tile::new(grid, &starred, area(grid, x, y), look));
            Rc::new(Band((0..columns).map(tile).collect()))
        };
        Self {
            bands: (0..grid.height().div_ceil(TILE)).map(band).collect(),
            draft: Rc::clone(draft),
            starred,
            look,
        }
    }

    /// The floor of another draft, with the tiles of this one wherever they are the
    /// same.
    #[must_use]
    pub fn renewed(&self, draft: &Rc<Draft>, look: FloorLook) -> Self {
        let (old, new) = (self.draft.grid(), draft.grid());
        if look != self.look || (old.width(), old.height()) != (new.width(), new.height()) {
            return Self::new(draft, look);
        }
        if Rc::ptr_eq(&self.draft, draft) {
            return self.clone();
        }
        let starred = starred(draft);
        let stars: Vec<Cell> = self
            .starred
            .symmetric_difference(&starred)
            .copied()
            .collect();
        let is_same =
            |area: Area| !stars.iter().any(|&star| area.contains(star)) && is_same(old, new, area);
        let mut bands = self.bands.clone();
        for (y, band) in (0..).zip(&mut bands) {
            let row = Area {
                size: (new.width(), area(new, 0, y).size.1),
                ..area(new, 0, y)
            };
            if is_same(row) {
                continue;
            }
            for (x, tile) in (0..).zip(&mut Rc::make_mut(band).0) {
                let area = area(new, x, y);
                if !is_same(area) {
                    *tile = Rc::new(Tile::new(new, &starred, area, look));
                }
            }
        }
        Self {
            draft: Rc::clone(draft),
            starred,
            look,
            bands,
        }
    }

    /// Rows of tiles, from the top.
    pub fn bands(&self) -> &[Rc<Band>] {
        &self.bands
    }
}

/// The cells of a tile, by its column and row.
fn area(grid: &Grid, x: u32, y: u32) -> Area {
    let first = Cell::new(TILE * x, TILE * y);
    Area {
        first,
        size: (
            TILE.min(grid.width().saturating_sub(first.x)),
            TILE.min(grid.height().saturating_sub(first.y)),
        ),
    }
}

/// Whether all is the same of two maps that an area is drawn by: its cells and
/// those around it.
fn is_same(old: &Grid, new: &Grid, area: Area) -> bool {
    let around = |first: u32, size: u32| first.saturating_sub(1)..first + size + 1;
    let columns = around(area.first.x, area.size.0);
    let part = columns.start as usize..columns.end.min(new.width()) as usize;
    let mut rows = around(area.first.y, area.size.1);
    rows.all(|y| old.row(y).get(part.clone()) == new.row(y).get(part.clone()))
}

/// The chargers that a waypoint lies on.
fn starred(draft: &Draft) -> BTreeSet<Cell> {
    let waypoints = draft.agents().iter().flat_map(|agent| &agent.waypoints);
    let on_charger = waypoints.filter(|&&cell| draft.grid().is_charger(cell));
    on_charger.copied().collect()
}

/// The `d` of the lines between cells.
pub fn lines(width: u32, height: u32) -> String {
    let (right, bottom) = (100 * width, 100 * height);
    let across = (1..width).map(|x| format!("M{} 0V{bottom}", 100 * x));
    let down = (1..height).map(|y| format!("M0 {}H{right}", 100 * y));
    across.chain(down).collect()
}

#[cfg(test)]
mod tests;
