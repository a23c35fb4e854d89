//! A picture of a floor under the grid: placed, given a scale, and turned into cells by a
//! threshold that one sees. It is in no file and no link; the browser may keep it for its tab.

mod brought;
mod card;
mod cells;
mod kept;
mod picture;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cell, Measure, Scene, Units};

use crate::State;
use crate::edit::Paint;

pub use brought::{Brought, brought};
pub use card::{Card, Laid, Row, card, laid, row};
pub use kept::kept;
pub(crate) use kept::read;
pub use picture::Picture;

/// One of the two points whose distance is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The first.
    First,
    /// The second.
    Second,
}

/// What a person says of a floor plan. Lengths on the board are in cells.
#[derive(Clone, Debug, PartialEq)]
pub enum FloorPlanAction {
    /// A picture comes under the grid; metres a pixel, where its file tells them.
    Lay(Rc<Picture>, Option<f64>),
    /// One that the browser kept for this tab is there again, as the text says.
    Restore(Rc<Picture>, String),
    /// It moves so far right and down.
    Move(f64, f64),
    /// Its left edge is there.
    Left(f64),
    /// Its upper edge is there.
    Top(f64),
    /// It is so wide.
    Wide(f64),
    /// It turns by a right angle, clockwise.
    Turn,
    /// A point of the two moves so far right and down.
    Point(End, f64, f64),
    /// The two points are so many metres apart; `None` takes that back.
    Apart(Option<f64>),
    /// A cell is so many metres wide.
    CellSize(f64),
    /// So much of a cell is dark at least, in per cent.
    Threshold(u32),
    /// What cells become: an obstacle or a part of the slow zone.
    Becomes(Paint),
    /// The map grows until the picture is on it.
    Grow,
    /// The cells are drawn.
    Draw,
    /// The column is left; a picture that nothing was drawn of goes.
    Cancel,
    /// The column is opened again.
    Open,
    /// The picture is hidden, or seen again.
    Show(bool),
    /// The picture goes.
    Remove,
}

/// A picture under the grid.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FloorPlan {
    picture: Rc<Picture>,
    /// Right angles that it is turned by, clockwise.
    turns: u8,
    /// Its upper left corner, in cells from that of the map.
    corner: (f64, f64),
    /// Its width on the board, in cells.
    wide: f64,
    /// The two points, from its upper left corner, as parts of its width.
    points: [(f64, f64); 2],
    /// Metres between them, where a person said that.
    apart: Option<f64>,
    /// Metres a pixel, where known.
    metres: Option<f64>,
    /// Metres a cell.
    cell: f64,
    /// How much of a cell is dark at least, in per cent.
    threshold: u32,
    becomes: Paint,
    /// Cells that a person turned over, and what they are.
    turned: BTreeMap<Cell, bool>,
    /// Whether the column is about it.
    pub(crate) is_open: bool,
    is_drawn: bool,
    is_shown: bool,
}

/// The narrowest and the widest that a picture is, in cells.
const WIDE: (f64, f64) = (1.0, 2000.0);
/// The shortest and the longest length that is typed, in metres.
const METRES: (f64, f64) = (0.01, 10_000.0);

impl FloorPlan {
    /// A picture as wide as the map, or as its scale says.
    pub(crate) fn laid(picture: Rc<Picture>, metres: Option<f64>, state: &State) -> Self {
        let units = state.document.draft.scene().units;
        let plan = Self {
            picture,
            turns: 0,
            corner: (0.0, 0.0),
            wide: state.document.draft.grid().width().into(),
            points: [(0.1, 0.1), (0.9, 0.1)],
            apart: None,
            metres,
            cell: units.map_or(1.0, |units| f64::from(units.cell.thousandths()) / 1000.0),
            threshold: 50,
            becomes: Paint::Obstacle,
            turned: BTreeMap::new(),
            is_open: true,
            is_drawn: false,
            is_shown: true,
        };
        plan.scaled()
    }

    /// The units that a scene gets with its cells: where its scale is known and the scene has
    /// none. A step is then a second.
    pub(crate) fn units(&self, scene: &Scene) -> Option<Units> {
        if self.metres.is_none() || scene.units.is_some() {
            return None;
        }
        Some(Units {
            cell: Measure::from_thousandths(whole(self.cell * 1000.0 + 0.5).try_into().ok()?)?,
            step: Measure::from_thousandths(1000)?,
        })
    }

