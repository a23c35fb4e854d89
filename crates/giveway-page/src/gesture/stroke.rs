//! A stroke on its way over the board, and what has come of it so far.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_model::words::Sentence;

use super::{Canvas, Shaped, Thing};
use crate::edit::{Edit, Paint, RuleEdit, Sketch};
use crate::line::line;

/// What a stroke does.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Hold {
    /// Paints, or takes away what was painted: settled where the stroke begins,
    /// so that one over mixed ground leaves it even.
    Brush(Paint, bool),
    /// Takes away what is on cells.
    Eraser,
    /// Draws a shape from the first cell to the last.
    Shape(Shaped),
    /// Moves a thing from the first cell to the last.
    Thing(Thing),
    /// Moves a waypoint of an agent; where it never left its cell, takes it away.
    Toggle(usize),
    /// One edit, wherever the stroke goes on to.
    Once(Edit),
    /// Adds cells to a zone (`true`), or takes them away.
    Zone(String, bool),
    /// The same of all cells between the first and the last one.
    Rect(String, bool),
    /// Leads a one-way lane along these cells.
    Lane(Vec<Cell>),
}

/// A stroke on its way over the board.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) hold: Hold,
    /// The cell that it began on.
    pub(crate) from: Cell,
    /// The cell that it came to last; `None` before the first cell is done.
    at: Option<Cell>,
    /// Whether it ever left its first cell.
    has_left: bool,
    /// What it is made on, and what has come of it so far.
    pub(crate) canvas: Canvas,
    /// Why a part of it was refused.
    pub(crate) refused: Option<Sentence>,
}

impl Stroke {
    pub(crate) fn new(hold: Hold, cell: Cell, canvas: Canvas) -> Self {
        Self {
            hold,
            from: cell,
            at: None,
            has_left: false,
            canvas,
            refused: None,
        }
    }

    /// Whether nothing has come of it so far.
    pub(crate) fn changes_nothing(&self) -> bool {
        match &self.canvas {
            Canvas::Scene { before, shown, .. } => before.scene() == shown.scene(),
            Canvas::World { before, after } => before.list == after.list,
        }
    }

    /// The cell that it came to last.
    pub(crate) fn at(&self) -> Cell {
        self.at.unwrap_or(self.from)
    }

    /// Goes on to a cell.
    pub(crate) fn go(&mut self, to: Cell) {
        let way = line(self.at(), to);
        // The cell that it comes from is done, but for the first one.
        let way = way.get(usize::from(self.at.is_some())..);
        self.at = Some(to);
        self.has_left |= to != self.from;
        let way = way.unwrap_or_default();
        match &mut self.hold {
            Hold::Brush(..) | Hold::Eraser | Hold::Zone(..) => self.paint(way),
            Hold::Shape(shaped) if shaped.is_free() => self.paint(way),
            Hold::Shape(_) => self.draw(),
            Hold::Lane(lane) => {
                if let Canvas::Scene { sketch, .. } = &self.canvas {
                    lead(lane, way, |cell| sketch.is_blocked(cell));
                }
                self.move_thing();
            }
            Hold::Thing(_) | Hold::Toggle(_) | Hold::Once(_) | Hold::Rect(..) => {
                self.move_thing();
            }
        }
    }

    /// What it does to a cell that it comes over.
    fn brushed(&self, cell: Cell) -> Option<Edit> {
        match &self.hold {
            Hold::Brush(paint, on) => Some(Edit::Paint(*paint, cell, *on)),
            Hold::Eraser => Some(Edit::Erase(cell)),
            Hold::Shape(shaped) => Some(shaped.edit(cell)),
            Hold::Zone(name, on) => Some(Edit::Rules(RuleEdit::PaintZone(name.clone(), cell, *on))),
            Hold::Thing(_) | Hold::Toggle(_) | Hold::Once(_) | Hold::Rect(..) | Hold::Lane(_) => {
                None
            }
        }
    }

    fn paint(&mut self, cells: &[Cell]) {
        let edits: Vec<Edit> = cells
            .iter()
            .filter_map(|&cell| self.brushed(cell))
            .collect();
        let mut refused = None;
        match &mut self.canvas {
            Canvas::Scene { sketch, shown, .. } => {
                let sketch = Rc::make_mut(sketch);
                for edit in &edits {
                    refused = refused.or(sketch.make(edit).err());
                }
                *shown = Rc::new(sketch.shown());
            }
            Canvas::World { after, .. } => {
                let (next, told) = after.with_edits(&edits);
                *after = Rc::new(next);
                refused = told;
            }
        }
        self.refused = self.refused.take().or(refused);
    }

