//! The playground: a page that paints, solves and plays.
//!
//! So far only what needs no page: pure functions from plans to what is shown.

pub mod playback;
