//! What the board shows: pure functions from the state to shapes, names and
//! motion. Lengths are in units, 100 a cell; `y` goes down.

mod beside;
mod camera;
mod cast;
mod floor;
mod heat;
mod hit;
mod legend;
mod minimap;
mod names;
mod nose;
mod place;
mod reasons;
mod rules;
mod shade;
mod star;
#[cfg(test)]
mod tests;
mod tip;
mod waypoints;
mod zones;

pub use beside::{Side, sides};
pub use camera::{AxisPlace, Camera, Frame, MAX_CELL_PX, PRESENTED_CELL_PX};
pub use cast::{Cast, badges};
pub use floor::{Band, Floor, TILE};
use giveway_picture::whole;
pub use giveway_picture::{
    Badge, CELL, Charge, Detail, FloorLook, Layer, Mark, MarkKind, Occupied, Pose, Track, TurnSide,
    Way, WayEnds, lines, marks, marks_with, of_badge,
};
pub use giveway_picture::{TabWords, tab_parts};
pub use heat::{SHADES, heat};
pub use legend::{Kind, legend};
pub use minimap::{Minimap, dots};
pub use names::{CellNames, Window};
pub use nose::{Nose, degrees, nose, quarter};
pub(crate) use place::place_of;
pub use reasons::{
    Instead, Later, Place, Reasons, Spot, SpotSign, Try, lit, reasons, reasons_beside,
};
pub use rules::{
    KeptShape, LaneShape, RuleShapes, RulesNow, SignKind, TagShape, ZoneShape, kept_free,
    rule_shapes, rules_at, rules_now,
};
pub(crate) use shade::shade;
pub(crate) use star::middle;
pub use star::{ConflictPlace, Star};
pub use tip::{Tip, TipLine, tip, tip_corner};
pub use waypoints::waypoint_numbers;
pub use zones::zone_at;
