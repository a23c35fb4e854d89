//! The strips of the floor that come and go, before it has its new size.

use giveway_model::Grid;

use super::Side;
use crate::State;
use crate::edit::{Axis, Lines, Reshape, Sides};

/// Rows or columns that come or go. No two strips have a cell in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Strip {
    /// How many come or go, in words.
    pub told: String,
    /// How many come; below 0, how many go.
    pub more: i32,
    /// The corners `[x0, y0, x1, y1]` in cells of the floor as it is, the second one excluded.
    pub area: [i32; 4],
}

impl State {
    /// The strips of the floor that come and go.
    pub fn size_strips(&self) -> Vec<Strip> {
        let Some(growing) = self.growing() else {
            return Vec::new();
        };
        let grid = self.document.draft.grid();
        match growing.to {
            Reshape::Lines(lines) => vec![between(lines, grid)],
            Reshape::Sides(sides) => {
                let strip = |side: Side| {
                    let (more, area) = (side.of(sides), area(side, sides, grid));
                    let told = side.told(more);
                    (more != 0).then_some(Strip { told, more, area })
                };
                Side::ALL.into_iter().filter_map(strip).collect()
            }
        }
    }

    /// The floor with its new size: `[x0, y0, x1, y1]` as in [`Strip`]. `None` where its sides
    /// stay.
    pub fn size_outline(&self) -> Option<[i32; 4]> {
        match self.growing()?.to {
            Reshape::Sides(sides) => Some(outline(sides, self.document.draft.grid())),
            Reshape::Lines(_) => None,
        }
    }
}

/// Columns or rows that go; those that come have no cells of the floor as it is.
fn between(lines: Lines, grid: &Grid) -> Strip {
    let [_, _, width, height] = outline(Sides::default(), grid);
    let first = i32::try_from(lines.at).unwrap_or(i32::MAX);
    let end = first.saturating_add(lines.more.min(0).saturating_neg());
    let (area, side) = match lines.axis {
        Axis::Columns => ([first, 0, end.min(width), height], Side::Right),
        Axis::Rows => ([0, first, width, end.min(height)], Side::Bottom),
    };
    Strip {
        told: side.told(lines.more),
        more: lines.more,
        area,
    }
}

fn outline(sides: Sides, grid: &Grid) -> [i32; 4] {
    let number = |n: u32| i32::try_from(n).unwrap_or(i32::MAX);
    let (width, height) = (number(grid.width()), number(grid.height()));
    [
        -sides.left,
        -sides.top,
        width.saturating_add(sides.right),
        height.saturating_add(sides.bottom),
    ]
}

/// Rows reach over all columns, of the floor with them; columns over the rows that stay.
fn area(side: Side, sides: Sides, grid: &Grid) -> [i32; 4] {
    let [_, _, width, height] = outline(Sides::default(), grid);
    let [x0, y0, x1, y1] = outline(sides, grid);
    let (above, below) = (y0.max(0), y1.min(height));
    let rows = |more: i32| if more > 0 { (x0, x1) } else { (0, width) };
    match side {
        Side::Left => [x0.min(0), above, x0.max(0), below],
        Side::Right => [x1.min(width), above, x1.max(width), below],
        Side::Top => {
            let (first, end) = rows(sides.top);
            [first, y0.min(0), end, y0.max(0)]
        }
        Side::Bottom => {
            let (first, end) = rows(sides.bottom);
            [first, y1.min(height), end, y1.max(height)]
        }
    }
}
