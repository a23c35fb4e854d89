//! The row of options under the board, for the tool that is picked.

use giveway_model::tr;

use super::{Measure, Shape};
use crate::gesture::Stroke;
use crate::{State, Tool};

/// A number that is set before drawing, with the words around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// What is set.
    pub measure: Measure,
    /// Its accessible name, with its unit.
    pub name: &'static str,
    /// The words before it.
    pub before: &'static str,
    /// The words after it.
    pub after: &'static str,
}

/// The options of a tool that paints.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The shapes that it can draw.
    pub shapes: &'static [Shape],
    /// The one that it draws.
    pub shape: Shape,
    /// What can be set of it.
    pub fields: Vec<Field>,
    /// What it does, where that needs words.
    pub remark: Option<&'static str>,
    /// What has been drawn so far, while the hand is down.
    pub drawn: Option<String>,
}

/// The row of options; `None` where the tool has none, or shapes are not to be picked.
pub fn row(state: &State) -> Option<Row> {
    let tool = state.view.tool;
    let shapes = Shape::of(tool);
    if shapes.is_empty()
        || !state.can_pick_shapes()
        || (tool == Tool::Agent && !state.can_place_fleet())
    {
        return None;
    }
    let shape = state.shape();
    Some(Row {
        shapes,
        shape,
        fields: fields(tool, shape),
        remark: remark(state, shape),
        drawn: state.stroke().and_then(Stroke::drawn),
    })
}

/// What a shape does, where that needs words.
fn remark(state: &State, shape: Shape) -> Option<&'static str> {
    match shape {
        Shape::Aisle => Some(tr!("cuts through what is there")),
        Shape::One => Some(tr!("Press: its start. Then its goal.")),
        Shape::Row if state.view.fleet.is_none() => {
            Some(tr!("Drag: where they start. Then where they go."))
        }
        Shape::Pen if state.view.tool == Tool::Zone => {
            Some(tr!("Draw over the cells of the zone."))
        }
        Shape::Rectangle => Some(tr!("Drag from corner to corner.")),
        Shape::Line => Some(tr!("Drag from end to end.")),
        Shape::Row | Shape::Pen | Shape::Fill | Shape::Racks | Shape::Blocks => None,
    }
}

fn fields(tool: Tool, shape: Shape) -> Vec<Field> {
    let field = |measure, name, before, after| Field {
        measure,
        name,
        before,
        after,
    };
    match shape {
        Shape::Racks => vec![
            field(
                Measure::RackDepth,
                tr!("Depth of a rack, cells"),
                "",
                tr!("deep, aisles"),
            ),
            field(
                Measure::RackAisle,
                tr!("Width of an aisle, cells"),
                "",
                tr!("wide"),
            ),
        ],
        Shape::Blocks => vec![
            field(
                Measure::BlockWidth,
                tr!("Width of a block, cells"),
                "",
                "\u{d7}",
            ),
            field(
                Measure::BlockHeight,
                tr!("Height of a block, cells"),
                "",
                ",",
            ),
            field(
                Measure::BlockGap,
                tr!("Cells between blocks"),
                "",
                tr!("apart"),
            ),
        ],
        Shape::Rectangle | Shape::Line if tool == Tool::Charger => vec![field(
            Measure::Every,
            tr!("From one charger to the next, cells"),
            tr!("one every"),
            tr!("cells"),
        )],
        Shape::Row => vec![field(
            Measure::RobotEvery,
            tr!("From one robot to the next, cells"),
            tr!("one every"),
            tr!("cells"),
        )],
        Shape::Pen | Shape::Rectangle | Shape::Line | Shape::Fill | Shape::Aisle | Shape::One => {
            Vec::new()
        }
    }
}

impl State {
    /// Whether shapes can be picked: on one's own page, not in the step of a lesson.
    pub(crate) fn can_pick_shapes(&self) -> bool {
        let in_lesson = self.lesson.as_ref().is_some_and(|lesson| !lesson.is_tour());
        !in_lesson && !self.is_embedded() && !self.is_presented()
    }

    /// The shape that the tool draws.
    pub fn shape(&self) -> Shape {
        let places_one = self.view.tool == Tool::Agent && !self.can_place_fleet();
        if places_one {
            Shape::One
        } else if self.can_pick_shapes() {
            self.view.drawing.shape(self.view.tool)
        } else {
            Shape::Pen
        }
    }
}
