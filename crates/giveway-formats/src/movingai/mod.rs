//! The standard benchmark's files: a `.map` with the cells, a `.scen` with the
//! agents, one a line (Sturtevant 2012; Stern et al. 2019).
//!
//! A map is 4-connected here. It gives its height before its width, a scenario
//! its width before its height. Lines may end in CR LF, and the last may lack
//! its end.

mod map;
mod scenario;
mod scene;
mod write;

pub use super::loss::Loss;
pub use map::{is_map, read_map};
pub use scenario::{Route, Scenario, is_scenario, read_scenario};
pub use scene::to_scene;
pub use write::{losses, write_map, write_scenario};
