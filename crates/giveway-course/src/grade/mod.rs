//! A class's hand-ins, each judged anew against the lessons that the lecturer has.
//!
//! [`Class`] is a pure machine: files are added, [`Class::step`] says what the solver must
//! be asked, and [`Class::answered`] takes its answers. What a file claims is never believed
//! and never a reason; it stands beside the [`Judgement`]. Work is limited by what the
//! solver does, not by seconds, so that the same files get the same judgements anywhere.
//!
//! - [`Came`]: files and links as a page gets them;
//! - [`Filed`], [`Unread`]: a file, and why it is none of this class;
//! - [`Row`], [`Share`], [`Wrong`]: the table, and what it says of each task;
//! - [`Looking`]: which of it is looked at, the board of a student's work, and what is given back;
//! - [`csv`], [`Report`]: the same for spreadsheets and programs.

mod answers;
mod back;
mod came;
mod claim;
mod class;
pub mod csv;
mod filed;
mod given;
mod judgement;
mod limits;
mod looking;
mod report;
mod rows;
mod shares;
mod task;

pub use came::Came;
pub use claim::Claim;
pub use class::Class;
pub use filed::{Filed, Unread};
pub use given::{Given, Next, Progress};
pub use judgement::{Judgement, Reason};
pub use limits::FIRST_WORK;
pub use looking::{Chosen, LookAction, LookedAt, Looking};
pub use report::Report;
pub use rows::{Order, Row};
pub use shares::{Share, Wrong};
pub use task::Graded;
