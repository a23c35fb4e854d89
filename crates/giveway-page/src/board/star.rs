//! The star of a broken rule: beside the robots that it is about, never over them.

use giveway_model::Cell;
use giveway_model::check::Violation;

use super::CELL;

/// Where a rule is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConflictPlace {
    /// On a cell.
    Cell(Cell),
    /// Between two cells.
    Edge([Cell; 2]),
}

/// A star on the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Star {
    /// Its middle, in units.
    pub at: (f64, f64),
    /// From its middle to its points, in units.
    pub radius: f64,
}

/// The radius of a star, in units; it has at least so many pixels.
const RADIUS: f64 = 24.0;
const LEAST_PX: f64 = 8.0;

/// How far a robot with its battery reaches from its middle, in units.
const REACH: f64 = 40.0;

impl ConflictPlace {
    /// Where a violation is; `None` where it names neither a cell nor an edge.
    pub(crate) fn of(violation: &Violation) -> Option<Self> {
        let cell = violation.cell.map(Self::Cell);
        cell.or_else(|| violation.edge.map(Self::Edge))
    }

    /// The middle of the place, in units.
    pub(crate) fn middle(self) -> (f64, f64) {
        let (one, other) = self.ends();
        let ((x, y), (u, v)) = (middle(one), middle(other));
        (f64::midpoint(x, u), f64::midpoint(y, v))
    }

    const fn ends(self) -> (Cell, Cell) {
        match self {
            Self::Cell(cell) => (cell, cell),
            Self::Edge([from, to]) => (from, to),
        }
    }

    /// The star, where cells have so many pixels: at the upper left corner of a cell,
    /// or beside the way between two cells. Where the map ends there, it is on the
    /// other side.
    pub fn star(self, cell_px: f64) -> Star {
        let radius = RADIUS.max(LEAST_PX * CELL / cell_px);
        let away = REACH + radius;
        let side = |n: u32| if n == 0 { away } else { -away };
        let (one, other) = self.ends();
        let (dx, dy) = if one == other {
            let half = std::f64::consts::FRAC_1_SQRT_2;
            (side(one.x) * half, side(one.y) * half)
        } else if one.y == other.y {
            (0.0, side(one.y))
        } else {
            (side(one.x), 0.0)
        };
        let (x, y) = self.middle();
        Star {
            at: (x + dx, y + dy),
            radius,
        }
    }
}

impl Star {
    /// How far right the middle of a label stands that this star would cover: beside the star, on its
    /// right where the map goes on there. `None` where it covers nothing of it. All in units; `half` of
    /// the width and of the height.
    pub fn aside(self, (x, y): (f64, f64), (half, high): (f64, f64), map_ends: f64) -> Option<f64> {
        let away = half + self.radius;
        let (across, down) = (self.at.0 - x, self.at.1 - y);
        let covers = across.abs() < away && down.abs() < high + self.radius;
        let right = self.at.0 + away;
        let is_room = right + half < map_ends;
        let aside = if is_room { right } else { self.at.0 - away };
        covers.then_some(aside)
    }
}

/// The middle of a cell, in units.
pub(crate) fn middle(cell: Cell) -> (f64, f64) {
    let middle = |n: u32| (f64::from(n.cast_signed()) + 0.5) * CELL;
    (middle(cell.x), middle(cell.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sizes of cells, in pixels: one at least for each level of detail.
    const SIZES: [f64; 7] = [4.0, 10.0, 14.0, 20.0, 28.0, 48.0, 160.0];

    fn is_free(star: Star, (x, y): (f64, f64), reach: f64) -> bool {
        (star.at.0 - x).hypot(star.at.1 - y) >= star.radius + reach
    }

    #[test]
    fn the_star_of_a_cell_is_beside_one_robot_or_two() {
        for cell in [(0, 0), (3, 0), (0, 3), (3, 3)].map(Cell::from) {
            for cell_px in SIZES {
                let star = ConflictPlace::Cell(cell).star(cell_px);
                let (x, y) = middle(cell);
                assert!(is_free(star, (x, y), 39.0), "{cell} {cell_px}");
                // Two of them stand side by side, and are smaller.
                assert!(is_free(star, (x - 22.0, y), 24.0), "{cell} {cell_px}");
                assert!(is_free(star, (x + 22.0, y), 24.0), "{cell} {cell_px}");
                assert!(star.radius * cell_px / CELL >= LEAST_PX);
                assert!(star.at.0 > 0.0 && star.at.1 > 0.0, "on the map");
            }
        }
    }

    #[test]
    fn a_label_stands_beside_a_star_that_would_cover_it() {
        let star = Star {
            at: (216.0, 116.0),
            radius: 24.0,
        };
        let half = (50.0, 14.0);
        assert_eq!(star.aside((250.0, 109.0), half, 600.0), Some(290.0));
        assert_eq!(star.aside((250.0, 109.0), half, 300.0), Some(142.0));
        assert_eq!(star.aside((250.0, 200.0), half, 600.0), None);
        let moved = star.aside((250.0, 109.0), half, 600.0).unwrap();
        assert_eq!(star.aside((moved, 109.0), half, 600.0), None);
    }

    #[test]
    fn the_star_of_a_swap_is_beside_both_robots_on_all_of_their_way() {
        let edges = [
            [(1, 0), (0, 0)],
            [(0, 0), (0, 1)],
            [(3, 3), (4, 3)],
            [(3, 4), (3, 3)],
        ];
        for edge in edges.map(|edge| edge.map(Cell::from)) {
            for cell_px in SIZES {
                let place = ConflictPlace::Edge(edge);
                let star = place.star(cell_px);
                for at in [middle(edge[0]), middle(edge[1]), place.middle()] {
                    assert!(is_free(star, at, 39.0), "{edge:?} {cell_px}");
                }
            }
        }
    }
}
