//! What lies on the floor, as few shapes.

use std::fmt::Write;

use giveway_model::{Cell, Grid, Ground};

use super::Detail;
use super::outline::{Pen, Region};

/// The `d` of the paths of the floor.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Floor {
    /// The cells of the slow zone, for its tint.
    pub slow_tint: Vec<String>,
    /// Each connected part of the slow zone, for hatch and outline.
    pub slow: Vec<String>,
    /// The lines between cells.
    pub lines: String,
    /// Each shelf of obstacles.
    pub obstacles: Vec<String>,
    /// The plates of chargers.
    pub chargers: String,
    /// The bolts on them.
    pub bolts: String,
}

/// The shapes of a map at a level of detail: from forms down they are plain. The
/// bolt of a charger makes way where a star lies on it.
pub fn floor(grid: &Grid, detail: Detail, has_star: impl Fn(Cell) -> bool) -> Floor {
    let is_fine = detail > Detail::Dots;
    let pen = |inset: i32, radius: i32| {
        if is_fine {
            Pen { inset, radius }
        } else {
            Pen {
                inset: 0,
                radius: 0,
            }
        }
    };
    let region = |is_part: fn(Ground) -> bool, pen: Pen| {
        let contains = |cell| grid.ground(cell).is_some_and(is_part);
        let region = Region {
            width: grid.width(),
            height: grid.height(),
            contains: &contains,
        };
        region.paths(pen)
    };
    let is_obstacle = |ground| ground == Ground::Obstacle;
    let (chargers, bolts) = chargers(grid, is_fine, has_star);
    Floor {
        slow_tint: region(
            Ground::is_slow,
            Pen {
                inset: 0,
                radius: 0,
            },
        ),
        slow: region(Ground::is_slow, pen(4, 14)),
        lines: if is_fine { lines(grid) } else { String::new() },
        obstacles: region(is_obstacle, pen(6, 16)),
        chargers,
        bolts,
    }
}

fn lines(grid: &Grid) -> String {
    let (right, bottom) = (100 * grid.width(), 100 * grid.height());
    let mut path = String::new();
    // Writing to a string cannot fail.
    for x in 1..grid.width() {
        let _ = write!(path, "M{} 0V{bottom}", 100 * x);
    }
    for y in 1..grid.height() {
        let _ = write!(path, "M0 {}H{right}", 100 * y);
    }
    path
}

fn chargers(grid: &Grid, is_fine: bool, has_star: impl Fn(Cell) -> bool) -> (String, String) {
    let (mut plates, mut bolts) = (String::new(), String::new());
    for (cell, ground) in grid.cells() {
        if !ground.is_charger() {
            continue;
        }
        let (x, y) = (100 * cell.x, 100 * cell.y);
        if is_fine {
            let _ = write!(
                plates,
                "M{} {}h54a16 16 0 0 1 16 16v54a16 16 0 0 1-16 16h-54a16 16 0 0 1-16-16v-54a16 16 0 0 1 16-16Z",
                x + 23,
                y + 7,
            );
            let _ = if has_star(cell) {
                // Smaller, in the upper left corner.
                write!(bolts, "M{} {}l-10 15h7l-2 11 11-16h-7Z", x + 22, y + 12)
            } else {
                write!(bolts, "M{} {}l-25 35h17l-5 26 27-38h-17Z", x + 55, y + 20)
            };
        } else {
            let _ = write!(plates, "M{x} {y}h100v100h-100Z");
        }
    }
    (plates, bolts)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(rows: &[&str], detail: Detail) -> Floor {
        floor(&Grid::from_rows(rows).unwrap(), detail, |_| false)
    }

    #[test]
    fn a_charger_in_the_slow_zone_is_part_of_both() {
        let floor = of(&["~*~"], Detail::All);
        assert_eq!(floor.slow_tint, ["M0 0H300V100H0V0Z"]);
        assert_eq!(floor.slow.len(), 1);
        assert!(floor.chargers.starts_with("M123 7h54"));
        assert!(floor.bolts.starts_with("M155 20"));
        assert!(floor.obstacles.is_empty());
    }

    #[test]
    fn a_bolt_makes_way_for_a_star() {
        let grid = Grid::from_rows(&["++"]).unwrap();
        let floor = floor(&grid, Detail::All, |cell| cell.x == 1);
        let bolts: Vec<&str> = floor.bolts.split_inclusive('Z').collect();
        assert!(bolts[0].starts_with("M55 20l-25 35"), "{}", bolts[0]);
        assert!(bolts[1].starts_with("M122 12l-10 15"), "{}", bolts[1]);
    }

    #[test]
    fn lines_part_cells() {
        assert_eq!(of(&["..", ".."], Detail::All).lines, "M100 0V200M0 100H200");
        assert_eq!(of(&["."], Detail::All).lines, "");
    }

    #[test]
    fn small_cells_are_plain() {
        let floor = of(&["#+."], Detail::Dots);
        assert_eq!(floor.obstacles, ["M0 0H100V100H0V0Z"]);
        assert_eq!(floor.chargers, "M100 0h100v100h-100Z");
        assert_eq!((floor.bolts, floor.lines), (String::new(), String::new()));
    }
}
