//! The map as the oracle sees it, read anew from the rows of characters.

use giveway_model::Cell;

/// The map: rows of characters.
pub(crate) struct World {
    rows: Vec<Vec<char>>,
}

impl World {
    /// Reads the rows `. # ~ + *`.
    pub(crate) fn new(rows: &[String]) -> Self {
        Self {
            rows: rows.iter().map(|row| row.chars().collect()).collect(),
        }
    }

    /// The character of a cell; off the map is an obstacle like any other.
    fn at(&self, cell: Cell) -> char {
        let row = self.rows.get(cell.y as usize);
        *row.and_then(|row| row.get(cell.x as usize)).unwrap_or(&'#')
    }

    /// Whether an agent may charge on the cell.
    pub(crate) fn is_charger(&self, cell: Cell) -> bool {
        matches!(self.at(cell), '+' | '*')
    }

    /// An edge is slow if both its ends lie in the slow zone.
    pub(crate) fn is_slow(&self, u: Cell, v: Cell) -> bool {
        matches!(self.at(u), '~' | '*') && matches!(self.at(v), '~' | '*')
    }

    /// The cells that an agent may move to from a cell.
    pub(crate) fn neighbours(&self, u: Cell) -> Vec<Cell> {
        let mut found = vec![Cell::new(u.x + 1, u.y), Cell::new(u.x, u.y + 1)];
        if u.x > 0 {
            found.push(Cell::new(u.x - 1, u.y));
        }
        if u.y > 0 {
            found.push(Cell::new(u.x, u.y - 1));
        }
        found.retain(|&v| self.at(v) != '#');
        found
    }
}
