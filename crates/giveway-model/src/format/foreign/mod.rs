//! Files of other people's planners: told apart by what they hold, matched to
//! each other, and read by the convention that fits.
//!
//! ```text
//!   text ──recognise──▶ Held ──gather──▶ Scene, ForeignPlan (conventions, why, what it claims)
//! ```
//!
//! A reader (one file each) knows its own grammar only and decides nothing: it
//! gives a [`WrittenPlan`] as it is written, and says which [`Conventions`] its
//! format documents. `place` turns that into cells under some conventions,
//! `decide` tries them and says why one was taken, and [`gather()`] brings files
//! together. Nothing here reads a disk.

mod asprilo;
mod conventions;
mod cursor;
mod decide;
mod format;
mod gather;
mod league;
mod limits;
mod mapfw;
mod multi_robot;
mod paths;
mod place;
mod recognise;
mod result;
mod tracker;
mod whole_steps;
mod write;
mod written;
mod written_at;
mod yaml;

pub use conventions::{CellOrder, Conventions, Origin, Up};
pub use decide::Alternative;
pub use format::Format;
pub use gather::{ForeignPlan, Gathered, Missing, Options, Refused, gather};
pub use limits::{MAX_STEPS, MAX_TEXT_BYTES};
pub use place::{Fit, Heading};
pub use recognise::{Held, Source, read, recognise};
pub use write::{Written, write};
pub use written::{Action, Claimed, Move, Pair, Walk, WrittenAgent, WrittenPlan};
pub use written_at::{WrittenAt, WrittenCell};
