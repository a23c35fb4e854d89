//! The whole map, small: where everybody is, and which part of it is in sight.

use std::fmt::Write;

use giveway_model::tr;

use super::{CELL, Cast, Frame, whole};
use crate::Point;

/// The longest side of a map that a phone shows without it.
const LARGE: u32 = 64;

/// The part of a map that is in sight, where that is not all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minimap {
    /// The left edge of what is in sight, in units of the map.
    pub x: f64,
    /// The upper edge, in units.
    pub y: f64,
    /// The width, in units.
    pub width: f64,
    /// The height, in units.
    pub height: f64,
    columns: (u32, u32),
    rows: (u32, u32),
    board: (u32, u32),
}

impl Minimap {
    /// What is in sight of a map of some cells; `None` where all of it is.
    pub fn of(frame: &Frame, board: (u32, u32)) -> Option<Self> {
        let part = |from: f64, length: f64, side: u32| {
            let side = f64::from(side) * CELL;
            let (begin, end) = (from.clamp(0.0, side), (from + length).clamp(0.0, side));
            (begin, end - begin, end - begin >= side)
        };
        let (x, width, all_columns) = part(frame.x, frame.width, board.0);
        let (y, height, all_rows) = part(frame.y, frame.height, board.1);
        let (columns, rows) = frame.cells(board);
        (!all_columns || !all_rows).then_some(Self {
            x,
            y,
            width,
            height,
            columns,
            rows,
            board,
        })
    }

    /// Whether the map is so large that a phone, too, has room for it.
    pub fn is_large(&self) -> bool {
        self.board.0.max(self.board.1) > LARGE
    }

    /// What it tells those who do not see it.
    ///
    /// ```
    /// use giveway_page::board::{Frame, Minimap};
    /// let frame = Frame { x: 200.0, y: 0.0, width: 350.0, height: 800.0, cell_px: 20.0 };
    /// let map = Minimap::of(&frame, (80, 8)).unwrap();
    /// assert_eq!(map.name(), "Overview: columns 2 to 5 and rows 0 to 7 of 80 x 8 cells are in sight");
    /// ```
    pub fn name(&self) -> String {
        let ((left, right), (top, bottom)) = (self.columns, self.rows);
        let (width, height) = self.board;
        tr!(
            "Overview: columns {left} to {right} and rows {top} to {bottom} of {width} x {height} cells are in sight",
            left,
            right,
            top,
            bottom,
            width,
            height
        )
    }

    /// The point of the map, in cells, at a place in the overview: shares of its
    /// width and height.
    pub fn point(&self, across: f64, down: f64) -> Point {
        Point {
            x: across * f64::from(self.board.0) - 0.5,
            y: down * f64::from(self.board.1) - 0.5,
        }
    }
}

/// A dot for each of some agents at a time, as the `d` of one path: so many shapes
/// would be too many to move.
pub fn dots(cast: &Cast, time: u32, is_one: &dyn Fn(usize) -> bool) -> String {
    let mut path = String::new();
    for agent in (0..cast.agents.len()).filter(|&agent| is_one(agent)) {
        let pose = cast.pose(agent, f64::from(time));
        if let Some(pose) = pose.filter(|pose| !pose.is_gone) {
            // In a slow move it is between two cells. Writing to a text never fails.
            let units = |cells: f64| whole((cells + 0.5) * CELL);
            let _ = write!(path, "M{} {}h1", units(pose.at.x), units(pose.at.y));
        }
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::board::Camera;
    use crate::{Draft, State};
    use giveway_model::format::native;

    const SCREEN: (f64, f64) = (400.0, 400.0);

    #[test]
    fn it_is_there_where_some_of_the_map_is_out_of_sight() {
        let board = (100, 50);
        let camera = Camera::default();
        assert_eq!(Minimap::of(&camera.frame(board, SCREEN), board), None);
        let near = camera.zoom(2.0, (0.0, 200.0), board, SCREEN);
        let map = Minimap::of(&near.frame(board, SCREEN), board).unwrap();
        assert!(map.is_large());
        assert_eq!((map.x, map.y, map.height), (0.0, 0.0, 5000.0));
        assert!(map.width > 4900.0 && map.width < 5100.0, "{map:?}");
        assert_eq!(map.point(0.5, 1.0), Point { x: 49.5, y: 49.5 });
        let small = (10, 10);
        let near = camera.zoom(2.0, (0.0, 0.0), small, SCREEN);
        assert!(
            !Minimap::of(&near.frame(small, SCREEN), small)
                .unwrap()
                .is_large()
        );
    }

    #[test]
    fn each_robot_is_a_dot() {
        let scene = native::read_scene(
            r#"{"giveway": 1, "map": ["..."], "agents": [
                {"name": "A", "start": [0, 0], "goal": [1, 0]},
                {"name": "B", "start": [2, 0], "goal": [2, 0]}]}"#,
        );
        let state = State::new(Draft::new(scene.unwrap()).unwrap());
        let cast = Cast::of(&state);
        assert_eq!(dots(&cast, 0, &|_| true), "M50 50h1M250 50h1");
        assert_eq!(dots(&cast, 0, &|agent| agent == 1), "M250 50h1");
    }
}
