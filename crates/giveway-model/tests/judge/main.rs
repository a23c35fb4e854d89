//! Every edge case that the problem names, each with its own small map.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

mod arrival;
mod batteries;
mod collisions;
mod costs;
mod moves;
mod picture;
mod robust;
mod shapes;
mod slow_edges;
