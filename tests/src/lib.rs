//! What the tests share: the oracle, random instances, pictures of maps, and the
//! ways to ask the solver and to compare what it answers.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

pub mod alone;
pub mod answers;
pub mod ask;
pub mod bottleneck_random;
pub mod certified;
pub mod code_map;
pub mod compare;
pub mod environment;
pub mod facts;
pub mod forge;
pub mod formula;
pub mod freedom;
pub mod going_on;
pub mod known;
pub mod languages;
pub mod loiter;
pub mod oracle;
pub mod picture;
pub mod questions;
pub mod random;
pub mod recount;
pub mod rules_oracle;
pub mod rules_random;
pub mod source;
pub mod textbook;
pub mod traced;
pub mod truth;
pub mod upheaval;
pub mod wrong;
