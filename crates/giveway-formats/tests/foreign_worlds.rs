//! Files of other planners that hold worlds of their own: asprilo, the League of
//! Robot Runners, mapfw and libMultiRobotPlanning.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test stops at the first surprise"
)]

#[path = "foreign/asprilo.rs"]
mod asprilo;
#[path = "foreign/league.rs"]
mod league;
#[path = "foreign/left_out.rs"]
mod left_out;
#[path = "foreign/mapfw.rs"]
mod mapfw;
#[path = "foreign/multi_robot.rs"]
mod multi_robot;
#[path = "foreign/support.rs"]
mod support;
