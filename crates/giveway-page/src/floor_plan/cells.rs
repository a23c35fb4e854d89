//! Which cells a floor plan makes: by how much of each is dark.

use std::collections::BTreeSet;

use giveway_model::{Cell, Grid, sorting};

use super::{FloorPlan, whole};
use crate::{Draft, MAX_SIDE, edit::Paint};

/// So near to the threshold a cell is told, in per cent.
const CLOSE: f64 = 20.0;
/// How many bars show how dark the cells are.
pub(super) const BARS: usize = 20;

/// What becomes of the map.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Made {
    /// Cells that become what they are not yet.
    pub(super) cells: Vec<Cell>,
    /// Cells near the threshold, which nobody turned over.
    pub(super) close: Vec<Cell>,
    /// Cells that would become obstacles if no robot needed them.
    pub(super) needed: usize,
    /// How many cells are so dark, from light to dark.
    pub(super) bars: [u32; BARS],
}

impl FloorPlan {
    /// How much of a cell is dark, in per cent.
    fn darkness(&self, cell: Cell) -> f64 {
        let (width, height) = self.pixels();
        let scale = width / self.wide;
        let span = |at: u32, from: f64| {
            let at = f64::from(at) - from;
            (at * scale, (at + 1.0) * scale)
        };
        let (across, down) = (span(cell.x, self.corner.0), span(cell.y, self.corner.1));
        let back = |(from, to): (f64, f64), whole: f64| (whole - to, whole - from);
        let (across, down) = match self.turns {
            1 => (down, back(across, width)),
            2 => (back(across, width), back(down, height)),
            3 => (back(down, height), across),
            _ => (across, down),
        };
        100.0 * self.picture.darkness(across, down)
    }

    /// What becomes of a map.
    pub(super) fn made(&self, draft: &Draft) -> Made {
        let mut made = Made::default();
        let needed = needed(draft);
        let grid = draft.grid();
        for y in 0..grid.height() {
            for x in 0..grid.width() {
                let cell = Cell::new(x, y);
                let dark = self.darkness(cell);
                if let Some(bar) = made.bars.get_mut(whole(dark / 5.0).min(BARS - 1)) {
                    *bar += 1;
                }
                let line = f64::from(self.threshold);
                let turned = self.turned.get(&cell).copied();
                if turned.is_none() && dark >= 1.0 && (dark - line).abs() <= CLOSE {
                    made.close.push(cell);
                }
                if !turned.unwrap_or(dark >= line) || self.is_so(grid, cell) {
                    continue;
                }
                if self.becomes == Paint::Obstacle && needed.contains(&cell) {
                    made.needed += 1;
                } else {
                    made.cells.push(cell);
                }
            }
        }
        made
    }

    /// Whether a cell is already what it would become, or cannot become that.
    fn is_so(&self, grid: &Grid, cell: Cell) -> bool {
        let ground = grid.ground(cell);
        ground.is_none_or(|ground| self.becomes.is_on(ground) || !ground.is_vertex())
    }

    /// The edit that draws the cells; `None` where there are none.
    pub(crate) fn edit(&self, draft: &Draft) -> Option<crate::Edit> {
        let cells = self.made(draft).cells;
        (!cells.is_empty()).then_some(crate::Edit::PaintCells(self.becomes, cells))
    }

    /// A person turns a cell over.
    pub(crate) fn turn_over(mut self, cell: Cell) -> Self {
        let is_dark = self.darkness(cell) >= f64::from(self.threshold);
        let now = self.turned.get(&cell).copied().unwrap_or(is_dark);
        self.turned.insert(cell, !now);
        self
    }

    /// Columns and rows of the map once all of the picture is on it; `None` where it is.
    pub(crate) fn grown(&self, grid: &Grid) -> Option<(u32, u32)> {
        // What is a hundredth of a cell over is rounded away.
        let side =
            |own: u32, length: f64| own.max(whole((length - 0.01).ceil()) as u32).min(MAX_SIDE);
        let (width, height) = (grid.width(), grid.height());
        let larger = (
            side(width, self.corner.0 + self.wide),
            side(height, self.corner.1 + self.high()),
        );
        (larger != (width, height)).then_some(larger)
    }
}

/// Where a robot starts, goes or has a waypoint.
fn needed(draft: &Draft) -> BTreeSet<Cell> {
    let of = |agent: &giveway_model::Agent| {
        let own = [agent.start].into_iter().chain(agent.goal);
        own.chain(agent.waypoints.clone()).collect::<Vec<_>>()
    };
    sorting::set(draft.agents().iter().flat_map(of))
}
