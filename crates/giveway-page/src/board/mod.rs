//! What the board shows: pure functions from the state to shapes, names and
//! motion. Lengths are in units, 100 a cell; `y` goes down.

mod camera;
mod cast;
mod detail;
mod floor;
mod heat;
mod hit;
mod legend;
mod marks;
mod minimap;
mod names;
mod occupied;
mod outline;
mod place;
mod reasons;
mod shade;
#[cfg(test)]
mod tests;
mod tile;
mod track;
mod way;

pub use camera::{Camera, Frame, MAX_CELL_PX};
pub use cast::Cast;
pub use detail::Detail;
pub use floor::{Band, Floor, FloorLook, Layer, TILE, lines};
pub use heat::{SHADES, heat};
pub use legend::{Kind, legend};
pub use marks::{Mark, MarkKind, marks};
pub use minimap::{Minimap, dots};
pub use names::{CellNames, Window};
pub use occupied::Occupied;
pub(crate) use place::place_of;
pub use reasons::{Later, Place, Reasons, Spot, Try, reasons};
pub(crate) use shade::shade;
pub use track::{Badge, Charge, Pose, Track};
pub use way::{Way, WayEnds};

/// The side of a cell, in units.
pub const CELL: f64 = 100.0;

/// A number of cells or steps, rounded down; 0 for what is below.
#[expect(
    clippy::cast_sign_loss,
    reason = "a conversion of floats saturates, and below 0 becomes 0 as said"
)]
const fn whole(number: f64) -> u32 {
    number as u32
}