    /// What it does as a whole, where it moves a thing.
    fn moved(&self) -> Option<Edit> {
        let (from, to) = (self.from, self.at());
        Some(match &self.hold {
            Hold::Brush(..) | Hold::Eraser | Hold::Shape(_) | Hold::Zone(..) => return None,
            Hold::Rect(name, on) => Edit::Rules(RuleEdit::PaintRect(name.clone(), from, to, *on)),
            Hold::Lane(lane) => Edit::Rules(RuleEdit::Lane(lane.clone())),
            Hold::Once(edit) => edit.clone(),
            Hold::Thing(Thing::Start(agent)) => Edit::SetStart(*agent, to),
            Hold::Thing(Thing::Goal(agent)) => Edit::SetGoal(*agent, to),
            Hold::Thing(Thing::NewWaypoint(agent)) => Edit::AddWaypoint(*agent, to),
            Hold::Thing(Thing::Paint(paint)) => Edit::MovePaint(*paint, from, to),
            Hold::Thing(Thing::Waypoint(agent)) | Hold::Toggle(agent) => {
                Edit::MoveWaypoint(*agent, from, to)
            }
        })
    }

    /// Moves it from where the stroke began, so that nothing is left on the way.
    fn move_thing(&mut self) {
        let edits: Vec<Edit> = self.moved().into_iter().collect();
        if !edits.is_empty() {
            self.make_afresh(&edits);
        }
    }

    /// Draws the shape from where the stroke began.
    fn draw(&mut self) {
        if let Hold::Shape(shaped) = &self.hold {
            let edits = shaped.edits(self.from, self.at(), self.canvas.grid_before());
            self.make_afresh(&edits);
        }
    }

    /// What a shape covers so far, in words.
    pub(crate) fn drawn(&self) -> Option<String> {
        match &self.hold {
            Hold::Shape(shaped) if !shaped.is_free() => {
                Some(shaped.words(self.from, self.at(), self.canvas.grid_before()))
            }
            Hold::Shape(_)
            | Hold::Brush(..)
            | Hold::Eraser
            | Hold::Thing(_)
            | Hold::Toggle(_)
            | Hold::Once(_)
            | Hold::Zone(..)
            | Hold::Rect(..)
            | Hold::Lane(_) => None,
        }
    }

    /// Makes edits of what there was before the stroke.
    fn make_afresh(&mut self, edits: &[Edit]) {
        match &mut self.canvas {
            Canvas::Scene {
                before,
                sketch,
                shown,
            } => {
                let mut fresh = Sketch::of(before);
                self.refused = None;
                for edit in edits {
                    self.refused = self.refused.take().or(fresh.make(edit).err());
                }
                *shown = Rc::new(fresh.shown());
                *sketch = Rc::new(fresh);
            }
            Canvas::World { before, after } => {
                let (next, told) = before.with_edits(edits);
                *after = Rc::new(next);
                self.refused = told;
            }
        }
    }

    /// Where it only pressed on a waypoint, or on one of several cells of a zone: the edit that
    /// takes it away.
    pub(crate) fn toggled(&self) -> Option<Edit> {
        if self.has_left {
            return None;
        }
        match &self.hold {
            Hold::Toggle(agent) => Some(Edit::DropWaypoint(*agent, self.from)),
            Hold::Zone(name, true) if self.pressed_on_zone(name) => {
                let away = RuleEdit::PaintZone(name.clone(), self.from, false);
                Some(Edit::Rules(away))
            }
            Hold::Brush(..)
            | Hold::Eraser
            | Hold::Shape(_)
            | Hold::Thing(_)
            | Hold::Once(_)
            | Hold::Zone(..)
            | Hold::Rect(..)
            | Hold::Lane(_) => None,
        }
    }

    /// Whether it began on one of several cells of a zone.
    fn pressed_on_zone(&self, name: &str) -> bool {
        let Canvas::Scene { before, .. } = &self.canvas else {
            return false;
        };
        let mut zones = before.scene().zones.iter();
        zones.any(|zone| zone.name == name && zone.has(self.from) && zone.cells().count() > 1)
    }
}

/// Leads a lane on along the cells on a way: back along itself it takes the lane back, and what
/// is blocked or no neighbour ends it there.
fn lead(lane: &mut Vec<Cell>, way: &[Cell], is_blocked: impl Fn(Cell) -> bool) {
    for &cell in way {
        if let Some(place) = lane.iter().position(|&other| other == cell) {
            lane.truncate(place + 1);
            continue;
        }
        let is_next = |last: &Cell| last.x.abs_diff(cell.x) + last.y.abs_diff(cell.y) == 1;
        if is_blocked(cell) || !lane.last().is_none_or(is_next) {
            continue;
        }
        lane.push(cell);
    }
}
