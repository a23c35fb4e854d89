//! What lies on the floor, in tiles: where a cell changes, only the tiles around it
//! are drawn anew.

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_model::{Cell, Grid};
use giveway_picture::{Area, FloorLook, Layer, Tile, starred as stars_on_chargers};

use crate::Draft;

/// The side of a tile, in cells. It is small enough to be drawn anew in every frame
/// of a stroke, and large enough that a map has few of them.
pub const TILE: u32 = 16;

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
    stars_on_chargers(draft.grid(), draft.agents())
}

#[cfg(test)]
mod tests;
