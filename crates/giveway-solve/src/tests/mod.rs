//! What several tests share: pictures, random instances, and the rules for one agent
//! written down a second time, which are those of the planners' tests.

#[path = "../../../giveway-planners/src/tests/lone.rs"]
#[expect(dead_code, reason = "tables are tested where they are, by all of it")]
mod lone;
#[path = "../../../giveway-planners/src/tests/picture.rs"]
mod picture;
#[path = "../../../giveway-planners/src/tests/random.rs"]
mod random;
mod start;

pub(crate) use lone::{Lone, Spot, State};
pub(crate) use picture::instance;
pub(crate) use random::random;
