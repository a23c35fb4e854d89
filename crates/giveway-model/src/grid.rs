//! The map: a rectangle of cells, four neighbours each.

use crate::Cell;

/// The ground of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Ground {
    /// `.`: a free cell.
    Free,
    /// `#`: no vertex.
    Obstacle,
    /// `~`: a free cell of the slow zone.
    Slow,
    /// `+`: a cell where an agent may charge.
    Charger,
    /// `*`: a charger in the slow zone.
    SlowCharger,
}

impl Ground {
    /// The ground that a map character stands for, if any.
    pub const fn from_char(c: char) -> Option<Self> {
        match c {
            '.' => Some(Self::Free),
            '#' => Some(Self::Obstacle),
            '~' => Some(Self::Slow),
            '+' => Some(Self::Charger),
            '*' => Some(Self::SlowCharger),
            _ => None,
        }
    }

    /// The character of a map row.
    pub const fn to_char(self) -> char {
        match self {
            Self::Free => '.',
            Self::Obstacle => '#',
            Self::Slow => '~',
            Self::Charger => '+',
            Self::SlowCharger => '*',
        }
    }

    /// Whether an agent may stand here.
    pub const fn is_vertex(self) -> bool {
        !matches!(self, Self::Obstacle)
    }

    /// Whether an agent may charge here.
    pub const fn is_charger(self) -> bool {
        matches!(self, Self::Charger | Self::SlowCharger)
    }

    /// Whether the cell is in the slow zone.
    pub const fn is_slow(self) -> bool {
        matches!(self, Self::Slow | Self::SlowCharger)
    }

    /// A vertex that is a charger or not, in the slow zone or not.
    pub(crate) const fn vertex(is_charger: bool, is_slow: bool) -> Self {
        match (is_charger, is_slow) {
            (false, false) => Self::Free,
            (false, true) => Self::Slow,
            (true, false) => Self::Charger,
            (true, true) => Self::SlowCharger,
        }
    }
}

/// A rectangular map of at least one cell, rows from the top.
///
/// ```
/// use giveway_model::{Cell, Grid, Ground};
/// let grid = Grid::from_rows(&["..#", ".+~"]).unwrap();
/// assert_eq!((grid.width(), grid.height()), (3, 2));
/// assert_eq!(grid.ground(Cell::new(1, 1)), Some(Ground::Charger));
/// assert_eq!(grid.ground(Cell::new(3, 0)), None);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    width: u32,
    height: u32,
    cells: Vec<Ground>,
}

impl Default for Grid {
    /// One free cell: the least map there is.
    fn default() -> Self {
        Self {
            width: 1,
            height: 1,
            cells: vec![Ground::Free],
        }
    }
}

/// Why some rows are no map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GridError {
    /// There are no rows, or the first is empty.
    Empty,
    /// A row differs in length from the first.
    Ragged {
        /// The row, from 0.
        row: usize,
        /// Its length.
        found: usize,
        /// The length of the first row.
        expected: usize,
    },
    /// A character that stands for no ground.
    Unknown {
        /// The row, from 0.
        row: usize,
        /// The column, from 0.
        column: usize,
        /// The character.
        found: char,
    },
}

impl Grid {
    /// Reads a map from its rows, `. # ~ + *` each.
    ///
    /// # Errors
    /// When there is no cell, a row differs in length from the first, or a
    /// character is not one of the five.
    pub fn from_rows<S: AsRef<str>>(rows: &[S]) -> Result<Self, GridError> {
        let width = rows.first().map_or(0, |row| row.as_ref().chars().count());
        if width == 0 {
            return Err(GridError::Empty);
        }
        let mut cells = Vec::new();
        for (y, row) in rows.iter().enumerate() {
            for (x, c) in row.as_ref().chars().enumerate() {
                let ground = Ground::from_char(c).ok_or(GridError::Unknown {
                    row: y,
                    column: x,
                    found: c,
                })?;
                cells.push(ground);
            }
            let found = cells.len() - y * width;
            if found != width {
                return Err(GridError::Ragged {
                    row: y,
                    found,
                    expected: width,
                });
            }
        }
        Ok(Self {
            width: width as u32,
            height: rows.len() as u32,
            cells,
        })
    }

    /// Number of columns.
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// Number of rows.
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// The ground of a cell; `None` off the map.
    pub fn ground(&self, cell: Cell) -> Option<Ground> {
        if cell.x >= self.width || cell.y >= self.height {
            return None;
        }
        self.cells.get(self.index(cell)).copied()
    }

    /// The ground of the cells of a row, from the left; empty off the map.
    pub fn row(&self, y: u32) -> &[Ground] {
        let width = self.width as usize;
        let begin = (y as usize).saturating_mul(width);
        self.cells
            .get(begin..begin.saturating_add(width))
            .unwrap_or_default()
    }

    /// Whether the cell is on the map and no obstacle.
    pub fn is_vertex(&self, cell: Cell) -> bool {
        self.ground(cell).is_some_and(Ground::is_vertex)
    }

    /// Whether an agent may charge on the cell.
    pub fn is_charger(&self, cell: Cell) -> bool {
        self.ground(cell).is_some_and(Ground::is_charger)
    }

    /// Whether the cell is in the slow zone.
    pub fn is_slow(&self, cell: Cell) -> bool {
        self.ground(cell).is_some_and(Ground::is_slow)
    }

    /// Whether the edge between two neighbours is slow: both its ends are.
    pub fn is_slow_edge(&self, u: Cell, v: Cell) -> bool {
        self.is_slow(u) && self.is_slow(v)
    }

    /// The vertices that share a side with the cell, in a fixed order: up,
    /// left, right, down.
    pub fn neighbours(&self, cell: Cell) -> impl Iterator<Item = Cell> + '_ {
        let Cell { x, y } = cell;
        [
            y.checked_sub(1).map(|y| Cell::new(x, y)),
            x.checked_sub(1).map(|x| Cell::new(x, y)),
            x.checked_add(1).map(|x| Cell::new(x, y)),
            y.checked_add(1).map(|y| Cell::new(x, y)),
        ]
        .into_iter()
        .flatten()
        .filter(|&v| self.is_vertex(v))
    }

    /// All cells, row by row from the top.
    pub fn cells(&self) -> impl Iterator<Item = (Cell, Ground)> + '_ {
        let width = self.width as usize;
        self.cells.iter().enumerate().map(move |(i, &ground)| {
            let cell = Cell::new((i % width) as u32, (i / width) as u32);
            (cell, ground)
        })
    }

    /// Changes what lies on a cell; false off the map.
    pub fn set_ground(&mut self, cell: Cell, ground: Ground) -> bool {
        if self.ground(cell).is_none() {
            return false;
        }
        let index = self.index(cell);
        self.cells.get_mut(index).map(|it| *it = ground).is_some()
    }

    /// Changes what lies on each of the cells.
    pub fn change(&mut self, change: impl Fn(Cell, Ground) -> Ground) {
        let width = self.width as usize;
        for (i, ground) in self.cells.iter_mut().enumerate() {
            let cell = Cell::new((i % width) as u32, (i / width) as u32);
            *ground = change(cell, *ground);
        }
    }

    /// The map as text, one string a row.
    pub fn rows(&self) -> Vec<String> {
        self.cells
            .chunks(self.width as usize)
            .map(|row| row.iter().map(|g| g.to_char()).collect())
            .collect()
    }

    fn index(&self, cell: Cell) -> usize {
        cell.y as usize * self.width as usize + cell.x as usize
    }
}
