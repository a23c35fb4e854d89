//! How the tools that paint draw: freely, or a shape between the cell where the hand went down
//! and the one where it is now.

mod cells;
mod row;
#[cfg(test)]
mod tests;

use giveway_model::tr;

use crate::Tool;

pub(crate) use cells::{Drawn, drawn};
pub use row::{Field, Row, row};

/// What a stroke of a tool that paints covers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shape {
    /// The cells that the hand comes over.
    #[default]
    Pen,
    /// All cells between two corners.
    Rectangle,
    /// A straight line in one of eight directions.
    Line,
    /// The connected cells of the same ground.
    Fill,
    /// Long shelves side by side, along the longer side of the drag.
    Racks,
    /// Blocks of shelves in rows and columns.
    Blocks,
    /// A way that is cut through obstacles.
    Aisle,
    /// One robot, then its goal.
    One,
    /// A row of robots, then a row of their goals.
    Row,
}

impl Shape {
    /// The shapes of obstacles, in the order of their keys.
    pub const GROUND: [Self; 7] = [
        Self::Pen,
        Self::Rectangle,
        Self::Line,
        Self::Fill,
        Self::Racks,
        Self::Blocks,
        Self::Aisle,
    ];
    const PLAIN: [Self; 4] = [Self::Pen, Self::Rectangle, Self::Line, Self::Fill];
    const ZONE: [Self; 2] = [Self::Pen, Self::Rectangle];

    /// The shapes that a tool can draw; none where it does not paint.
    pub const fn of(tool: Tool) -> &'static [Self] {
        match tool {
            Tool::Obstacle => &Self::GROUND,
            Tool::Charger | Tool::SlowZone | Tool::Erase => &Self::PLAIN,
            Tool::Agent => &[Self::One, Self::Row],
            Tool::Zone => &Self::ZONE,
            Tool::Select | Tool::OneWay | Tool::Goal | Tool::Waypoint => &[],
        }
    }

    /// The accessible name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pen => tr!("a shape" => "Pen"),
            Self::Rectangle => tr!("a shape" => "Rectangle"),
            Self::Line => tr!("a shape" => "Line"),
            Self::Fill => tr!("a shape" => "Fill"),
            Self::Racks => tr!("a shape" => "Racks"),
            Self::Blocks => tr!("a shape" => "Blocks"),
            Self::Aisle => tr!("a shape" => "Aisle"),
            Self::One => tr!("robots to place" => "One"),
            Self::Row => tr!("robots to place" => "Several"),
        }
    }

    /// The key that picks it.
    pub const fn key(self) -> char {
        match self {
            Self::Pen | Self::One => '1',
            Self::Rectangle | Self::Row => '2',
            Self::Line => '3',
            Self::Fill => '4',
            Self::Racks => '5',
            Self::Blocks => '6',
            Self::Aisle => '7',
        }
    }

    /// The name of its icon.
    pub const fn icon(self) -> &'static str {
        match self {
            Self::Pen => "pen",
            Self::Rectangle => "rect",
            Self::Line => "line",
            Self::Fill => "fill",
            Self::Racks => "racks",
            Self::Blocks => "blocks",
            Self::Aisle => "aisle",
            Self::One => "agent",
            Self::Row => "many",
        }
    }
}

/// A size that is set before a shape is drawn, in cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// The depth of a rack.
    RackDepth,
    /// The width of the aisle between two racks.
    RackAisle,
    /// The width of a block.
    BlockWidth,
    /// The height of a block.
    BlockHeight,
    /// The cells between two blocks.
    BlockGap,
    /// From one charger to the next.
    Every,
    /// From one robot of a row to the next.
    RobotEvery,
}

/// The largest measure, in cells.
pub const LONGEST: u32 = 64;

/// The shape that is drawn, and its measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawing {
    shape: Shape,
    /// Whether robots come in rows.
    in_rows: bool,
    robot_every: u32,
    rack: (u32, u32),
    block: (u32, u32, u32),
    every: u32,
}

impl Default for Drawing {
    fn default() -> Self {
        Self {
            shape: Shape::Pen,
            in_rows: false,
            robot_every: 2,
            rack: (2, 1),
            block: (2, 2, 1),
            every: 1,
        }
    }
}

impl Drawing {
    /// The shape that a tool draws: the one picked last, or a rectangle where the tool does not
    /// know it.
    pub fn shape(&self, tool: Tool) -> Shape {
        if tool == Tool::Agent {
            return if self.in_rows { Shape::Row } else { Shape::One };
        }
        let shapes = Shape::of(tool);
        match shapes.contains(&self.shape) {
            true => self.shape,
            false if shapes.is_empty() => Shape::Pen,
            false => Shape::Rectangle,
        }
    }

    /// The same with another shape.
    pub(crate) const fn with_shape(self, shape: Shape) -> Self {
        match shape {
            Shape::One | Shape::Row => Self {
                in_rows: matches!(shape, Shape::Row),
                ..self
            },
            Shape::Pen
            | Shape::Rectangle
            | Shape::Line
            | Shape::Fill
            | Shape::Racks
            | Shape::Blocks
            | Shape::Aisle => Self { shape, ..self },
        }
    }

    /// A measure, in cells.
    pub const fn measure(&self, measure: Measure) -> u32 {
        match measure {
            Measure::RackDepth => self.rack.0,
            Measure::RackAisle => self.rack.1,
            Measure::BlockWidth => self.block.0,
            Measure::BlockHeight => self.block.1,
            Measure::BlockGap => self.block.2,
            Measure::Every => self.every,
            Measure::RobotEvery => self.robot_every,
        }
    }

    /// The same with another measure, of 1 to [`LONGEST`] cells.
    pub(crate) fn with_measure(mut self, measure: Measure, cells: u32) -> Self {
        let place = match measure {
            Measure::RackDepth => &mut self.rack.0,
            Measure::RackAisle => &mut self.rack.1,
            Measure::BlockWidth => &mut self.block.0,
            Measure::BlockHeight => &mut self.block.1,
            Measure::BlockGap => &mut self.block.2,
            Measure::Every => &mut self.every,
            Measure::RobotEvery => &mut self.robot_every,
        };
        *place = cells.clamp(1, LONGEST);
        self
    }
}
