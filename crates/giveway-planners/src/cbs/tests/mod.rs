//! Constraint trees worked out by hand, and walks that keep rules.

mod hand;
mod low_level;
mod told;

use crate::{budget::Unlimited, problem::Problem, tests::instance};

/// The problem of a picture.
fn problem(picture: &str) -> Problem {
    Problem::new(&instance(picture), &Unlimited::default())
        .ok()
        .unwrap()
}