    /// Width and height in pixels, as it is turned.
    fn pixels(&self) -> (f64, f64) {
        let (width, height) = (self.picture.width.into(), self.picture.height.into());
        if self.turns.is_multiple_of(2) {
            (width, height)
        } else {
            (height, width)
        }
    }

    /// Its height on the board, in cells.
    fn high(&self) -> f64 {
        let (width, height) = self.pixels();
        self.wide * height / width.max(1.0)
    }

    /// As wide as its scale says, where it is known.
    fn scaled(mut self) -> Self {
        if let Some(metres) = self.metres {
            self.wide = (self.pixels().0 * metres / self.cell).clamp(WIDE.0, WIDE.1);
        }
        self
    }

    /// With the scale that the two points give, where their distance is known.
    fn measured(mut self) -> Self {
        let [a, b] = self.points;
        let pixels = (a.0 - b.0).hypot(a.1 - b.1) * self.pixels().0;
        if let Some(apart) = self.apart.filter(|_| pixels >= 1.0) {
            self.metres = Some(apart / pixels);
        }
        self.scaled()
    }

    /// The same, said in another way. Cells that were turned over stay so as long as the
    /// picture lies as it does.
    pub(crate) fn with(mut self, action: &FloorPlanAction) -> Self {
        let lay = (self.corner, self.wide, self.turns);
        let mut next = match *action {
            FloorPlanAction::Move(right, down) => {
                self.corner = (self.corner.0 + right, self.corner.1 + down);
                self
            }
            FloorPlanAction::Left(left) => {
                self.corner.0 = left;
                self
            }
            FloorPlanAction::Top(top) => {
                self.corner.1 = top;
                self
            }
            FloorPlanAction::Wide(wide) => {
                self.wide = wide.clamp(WIDE.0, WIDE.1);
                (self.apart, self.metres) = (None, None);
                self
            }
            FloorPlanAction::Turn => {
                self.wide = self.high().clamp(WIDE.0, WIDE.1);
                self.turns = (self.turns + 1) % 4;
                // The points go along with what they lie on.
                let ratio = {
                    let (w, h) = self.pixels();
                    w / h.max(1.0)
                };
                for point in &mut self.points {
                    *point = (1.0 - point.1 / ratio, point.0 / ratio);
                }
                self
            }
            FloorPlanAction::Point(end, right, down) => {
                let point = &mut self.points[usize::from(end == End::Second)];
                *point = (point.0 + right / self.wide, point.1 + down / self.wide);
                self.measured()
            }
            FloorPlanAction::Apart(apart) => {
                self.apart = apart.map(|apart| apart.clamp(METRES.0, METRES.1));
                self.measured()
            }
            FloorPlanAction::CellSize(cell) => {
                self.cell = cell.clamp(METRES.0, METRES.1);
                self.scaled()
            }
            FloorPlanAction::Threshold(least) => {
                self.threshold = least.clamp(1, 100);
                self
            }
            FloorPlanAction::Becomes(paint) => {
                self.becomes = paint;
                self
            }
            FloorPlanAction::Show(is_shown) => {
                self.is_shown = is_shown;
                self
            }
            FloorPlanAction::Open => {
                (self.is_open, self.is_shown) = (true, true);
                self
            }
            FloorPlanAction::Lay(..)
            | FloorPlanAction::Restore(..)
            | FloorPlanAction::Grow
            | FloorPlanAction::Draw
            | FloorPlanAction::Cancel
            | FloorPlanAction::Remove => self,
        };
        let limit = |at: f64| at.clamp(-WIDE.1, WIDE.1);
        next.corner = (limit(next.corner.0), limit(next.corner.1));
        if lay != (next.corner, next.wide, next.turns) {
            next.turned.clear();
        }
        next
    }

    /// The column is left: a picture that nothing was drawn of goes where it is not wanted.
    pub(crate) fn left(mut self, keeps: bool) -> Option<Self> {
        self.is_open = false;
        (keeps || self.is_drawn).then_some(self)
    }

    /// The cells are on the map.
    pub(crate) fn drawn(mut self) -> Self {
        (self.is_open, self.is_drawn) = (false, true);
        self
    }
}

/// The whole part of a number; 0 where that is negative.
fn whole(number: f64) -> usize {
    (number.max(0.0) as i64).unsigned_abs() as usize
}

impl State {
    /// The floor plan that the column is about.
    pub(crate) fn open_plan(&self) -> Option<&FloorPlan> {
        let plan = self.view.floor_plan.as_deref();
        plan.filter(|plan| plan.is_open && self.can_place_fleet())
    }
}
