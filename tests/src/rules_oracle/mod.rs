//! The oracle of rules of a scene's own: all joint states, written from the table of the
//! rules and sharing nothing with solver or judge.
//!
//! A scene is read from its JSON, so that not even the reader is shared. The search is
//! Dijkstra's over joint states; each agent's own state has all that its rules need to
//! remember. Times after the last one that a rule names are alike, so an answer without a
//! horizon holds for every horizon.

mod agent;
mod arrival;
mod changed;
mod every;
mod minds;
mod scene;
mod search;
mod steps;
mod together;

pub use changed::ChangedRules;
pub use every::{AllBest, all_best};
pub use scene::RuleScene;
pub use search::{Answer, best};
