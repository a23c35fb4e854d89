//! Plans as pictures: the shapes of the board, a plan at a time, a plan that moves.
//!
//! Nothing here knows a browser. Lengths are in units, 100 a cell; `y` goes down.

#![cfg_attr(
    test,
    allow(
        clippy::float_cmp,
        reason = "what is drawn is compared with what is exact in binary"
    )
)]

mod colours;
mod corner;
mod detail;
mod draw;
mod floor;
pub mod form;
#[cfg(feature = "gif")]
pub mod gif;
mod glyphs;
mod ink;
mod letters;
mod look;
mod looks;
mod marks;
mod moving;
mod occupied;
mod outline;
mod point;
pub mod report;
mod rules;
mod still;
mod tile;
mod track;
mod way;
mod xml;

pub use colours::{COLOURS, Colours};
pub use corner::of_badge;
pub use detail::Detail;
pub use floor::{FloorLook, Layer, lines, starred};
pub use ink::{Ink, Inks, Theme, robot};
pub use look::{CELL_PX, Letters, Look};
pub use looks::Looks;
pub use marks::{Mark, MarkKind, marks, marks_with};
pub use moving::moving;
pub use occupied::Occupied;
pub use outline::{Area, Pen, Region};
pub use point::{Point, position};
pub use rules::{
    KeptShape, LaneShape, LitRule, RuleShapes, RuledMap, RulesNow, SignKind, Stay, TabParts,
    TabWords, TagShape, ZoneShape, first_stay, in_force, kept, rule_shapes, stays, tab_parts,
    zone_of,
};
pub use still::{on_paper, still};
pub use tile::Tile;
pub use track::{Badge, Charge, Pose, Track, TurnSide};
pub use way::{Way, WayEnds};

/// The side of a cell, in units.
pub const CELL: f64 = 100.0;

/// A number of cells or steps, rounded down; 0 for what is below.
#[expect(
    clippy::cast_sign_loss,
    reason = "a conversion of floats saturates, and below 0 becomes 0 as said"
)]
pub const fn whole(number: f64) -> u32 {
    number as u32
}
