//! Tests of the search from within; those of its phases as a whole are in
//! `tests/tests/phases.rs`.

mod claims;
mod oll;
mod second_solver;
