//! What several tests share: pictures, random instances, and the rules for one
//! agent written down a second time.

mod lone;
mod picture;
mod plain;
mod random;

pub(crate) use lone::{Lone, Spot, State};
pub(crate) use picture::instance;
pub(crate) use plain::{least_loss, plain};
pub(crate) use random::random;
