//! Points of the map, and where an agent is between two steps.

use giveway_model::Cell;

/// A point of the map: the middle of the cell `[x, y]` is at `(x, y)`, `y` down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// To the right, in cells.
    pub x: f64,
    /// Down, in cells.
    pub y: f64,
}

impl Point {
    /// The cell whose middle is nearest; one in the first row or column for a
    /// point beyond it.
    ///
    /// ```
    /// use giveway_model::Cell;
    /// use giveway_picture::Point;
    /// assert_eq!(Point { x: 2.4, y: -3.0 }.nearest_cell(), Cell::new(2, 0));
    /// ```
    #[expect(
        clippy::cast_sign_loss,
        reason = "a conversion of floats saturates, and below 0 becomes 0 as said"
    )]
    pub const fn nearest_cell(self) -> Cell {
        Cell::new(self.x.round() as u32, self.y.round() as u32)
    }
}

/// Where an agent is at a time that need not be whole, by its path from time 0.
///
/// It goes evenly from cell to cell; a slow move takes two steps, so that at the
/// time between, in transit, the agent is half way. Before its first entry it is
/// at the first cell, after its arrival at the last. `None` for a path without
/// cells.
///
/// ```
/// use giveway_model::Cell;
/// use giveway_picture::{Point, position};
/// let slow_move = [Some(Cell::new(2, 0)), None, Some(Cell::new(3, 0))];
/// assert_eq!(position(&slow_move, 1.0), Some(Point { x: 2.5, y: 0.0 }));
/// ```
pub fn position(path: &[Option<Cell>], time: f64) -> Option<Point> {
    let entries = path.iter().enumerate();
    let mut stops = entries.filter_map(|(time, cell)| cell.map(|cell| (time as f64, cell)));
    let mut before = stops.next()?;
    for after in stops {
        if time < after.0 {
            return Some(between(before, after, time));
        }
        before = after;
    }
    Some(middle(before.1))
}

fn between((begin, from): (f64, Cell), (end, to): (f64, Cell), time: f64) -> Point {
    let share = ((time - begin) / (end - begin)).clamp(0.0, 1.0);
    let (from, to) = (middle(from), middle(to));
    Point {
        x: from.x + (to.x - from.x) * share,
        y: from.y + (to.y - from.y) * share,
    }
}

fn middle(cell: Cell) -> Point {
    Point {
        // A plan of elsewhere may lead left of the map, or above it.
        x: f64::from(cell.x.cast_signed()),
        y: f64::from(cell.y.cast_signed()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A path in one row, `-` in transit.
    fn path(row: &str) -> Vec<Option<Cell>> {
        let cell = |c: char| c.to_digit(10).map(|x| Cell::new(x, 0));
        row.chars().map(cell).collect()
    }

    #[track_caller]
    fn check(row: &str, time: f64, expect: f64) {
        let point = Point { x: expect, y: 0.0 };
        assert_eq!(position(&path(row), time), Some(point), "{row} at {time}");
    }

    #[test]
    fn a_move_takes_one_step() {
        check("0122", 1.0, 1.0);
        check("0122", 1.25, 1.25);
        check("10", 0.25, 0.75);
    }

    #[test]
    fn a_slow_move_takes_two() {
        check("01-2", 1.5, 1.25);
        check("01-2", 2.0, 1.5);
        check("01-2", 2.5, 1.75);
    }

    #[test]
    fn a_wait_stands_still() {
        check("0112", 1.5, 1.0);
    }

    #[test]
    fn beyond_both_ends() {
        check("34", -1.0, 3.0);
        check("34", 9.0, 4.0);
        check("3", 0.5, 3.0);
    }

    #[test]
    fn a_path_that_breaks_off_in_transit_stays_where_it_was_last() {
        check("3-", 1.5, 3.0);
        assert_eq!(position(&[], 0.0), None);
        assert_eq!(position(&[None], 0.0), None);
    }

    #[test]
    fn down_the_map() {
        let path = [Some(Cell::new(2, 1)), Some(Cell::new(2, 2))];
        assert_eq!(position(&path, 0.5), Some(Point { x: 2.0, y: 1.5 }));
    }
}
