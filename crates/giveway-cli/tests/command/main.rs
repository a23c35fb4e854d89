//! The command as a person meets it: what it is given, what it says, and how
//! it ends.
#![allow(
    clippy::unwrap_used,
    clippy::needless_raw_string_hashes,
    reason = "a test may panic, and UPDATE_EXPECT=1 writes expected texts so"
)]

mod audit;
mod audit_many;
mod bad_command_line;
mod bad_input;
mod benchmark_files;
mod brought;
mod change;
mod check;
mod compare;
mod convert;
mod delays;
mod explain;
mod foreign;
mod freedom;
mod grade;
mod harmless_input;
#[cfg(unix)]
mod interrupt;
mod left_out;
mod manual;
mod order;
mod picture;
mod planners;
mod price;
mod proof;
mod readme;
mod reasons;
mod report;
mod run;
mod sizing;
mod solve;
mod sweep;
#[cfg(unix)]
mod sweep_planners;
mod told;
mod traces;
