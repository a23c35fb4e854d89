//! Files of other planners: recognised by their content, combined with each other, and read by
//! the convention that fits.
//!
//! ```text
//!   text ──recognise──▶ Held ──combine──▶ Scene, ForeignPlan (conventions, why, what it claims)
//! ```
//!
//! A reader (one file each) knows its own grammar only and decides nothing: it
//! gives a [`WrittenPlan`] as it is written, and says which [`Conventions`] its
//! format documents. `place` turns that into cells under some conventions,
//! `decide` tries them and says why one was taken, and [`combine()`] makes one scene
//! with its plans of several files. Nothing here reads a disk.

mod asprilo;
mod class_project;
mod clingo;
mod combine;
mod conventions;
pub mod convert;
mod cursor;
mod decide;
mod events;
mod format;
mod grid;
mod league;
mod limits;
mod lines;
pub mod link;
mod loss;
mod mapfw;
mod marks;
mod matching;
pub mod movingai;
mod multi_robot;
mod paths;
pub mod pgm;
mod place;
mod recognise;
mod remarks;
mod result;
mod shapes;
mod tracker;
mod unknown_format;
mod unknown_keys;
mod whole_steps;
mod write;
mod written;
mod written_at;
mod yaml;

pub use combine::{Combined, ForeignPlan, Missing, Options, Refused, combine};
pub use conventions::{CellOrder, Conventions, Origin, Up};
pub use decide::Alternative;
pub use format::Format;
pub use league::Problem as LeagueProblem;
pub use limits::{MAX_STEPS, MAX_TEXT_BYTES};
pub use loss::{Loss, Part, losses};
pub use place::{Fit, Heading};
pub use recognise::{Held, Source, read, recognise};
pub use remarks::{OpenGoals, Orders, Remarks};
pub use write::{Written, write};
pub use written::{Action, Handling, Move, Pair, Walk, WrittenAgent, WrittenPlan};
pub use written_at::{WrittenAt, WrittenCell};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
