//! A plan by a planner of the textbook, asked through the same door as the search
//! for the best one, and passed by the same judge.

mod answer;
mod by_hand;
mod request;
mod serve;
mod teller;
#[cfg(test)]
mod tests;
mod trace;
pub mod words;

pub use answer::{Lack, PlanAnswer, PlanEnd, PlanStats, StuckAgent};
pub use by_hand::{
    ByHand, ConflictChoice, HandSplit, NodeChoices, SplitMade, ToldBranch, UnmadeSplit,
};
pub use giveway_planners::cbs::by_hand::MOST_SPLITS;
pub use giveway_planners::planner::Planner;
pub use request::PlanRequest;
pub(crate) use serve::serve;
pub use trace::{
    Inherited, LacamEvent, LnsImprovement, NodeFate, OrderTried, PlanTrace, PlannedAgent,
    ToldConflict, ToldConstraint, TreeNode, Went,
};
