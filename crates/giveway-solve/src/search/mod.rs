//! The search for the best plan, and the proof that it is.
//!
//! - [`team`]: agents inside the SAT solver, and those that need no place there;
//! - [`growing`]: calls in which MDDs grow as cores name their deadlines;
//! - [`stage`]: one cost at a time, in the order of the objective: core-guided
//!   ([`oll`]) for sums ([`sum`]), step by step for the makespan ([`makespan`]);
//! - [`feasible`]: any plan at all, or the proof that there is none;
//! - [`mod@closest`]: of the best plans one that is close to a given one;
//! - [`incumbent`]: the best plan so far;
//! - [`aim`]: what is asked for and answered;
//! - [`minima`]: what agents need alone; [`counting`]: what many need at a bottleneck;
//!   [`bound`]: lower bounds, raised by cores;
//! - [`lexicographic`]: all of it in order; [`prove`]: the part after a first plan;
//! - [`claim`]: what is proved, and what is under way;
//! - [`earlier`]: optima of an earlier search;
//! - [`deadlines`]: the latest arrivals that are looked at, and why;
//! - [`latest`]: the latest arrivals that a proof leaves;
//! - [`mod@horizon`]: the makespan beyond which nothing is looked for;
//! - [`for_ever`]: claims that hold whatever the horizon.

mod aim;
mod bound;
mod claim;
mod closest;
mod counting;
mod deadlines;
mod earlier;
mod feasible;
mod for_ever;
mod growing;
mod horizon;
mod incumbent;
mod latest;
mod lexicographic;
mod makespan;
mod minima;
mod oll;
mod prove;
mod stage;
mod sum;
mod tally;
mod team;
#[cfg(test)]
mod tests;

pub(crate) use aim::{Aim, Bounded, Contact, Verdict};
pub(crate) use closest::{ClosestEnd, ClosestInput, Extent, GivenWalk, closest};
pub(crate) use earlier::EarlierOptima;
pub(crate) use for_ever::{ForEver, NoPlan, Proved, reach_of_best_plans, reach_of_bounds};
pub(crate) use horizon::Horizon;
pub(crate) use incumbent::free_of_collisions;
pub(crate) use latest::LatestArrivals;
pub(crate) use lexicographic::{find, find_from, solve};
pub(crate) use minima::{LoneBound, Minima};
pub(crate) use team::Team;
